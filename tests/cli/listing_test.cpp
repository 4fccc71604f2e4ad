#include "cli/listing.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/shader_counts.h"

namespace ink::cli {
namespace {

using testing::HasSubstr;

TEST(ListingOfSkips, HasALineForEach) {
    const std::string text = listing("skips");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 9);
    EXPECT_THAT(text, HasSubstr("  occlusion_culling  triangles  Triangles behind"));
    EXPECT_THAT(listing("all"), HasSubstr(text));
}

TEST(ListingOfMethods, CountsAShaderWhereThereIsOne) {
    const auto json = shader_json("surface8");
    ASSERT_EQ(json.size(), 2U);
    const auto& counts = json.at("RDNA2");
    const std::string text = listing("methods");
    EXPECT_THAT(text,
                HasSubstr("shader: " + counts.at("vertex").dump() + "/" +
                          counts.at("fragment").dump() + "/" + counts.at("pixel").dump() +
                          " instructions of vertex/fragment/pixel on RDNA2, "));
    EXPECT_GT(counts.at("vertex"), counts.at("pixel"));
    EXPECT_GT(counts.at("pixel"), counts.at("fragment"));
    EXPECT_TRUE(shader_json("edge_list").is_null());
    EXPECT_EQ(shader_text("edge_list"), "");
}

}  // namespace
}  // namespace ink::cli
