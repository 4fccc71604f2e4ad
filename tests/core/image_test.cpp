#include "core/image.h"

#include <gtest/gtest.h>

namespace ink::core {
namespace {

TEST(Image, StartsAtTopLeftAndRunsRowByRow) {
    Image<int> image(3, 2, 7);
    image.at(2, 1) = 9;
    EXPECT_EQ(image.data()[5], 9);
    EXPECT_EQ(image.row(1)[2], 9);
    EXPECT_EQ(image.at(0, 0), 7);
}

TEST(Image, ViewWritesThroughAndConstViewReads) {
    Image<int> image(4, 4);
    const ImageView<int> view = image.view();
    view.at(1, 3) = 5;
    const ImageView<const int> read = view;
    EXPECT_EQ(read.at(1, 3), 5);
    EXPECT_EQ(image.at(1, 3), 5);
}

TEST(Image, EmptyImageContainsNothing) {
    const Image<int> image;
    EXPECT_TRUE(image.is_empty());
    EXPECT_FALSE(image.contains(0, 0));
}

}  // namespace
}  // namespace ink::core
