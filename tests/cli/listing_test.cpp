#include "cli/listing.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace ink::cli {
namespace {

using testing::HasSubstr;

TEST(ListingOfSkips, HasALineForEach) {
    const std::string text = listing("skips");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 9);
    EXPECT_THAT(text, HasSubstr("  occlusion_culling  triangles  Triangles behind"));
    EXPECT_THAT(listing("all"), HasSubstr(text));
}

}  // namespace
}  // namespace ink::cli
