#include <gmock/gmock.h>

#include <set>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

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
