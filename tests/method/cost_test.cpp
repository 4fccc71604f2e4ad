#include "method/cost.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/whole_file.h"
#include "methods/registry.h"

namespace ink::method {
namespace {

Cost cost_of(const std::string& method, const core::ParamValues& settings = {}) {
    return methods::find_method(method).make(settings)->cost();
}

void expect_bytes(const PixelBytes& bytes, double read, double written) {
    EXPECT_EQ(bytes.read, read);
    EXPECT_EQ(bytes.written, written);
}

TEST(DeclaredCost, FollowsTheSettings) {
    const Cost separate = cost_of("mote2", {{"combine", "separate"}});
    EXPECT_EQ(separate.interpolants, 2);
    expect_bytes(separate.fill, 4, 4 + 2);
    expect_bytes(separate.filter, 2 + 1, 2);

    // Four floats are filled.
    const Cost pixel = cost_of("mote4", {{"packing", "pixel"}});
    EXPECT_EQ(pixel.interpolants, 4);
    expect_bytes(pixel.fill, 4, 4 + 16);
    expect_bytes(pixel.filter, 16 + 1, 1 + 1);

    expect_bytes(cost_of("mote4", {{"fatten", "true"}}).filter, 2, 2);
    expect_bytes(cost_of("mote4", {{"depth_format", "z16"}}).fill, 2, 2 + 1);
    expect_bytes(cost_of("mote4", {{"depth_format", "z24"}}).fill, 3, 3 + 1);
    EXPECT_FALSE(cost_of("mote4", {{"normals", "facet"}}).shares_vertices);

    // Two fields are taken out of 16 bits.
    expect_bytes(cost_of("mote16", {{"layout", "8+8"}}).filter, 2 * (2 + 2) + 1, 2 * (1 + 2));

    EXPECT_EQ(cost_of("ids", {{"side", "both"}}).filter.read, 4);
    // |n.v| is made from the normal.
    EXPECT_EQ(cost_of("roberts", {{"guard", "none"}}).filter.read + 12,
              cost_of("roberts").filter.read);

    // An encoding of its own is a float read and written.
    expect_bytes(cost_of("decaudin", {{"depth_encoding", "linear"}}).filter, 32 + 4, 17 + 4);
}

TEST(DeclaredCost, OfJumpFloodGrowsByAPassWithEveryDoublingOfTheWidth) {
    const auto bytes = [](const char* width_px) {
        return cost_of("jump_flood", {{"width_px", width_px}}).filter;
    };
    // Four bytes read and written. Steps 1; 2, 1; 4, 2, 1.
    for (const auto& [wide, narrow] : {std::pair{"4", "2"}, {"8", "4"}, {"16", "8"}}) {
        EXPECT_EQ(bytes(wide).read - bytes(narrow).read, 4);
        EXPECT_EQ(bytes(wide).written - bytes(narrow).written, 4);
    }
}

TEST(DeclaredCost, IsThereForEveryMethodAndAllItsSettings) {
    for (const MethodInfo& info : methods::registry()) {
        std::vector<core::ParamValues> settings = info.sweep;
        settings.emplace_back();
        for (const core::ParamValues& values : settings) {
            const auto method = info.make(values);
            const Cost cost = method->cost();
            EXPECT_GE(cost.passes, 1) << info.name;
            EXPECT_EQ(cost.buffer_bytes_per_px, method->bytes_per_px()) << info.name;
            EXPECT_GT(cost.fill.written, 0) << info.name;
            EXPECT_GE(cost.filter.written, 1) << info.name << ": it writes an edge response";
        }
    }
}

TEST(DeclaredCost, StandsOnEveryMethodsPage) {
    const std::string begin = "<!-- cost -->\n";
    for (const MethodInfo& info : methods::registry()) {
        const std::string path = INK_SOURCE_DIR "/methods/" + info.name + "/" + info.name + ".md";
        const std::string page = core::read_whole_file(path).value_or("");
        const std::size_t first = page.find(begin);
        ASSERT_NE(first, std::string::npos) << info.name;
        const std::size_t start = first + begin.size();
        EXPECT_EQ(page.substr(start, page.find("<!-- /cost -->") - start),
                  cost_sentence(info.make({})->cost()) + "\n")
            << "put this between the markers of methods/" << info.name << "/" << info.name << ".md";
    }
}

TEST(CostSentence, SaysWhatIsDeclaredOrThatNothingIs) {
    EXPECT_EQ(cost_sentence({}), "not declared");
    EXPECT_EQ(cost_sentence(cost_of("mote4")),
              "1 pass, 1 interpolant; a covered pixel 9 bytes, a pixel 7");
}

}  // namespace
}  // namespace ink::method
