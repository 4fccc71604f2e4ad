#include "core/hash.h"

#include <gtest/gtest.h>

namespace ink::core {
namespace {

TEST(Hasher, LengthIsPartOfText) {
    EXPECT_NE(Hasher().text("ab").text("c").result(), Hasher().text("a").text("bc").result());
}

TEST(Hasher, IsTheLibrarysHashAndDoesNotChangeBetweenVersions) {
    EXPECT_EQ(Hasher().bytes("inkbench", 8).hex(), "a9f1d0d630dd1937");
    EXPECT_EQ(Hasher().text("inkbench").hex(), "a0ff62361b75e74a");
}

TEST(ImageHash, TellsSizeFromContent) {
    EXPECT_NE(image_hash(Image<int>(2, 3)), image_hash(Image<int>(3, 2)));
}

}  // namespace
}  // namespace ink::core
