// One case in full, small enough to stand here: what the independent scorer in Python makes of it.

#include <gtest/gtest.h>

#include <array>
#include <ostream>

#include "score/score.h"
#include "tests/score/images.h"

namespace {

using ink::score::prepare_truth;
using ink::score::ScoreOptions;

Image truth_labels() {
    return image_of({"................................",
                     "........................7777777.",
                     "........1111....................",
                     "......11....11................3.",
                     ".....1........1.............33..",
                     "....1..........1...........3....",
                     "....1..........1..........3.....",
                     "...1............1.......33......",
                     "...1............1...222222222...",
                     "...1............1...233.....2...",
                     "...1............1...2.......2...",
                     "....1..........1...32.......2...",
                     "....1..........1.33.2.......2...",
                     ".....1........1.3...2.......2...",
                     "......11....11.3....2.......2...",
                     "........1111.33.....222222222...",
                     "............3...................",
                     "................................"});
}

/// A circle off by one and 2 px wide, weaker lines, a ghost and some dust; edge responses are 28 a
/// digit.
Image drawn() {
    return image_of({"....1..89....................1.7",
                     "................2...............",
                     ".........9999.........77477777..",
                     ".......9999999993...............",
                     ".82...399....999...........34.5.",
                     "7....99........99..19.......55..",
                     ".....99.....2..99..........5....",
                     "....99..9.....1.99.....7..5.....",
                     "....99..........99......55......",
                     "....99.6.......599..336433323...",
                     "....99..........99..355.....3...",
                     ".....99.....8..99...3.......3...",
                     "....899........99..53..1....3...",
                     "......999...5999.55.5.......3...",
                     ".......99999699.5.6.3....6..3...",
                     ".........9999..5....3.......3...",
                     ".....6.......55.....3333233328..",
                     "......9.....5..................."},
                    28);
}

/// The thresholds at which the curve changes.
constexpr std::array<std::size_t, 10> kSteps = {1, 11, 22, 33, 44, 55, 66, 77, 88, 99};

struct Expected {
    const char* name;
    ScoreOptions options;  ///< threshold 128
    std::int64_t n_truth;
    std::array<std::int64_t, 10> k;       ///< of the curve from each step on
    std::array<std::int64_t, 10> n_pred;  ///< the same
    double ap;
    std::int64_t drawn_in_reach;
    std::int64_t truth_in_reach;
    std::vector<std::pair<std::int64_t, std::int64_t>> classes;  ///< k, n_truth
};

void PrintTo(const Expected& e, std::ostream* out) {
    *out << e.name;
}

class SmallCase : public testing::TestWithParam<Expected> {};

TEST_P(SmallCase, Agrees) {
    const Expected& e = GetParam();
    const auto truth = prepare_truth(truth_labels(), e.options, false);
    const auto curve = ink::score::score_curve(drawn(), truth, e.options);
    std::size_t step = 0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        if (step + 1 < kSteps.size() && kSteps[step + 1] == i + 1) ++step;
        EXPECT_EQ(curve[i].k, e.k[step]) << "threshold " << i + 1;
        EXPECT_EQ(curve[i].n_pred, e.n_pred[step]) << "threshold " << i + 1;
        EXPECT_EQ(curve[i].n_truth, e.n_truth) << "threshold " << i + 1;
    }
    EXPECT_NEAR(ink::score::average_precision(curve), e.ap, 1e-9);

    const auto s = ink::score::score(drawn(), truth, e.options);
    EXPECT_EQ(s.k, curve[49].k);  // 128 of 255 is the edge response at 50 percent
    EXPECT_EQ(s.n_pred - s.false_positives, e.drawn_in_reach);
    EXPECT_EQ(s.n_truth - s.false_negatives, e.truth_in_reach);
    ASSERT_EQ(s.classes.size(), e.classes.size());
    for (std::size_t i = 0; i < s.classes.size(); ++i) {
        EXPECT_EQ(s.classes[i].k, e.classes[i].first) << "class " << s.classes[i].label;
        EXPECT_EQ(s.classes[i].n_truth, e.classes[i].second) << "class " << s.classes[i].label;
    }
}

const Expected kCases[] = {{"OnePixel",
                            {.tolerance_px = 1},
                            90,
                            {81, 81, 79, 61, 58, 41, 39, 33, 32, 0},
                            {108, 103, 98, 78, 75, 57, 52, 42, 37, 0},
                            0.7459582923521897,
                            59,
                            65,
                            {{33, 36}, {9, 30}, {17, 17}, {5, 7}}},
                           {"TwoPixels",
                            {.tolerance_px = 2},
                            90,
                            {86, 86, 85, 67, 65, 47, 44, 36, 34, 0},
                            {108, 103, 98, 78, 75, 57, 52, 42, 37, 0},
                            0.847920984190055,
                            65,
                            78,
                            {{36, 36}, {13, 30}, {17, 17}, {7, 7}}},
                           {"Unthinned",
                            {.tolerance_px = 2, .thin = false},
                            90,
                            {90, 90, 90, 69, 67, 55, 52, 44, 43, 0},
                            {153, 148, 142, 115, 112, 92, 86, 76, 71, 0},
                            0.6338028169014085,
                            102,
                            78,
                            {{36, 36}, {14, 30}, {17, 17}, {7, 7}}},
                           {"Ignore",
                            {.tolerance_px = 2, .ignore_label = 7},
                            83,
                            {79, 79, 78, 60, 59, 42, 39, 36, 34, 0},
                            {101, 97, 92, 72, 70, 52, 47, 42, 37, 0},
                            0.8359115373420916,
                            60,
                            71,
                            {{36, 36}, {13, 30}, {17, 17}}},
                           {"OneAndAHalfPixelsIgnore",
                            {.tolerance_px = 1.5, .ignore_label = 7},
                            83,
                            {77, 77, 76, 58, 57, 39, 37, 35, 33, 0},
                            {100, 96, 91, 71, 69, 51, 46, 42, 37, 0},
                            0.7969470322632974,
                            57,
                            70,
                            {{35, 36}, {10, 30}, {17, 17}}}};

INSTANTIATE_TEST_SUITE_P(Score, SmallCase, testing::ValuesIn(kCases), [](const auto& value) {
    return std::string(value.param.name);
});

}  // namespace
