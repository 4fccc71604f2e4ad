#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

TEST(CompareCancellation, WritesCountsOfMethodsThatDeclareACodeAndTheSection) {
    const Desk desk;
    expect_done(desk,
                "compare --scenes cube --methods mote4,ids --size 160x90 --repetitions 1 "
                "--no-sweep --no-crosscheck --out out");
    std::set<std::string> classes;
    for (const auto& line : table_of_run(desk, "out", "cancellation.csv")) {
        EXPECT_EQ(line.at("method"), "mote4") << "ids declares no code";
        EXPECT_EQ(line.at("scene"), "cube");
        EXPECT_EQ(line.at("dihedral_low_deg"), "90") << "a cube has no other angle";
        classes.insert(line.at("class"));
        const int n_truth = std::stoi(line.at("n_truth"));
        const int predicted = std::stoi(line.at("predicted_missed"));
        const int measured = std::stoi(line.at("measured_missed"));
        EXPECT_LE(predicted, n_truth);
        EXPECT_LE(std::abs(predicted - measured), 1 + n_truth / 50) << "two points, or a pixel";
        EXPECT_LE(std::stoi(line.at("both_false_negatives")),
                  std::stoi(line.at("measured_false_negatives")));
        EXPECT_LE(std::stoi(line.at("measured_false_negatives")), measured);
    }
    EXPECT_EQ(classes, (std::set<std::string>{"contour", "crease"}));
    EXPECT_EQ(page_table(desk, "out", "cancellation.csv")["lines"],
              parse_csv(desk.read("out/cancellation.csv")).size());
}

}  // namespace
}  // namespace ink::program
