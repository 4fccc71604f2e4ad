#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(CompareScaling, WritesAFileAndTheSectionAndOnlyIfAsked) {
    const Desk desk;
    std::vector<std::string> words = {"compare", "--scenes", "cube", "--methods", "mote2"};
    words.insert(words.end(), {"--size", "64x36", "--repetitions", "1", "--out", "out"});
    words.emplace_back("--scaling");
    ASSERT_EQ(desk.run(words).exit_code, 0);
    std::map<std::string, std::set<double>> places;
    for (const auto& line : parse_csv(desk.read("out/scaling.csv"))) {
        EXPECT_EQ(line.at("method"), "mote2");
        EXPECT_GT(std::stoll(line.at("draw_ns_min")), 0);
        places[line.at("axis")].insert(std::stod(line.at("x")));
    }
    ASSERT_EQ(places.size(), 3U);
    for (const auto& [axis, x] : places)
        EXPECT_GE(x.size(), 5U) << axis;
    EXPECT_EQ(*places["pixels"].begin(), 640 * 480);
    EXPECT_EQ(*places["pixels"].rbegin(), 7680 * 4320);
    EXPECT_LT(*places["triangles"].begin(), 200);
    EXPECT_GE(*places["triangles"].rbegin(), 1e6);
    const std::string page = desk.read("out/report.html");
    EXPECT_THAT(page, HasSubstr("Time of a frame against triangles of the sphere"));
    EXPECT_THAT(page, HasSubstr("han linear"));  // no step worse than, or worse than

    words.pop_back();
    ASSERT_EQ(desk.run(words).exit_code, 0);
    EXPECT_EQ(desk.read("out/scaling.csv"), "") << "an older one must not pass for this run's";
    EXPECT_THAT(desk.read("out/report.html"), Not(HasSubstr("Time of a frame against")));
}

TEST(CompareCost, IsPredictedForMethodsAndEmptyForBrackets) {
    const Desk desk;
    ASSERT_EQ(desk.run({"compare",
                        "--scenes",
                        "cube,torus",
                        "--size",
                        "64x36",
                        "--repetitions",
                        "1",
                        "--out",
                        "out"})
                  .exit_code,
              0);
    int predicted = 0;
    for (const char* file : {"out/rows.csv", "out/sweep.csv"}) {
        for (const auto& row : parse_csv(desk.read(file))) {
            const std::string& method = row.at("method");
            const bool is_bracket = method == "none" || method == "sampled" || method == "oracle";
            EXPECT_EQ(row.at("predicted_ns").empty(), is_bracket) << method;
            EXPECT_EQ(row.at("cost_residual").empty(), is_bracket) << method;
            predicted += is_bracket ? 0 : 1;
        }
    }
    EXPECT_GT(predicted, 0);
    EXPECT_THAT(desk.read("out/report.html"), HasSubstr("<section id=\"cost\">"));
}

}  // namespace
}  // namespace ink::program
