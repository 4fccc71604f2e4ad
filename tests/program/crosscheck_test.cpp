#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/program/run_program.h"

// What a user sees of the cross-check, and of views that are too large to be traced.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// `n` triangles so thin that each is two lines across the image, apart from each other. At
/// 640 x 360 six thousand of them have more lines than the samples of one truth suffice for.
std::string needles(int n) {
    std::string obj;
    for (int i = 0; i < n; ++i) {
        const double y = 0.5 * i / n;
        obj += fmt::format(
            "v 0 {0:.6f} 0\nv 1 {0:.6f} 0\nv 1 {1:.6f} 0\nf -3 -2 -1\n", y, y + 0.2 / n);
    }
    return obj;
}

TEST(SampledLines, TruthPrintsItsTableAndWritesTheImageOfDisagreements) {
    const Desk desk;
    EXPECT_THAT(expect_done(desk, "truth cube --size 160x90 --crosscheck"),
                AllOf(HasSubstr("cross-check px"),
                      HasSubstr("disagreement 0.0"),
                      HasSubstr("disagreements: inkbench-out/crosscheck/cube_front.png\n")));
    EXPECT_THAT(desk.read("inkbench-out/crosscheck/cube_front.png"), StartsWith("\x89PNG"));

    const Desk other;
    EXPECT_THAT(
        expect_done(other, "truth cube --size 160x90 --crosscheck --disagreement apart.png"),
        HasSubstr("disagreements: apart.png\n"));
    EXPECT_THAT(other.read("apart.png"), StartsWith("\x89PNG"));
    EXPECT_EQ(other.inventory().size(), 1U) << "and no folder of its own";
}

TEST(SampledLines, ABadPlaceForTheImageIsRefused) {
    const Desk desk;
    refusal(desk, "truth cube --size 64x36 --disagreement x.txt --crosscheck");
    // There is nothing to disagree without a cross-check.
    refusal(desk, "truth cube --size 64x36 --disagreement x.png");
    desk.write("inkbench-out", "a file where the folder would be");
    EXPECT_THAT(refusal(desk, "truth cube --size 64x36 --crosscheck"),
                HasSubstr("inkbench-out/crosscheck"));
}

TEST(SampledLines, CompareRecordsItUnlessToldNotTo) {
    const Desk desk;
    const Words words =
        "compare --scenes cube --methods mote4 --size 160x90 --views 1 --repetitions 1 --out out";
    expect_done(desk, words);
    EXPECT_EQ(rows_of(desk).size(), 5U);
    for (const auto& row : rows_of(desk))
        EXPECT_LT(std::stod(row.at("reference_disagreement")), 0.001);
    expect_done(desk, words + "--no-crosscheck --force");
    EXPECT_EQ(rows_of(desk).size(), 5U);
    for (const auto& row : rows_of(desk))
        EXPECT_EQ(row.at("reference_disagreement"), "");
}

TEST(TooLarge, IsSaidInTheRowAndTheRestGoesOn) {
    const Desk desk;
    desk.write("needles.obj", needles(6000));
    const auto before = desk.inventory();
    const Outcome truth = desk.run("truth needles.obj --size 640x360 --crosscheck -o truth.png");
    EXPECT_EQ(truth.exit_code, 1);
    EXPECT_EQ(truth.out, "");
    EXPECT_EQ(truth.err,
              "inkbench: needles: too_large: 18000 lines need more than 64000000 samples or "
              "40000000 rays; fewer objects, a simpler mesh or a smaller image would help\n");
    EXPECT_EQ(desk.inventory(), before);
    const Outcome outcome = desk.run(
        "compare needles.obj --scenes cube --methods mote4 --size 640x360 --views 1 --repetitions "
        "1 --out out");
    EXPECT_EQ(outcome.exit_code, 3) << "a view has no score";
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("no score: needles view0: too_large: 18000 lines"),
                      HasSubstr("try: a smaller --size")));
    int refused = 0, done = 0;
    for (const auto& row : rows_of(desk)) {
        if (row.at("scene") == "needles") {
            EXPECT_THAT(row.at("status"), StartsWith("too_large: 18000 lines need more than "));
            EXPECT_EQ(row.at("f_2px"), "");
            ++refused;
        } else {
            EXPECT_EQ(row.at("scene"), "cube");
            EXPECT_EQ(row.at("status"), "ok");
            EXPECT_NE(row.at("f_2px"), "");
            ++done;
        }
    }
    EXPECT_EQ(refused, 5) << "the method's and four baselines'";
    EXPECT_EQ(done, 5) << "the method's and four baselines'";
    EXPECT_THAT(desk.read("out/report.html"), HasSubstr("\"unscored.csv\":{\"lines\":1,"));
    const Table unscored = parse_csv(desk.read("out/unscored.csv"));
    ASSERT_EQ(unscored.size(), 1U);
    EXPECT_EQ(unscored[0].at("scene"), "needles");
    EXPECT_EQ(unscored[0].at("method"), "") << "the whole view";
    EXPECT_THAT(unscored[0].at("remedy"), StartsWith("a smaller --size"));
}

}  // namespace
}  // namespace ink::program
