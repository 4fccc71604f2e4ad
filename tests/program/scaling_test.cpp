#include <gmock/gmock.h>

#include <map>
#include <set>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

TEST(CompareScaling, WritesAFileAndTheSectionAndOnlyIfAsked) {
    const Desk desk;
    Words words = "compare --scenes cube --methods mote2 --size 64x36 --repetitions 1 --out out";
    words.emplace_back("--scaling");
    expect_done(desk, words);
    std::map<std::string, std::set<double>> places;
    for (const auto& row : rows_of_study(desk, "scaling")) {
        EXPECT_EQ(row.at("method"), "mote2");
        EXPECT_GT(std::stoll(row.at("draw_ns_min")), 0);
        EXPECT_EQ(row.at("f_2px"), "") << "it is not scored";
        places[row.at("axis")].insert(std::stod(row.at("value")));
    }
    ASSERT_EQ(places.size(), 3U);
    for (const auto& [axis, x] : places)
        EXPECT_GE(x.size(), 5U) << axis;
    EXPECT_EQ(*places["pixels"].begin(), 640 * 480);
    EXPECT_EQ(*places["pixels"].rbegin(), 7680 * 4320);
    EXPECT_LT(*places["triangles"].begin(), 200);
    EXPECT_GE(*places["triangles"].rbegin(), 1e6);
    EXPECT_EQ(page_table(desk, "out", "axes.csv")["lines"], 3);

    words.back() = "--force";
    expect_done(desk, words);
    EXPECT_TRUE(rows_of_study(desk, "scaling").empty());
    EXPECT_EQ(desk.read("out/axes.csv"), "") << "an older one must not pass for this run's";
    EXPECT_TRUE(page_table(desk, "out", "axes.csv").is_null());
}

TEST(CompareCost, IsPredictedForMethodsAndEmptyForBaselines) {
    const Desk desk;
    expect_done(desk, "compare --scenes cube,torus --size 64x36 --repetitions 1 --out out");
    std::set<std::string> methods;
    std::size_t cells = 0;
    for (const char* name : {"cost.csv", "sweep.csv"}) {
        for (const auto& line : table_of_run(desk, "out", name)) {
            EXPECT_GT(std::stod(line.at("frame_px")), 0) << line.at("method");
            methods.insert(line.at("method"));
            ++cells;
        }
    }
    const Table predictions = table_of_run(desk, "out", "predictions.csv");
    EXPECT_EQ(predictions.size(), cells) << "of every cell and setting";
    for (const auto& line : predictions) {
        EXPECT_NE(line.at("predicted_ns"), "") << line.at("method");
        EXPECT_NE(line.at("cost_residual"), "") << line.at("method");
    }
    EXPECT_GT(methods.size(), 10U);
    for (const char* baseline : {"none", "sampled", "exact_corner", "oracle"})
        EXPECT_FALSE(methods.contains(baseline)) << "it does no work";
    EXPECT_EQ(page_table(desk, "out", "cost_fit.csv")["lines"], 7) << "a price a kind of work";
}

}  // namespace
}  // namespace ink::program
