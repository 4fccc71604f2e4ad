#include "method/cost.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "methods/registry.h"

namespace ink::method {
namespace {

Cost cost_of(const std::string& method, const core::ParamValues& settings = {}) {
    return methods::find_method(method).make(settings)->cost();
}

void expect_work(const PixelWork& work, double read, double written, double operations) {
    EXPECT_EQ(work.bytes_read, read);
    EXPECT_EQ(work.bytes_written, written);
    EXPECT_EQ(work.operations, operations);
}

// A byte: coverage 6, depth 2, one plane stepped, shifted and clamped at both ends.
constexpr double kFillOneCode = 6 + 2 + 1 + 1 + 2;
// 4 m - u - d - l - r, its size, its low bits cleared, at most 255.
constexpr double kLaplacian = 5 + 1 + 1 + 1;

TEST(DeclaredCost, OfMote2AndMote4IsOneByteAndOneFilter) {
    for (const char* method : {"mote2", "mote4"}) {
        const Cost cost = cost_of(method);
        EXPECT_EQ(cost.passes, 1);
        EXPECT_EQ(cost.interpolants, 1);
        EXPECT_EQ(cost.values_per_vertex, 1);
        EXPECT_TRUE(cost.shares_vertices);
        EXPECT_EQ(cost.buffer_bytes_per_px, 4 + 1);
        expect_work(cost.fill, 4, 4 + 1, kFillOneCode);
        expect_work(cost.filter, 1, 1, kLaplacian);
    }
}

TEST(DeclaredCost, OfMote16IsAByteMoreAndAShift) {
    const Cost cost = cost_of("mote16");
    EXPECT_EQ(cost.interpolants, 1);
    EXPECT_EQ(cost.buffer_bytes_per_px, 4 + 2);
    expect_work(cost.fill, 4, 4 + 2, kFillOneCode);
    expect_work(cost.filter, 2, 1, kLaplacian + 1);
}

TEST(DeclaredCost, OfDecaudinIsFourFloatsAndTwoOperators) {
    const Cost cost = cost_of("decaudin");
    EXPECT_EQ(cost.passes, 1);
    EXPECT_EQ(cost.interpolants, 4);
    EXPECT_EQ(cost.values_per_vertex, 4);
    EXPECT_EQ(cost.buffer_bytes_per_px, 4 + 16);
    expect_work(cost.fill, 4, 4 + 16, 6 + 2 + 4);
    // g 25, p 12 and the join 1 for each channel; to a byte 4. g is written and read again.
    expect_work(cost.filter, 16 + 16, 16 + 1, 4 * (25 + 12 + 1) + 4);
}

TEST(DeclaredCost, FollowsTheSettings) {
    const Cost separate = cost_of("mote2", {{"combine", "separate"}});
    EXPECT_EQ(separate.interpolants, 2);
    expect_work(separate.fill, 4, 4 + 2, 6 + 2 + 2 * 4);
    expect_work(separate.filter, 2 + 1, 2, 2 * kLaplacian + 1);

    // Four floats are filled; at a pixel four products and sums, rounded, clamped at both ends.
    const Cost pixel = cost_of("mote4", {{"packing", "pixel"}});
    EXPECT_EQ(pixel.interpolants, 4);
    expect_work(pixel.fill, 4, 4 + 16, 6 + 2 + 4);
    expect_work(pixel.filter, 16 + 1, 1 + 1, 8 + 1 + 2 + kLaplacian);

    expect_work(cost_of("mote4", {{"fatten", "true"}}).filter, 2, 2, 12 + kLaplacian);
    expect_work(cost_of("mote4", {{"depth_format", "z16"}}).fill, 2, 2 + 1, kFillOneCode + 2);
    expect_work(cost_of("mote4", {{"depth_format", "z24"}}).fill, 3, 3 + 1, kFillOneCode + 2);
    expect_work(cost_of("mote4", {{"interpolation", "perspective"}}).fill,
                4,
                4 + 1,
                kFillOneCode + 1 + kSlowOperations);
    expect_work(cost_of("mote4", {{"overflow", "wrap"}}).fill, 4, 4 + 1, kFillOneCode - 1);
    expect_work(cost_of("mote4", {{"overflow", "wrap"}}).filter, 1, 1, kLaplacian + 2);
    EXPECT_FALSE(cost_of("mote4", {{"normals", "facet"}}).shares_vertices);

    // Two fields are taken out of 16 bits; the lower one is known modulo its size only.
    expect_work(cost_of("mote16", {{"layout", "8+8"}}).filter,
                2 * (2 + 2) + 1,
                2 * (1 + 2),
                2 * (kLaplacian + 1 + 2) + 2 + 1);

    EXPECT_EQ(cost_of("decaudin", {{"join", "length"}}).filter.operations,
              4 * (25 + 12 + 2) + 4 + kSlowOperations);
    // w from 1/w, then (far - w) scaled; a float read and written.
    expect_work(cost_of("decaudin", {{"depth_encoding", "linear"}}).filter,
                32 + 4,
                17 + 4,
                156 + 2 + kSlowOperations + 2);
}

TEST(DeclaredCost, OfIdsIsAConstantAndItsNeighbours) {
    const Cost cost = cost_of("ids");
    EXPECT_EQ(cost.interpolants, 0);
    EXPECT_EQ(cost.buffer_bytes_per_px, 4 + 4);
    expect_work(cost.fill, 4, 4 + 4, 6 + 2);
    expect_work(cost.filter, 4 + 4, 1, 4 + 3);
    EXPECT_EQ(cost_of("ids", {{"side", "both"}}).filter.bytes_read, 4);
}

TEST(DeclaredCost, OfJumpFloodGrowsByAPassWithEveryDoublingOfTheWidth) {
    const auto work = [](const char* width_px) {
        return cost_of("jump_flood", {{"width_px", width_px}}).filter;
    };
    // Nine seeds at seven operations; four bytes read and written. Steps 1; 2, 1; 4, 2, 1.
    EXPECT_EQ(work("4").operations - work("2").operations, 63);
    EXPECT_EQ(work("8").operations - work("4").operations, 63);
    EXPECT_EQ(work("16").operations - work("8").operations, 63);
    EXPECT_EQ(work("4").bytes_read - work("2").bytes_read, 4);
    EXPECT_EQ(work("4").bytes_written - work("2").bytes_written, 4);
}

TEST(DeclaredCost, OfTheCrossesIsFourFloatsAndOneFilter) {
    for (const char* method : {"roberts", "plane_distance"}) {
        const Cost cost = cost_of(method);
        EXPECT_EQ(cost.interpolants, 4);
        EXPECT_EQ(cost.buffer_bytes_per_px, 4 + 16);
        expect_work(cost.fill, 4, 4 + 16, 6 + 2 + 4);
    }
    // A root fewer a normal, a ramp's division more.
    EXPECT_EQ(cost_of("roberts", {{"guard", "none"}}).filter.operations + 29,
              cost_of("roberts").filter.operations);
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
            EXPECT_GT(cost.fill.operations, 0) << info.name;
        }
    }
}

TEST(DeclaredCost, StandsOnEveryMethodsPage) {
    const std::string begin = "<!-- cost -->\n";
    for (const MethodInfo& info : methods::registry()) {
        std::ifstream file(std::string(INK_SOURCE_DIR) + "/methods/" + info.name + "/" + info.name +
                           ".md");
        std::stringstream page;
        page << file.rdbuf();
        const std::size_t first = page.str().find(begin);
        ASSERT_NE(first, std::string::npos) << info.name;
        const std::size_t start = first + begin.size();
        EXPECT_EQ(page.str().substr(start, page.str().find("<!-- /cost -->") - start),
                  cost_table(info.make({})->cost()))
            << "put this between the markers of methods/" << info.name << "/" << info.name << ".md";
    }
}

TEST(CostSentence, SaysWhatIsDeclaredOrThatNothingIs) {
    EXPECT_EQ(cost_sentence({}), "not declared");
    EXPECT_EQ(cost_sentence(cost_of("mote4")),
              "1 pass, 1 interpolant; a covered pixel 9 bytes and 12 operations, a pixel 7 bytes "
              "and 8 operations");
}

}  // namespace
}  // namespace ink::method
