#include "summary/answer.h"

#include <gtest/gtest.h>

#include "summary/summary.h"

namespace ink::summary {
namespace {

MethodSummary method_of(const std::string& name, double f, double ms) {
    MethodSummary summary;
    summary.method = name;
    summary.f.all = f;
    if (ms > 0) summary.draw_ms = ms;
    return summary;
}

std::string name_of(const MethodSummary* summary) {
    return summary == nullptr ? "" : summary->method;
}

TEST(FindAnswer, IsTheCheapestWithinTheMarginOfTheBest) {
    const std::vector<MethodSummary> summaries = {method_of("rough", 0.90, 0.5),
                                                  method_of("good", 0.985, 1.6),
                                                  method_of("better", 0.99, 2.1),
                                                  method_of("exact", 0.995, 13)};
    const Answer answer = find_answer(summaries, {});
    EXPECT_EQ(name_of(answer.method), "good") << ".010 below counts";
    EXPECT_EQ(name_of(answer.most_exact), "exact");
    EXPECT_EQ(name_of(answer.next), "better");
    EXPECT_EQ(answer.other(), answer.most_exact);
    EXPECT_EQ(name_of(answer.fastest), "rough");
    EXPECT_EQ(place_in(answer, summaries[1]), "answer");
    EXPECT_EQ(place_in(answer, summaries[3]), "best");
    EXPECT_EQ(place_in(answer, summaries[0]), "");
    EXPECT_EQ(name_of(find_answer(summaries, {.f_margin = 0.001}).method), "exact");
    EXPECT_EQ(name_of(find_answer(summaries, {.f_margin = 0.1}).method), "rough");
}

TEST(FindAnswer, ABudgetCountsBeforeTheMargin) {
    const std::vector<MethodSummary> summaries = {method_of("rough", 0.90, 0.5),
                                                  method_of("good", 0.97, 1.6),
                                                  method_of("untimed", 1, 0),
                                                  method_of("exact", 0.995, 13)};
    const Answer within = find_answer(summaries, {.budget_ms = 2});
    EXPECT_EQ(name_of(within.method), "good");
    EXPECT_EQ(within.method, within.most_exact);
    EXPECT_EQ(name_of(within.other()), "rough");
    EXPECT_EQ(place_in(within, summaries[1]), "both");
    const Answer none = find_answer(summaries, {.budget_ms = 0.1});
    EXPECT_EQ(none.method, nullptr);
    EXPECT_EQ(name_of(none.fastest), "rough");
}

TEST(FindAnswer, IsTheMostExactWithoutTimesOfOurs) {
    std::vector<MethodSummary> summaries = {method_of("a", 0.99, 0), method_of("b", 0.995, 0)};
    EXPECT_EQ(name_of(find_answer(summaries, {}).method), "b");
    summaries[0].draw_ms = 1;
    EXPECT_EQ(name_of(find_answer(summaries, {}).method), "a");
    summaries[0].has_own_clock = true;
    EXPECT_EQ(name_of(find_answer(summaries, {}).method), "b") << "by another clock";
}

// "b" is the more exact, and "a" takes a millisecond.
TEST(FindAnswer, TakesTheMoreExactOfThoseThatAreAsCheap) {
    for (const double ms : {0.5, 0.9, 1.0, 1.15, 1.29, 1.31, 1.5}) {
        const std::vector<MethodSummary> summaries = {method_of("a", 0.99, 1),
                                                      method_of("b", 0.995, ms)};
        const Answer answer = find_answer(summaries, {});
        EXPECT_EQ(name_of(answer.method), ms < 1.3 ? "b" : "a") << ms;
    }
}

TEST(FindAnswer, SaysWhomAnotherRunMayName) {
    for (const double ms : {0.5, 1.0, 1.17, 1.19, 1.31, 1.42, 1.44, 2.0}) {
        const std::vector<MethodSummary> summaries = {
            method_of("a", 0.99, 1), method_of("b", 0.995, ms), method_of("c", 0.993, 9)};
        const Answer answer = find_answer(summaries, {});
        std::vector<std::string> others;
        for (const MethodSummary* s : answer.as_cheap)
            others.push_back(s->method);
        std::vector<std::string> expected;
        if (ms > 1.18 && ms < 1.43) expected.push_back(ms < 1.3 ? "a" : "b");
        EXPECT_EQ(others, expected) << ms;
    }
}

// `auto` has another method draw: with its images, and a hundredth of a millisecond more or less.
TEST(FindAnswer, NamesOfEqualImagesTheMethodThatDrawsThem) {
    for (const double ms : {0.99, 1.0, 1.01}) {
        std::vector<MethodSummary> summaries = {method_of("auto", 0.99, ms),
                                                method_of("surface_lookup", 0.99, 1),
                                                method_of("ids", 0.9, 0.5)};
        for (MethodSummary& s : summaries) {
            s.views = 1;
            s.f.counts_of_scene["cube"] = {99, 100, 100};
            s.image_hashes = s.method == "ids" ? "b " : "a ";
        }
        const Answer answer = find_answer(summaries, {});
        EXPECT_EQ(name_of(answer.method), "surface_lookup") << ms;
        EXPECT_EQ(name_of(answer.most_exact), "surface_lookup") << ms;
        EXPECT_EQ(name_of(answer.next), "ids") << "auto is no other";
        EXPECT_TRUE(answer.as_cheap.empty()) << "auto draws the same";
    }
}

// Beside other work the least times of one reach below what the other usually takes.
TEST(FindAnswer, SaysWhichTimesItCannotTellApart) {
    std::vector<MethodSummary> summaries = {method_of("a", 0.995, 1), method_of("b", 0.99, 3)};
    summaries[0].draw_ms_doubt = {0.9, 1.1};
    summaries[1].draw_ms_doubt = {2.8, 9};
    EXPECT_TRUE(find_answer(summaries, {}).as_cheap.empty());
    summaries[0].draw_ms_doubt = {0.9, 4};
    const Answer answer = find_answer(summaries, {});
    EXPECT_EQ(name_of(answer.method), "a");
    ASSERT_EQ(answer.as_cheap.size(), 1U);
    EXPECT_EQ(name_of(answer.as_cheap.front()), "b");
}

/// Two methods over `scenes` scenes: `quick` misses `missed` more pixels of a hundred in every
/// other one.
std::vector<MethodSummary> two_over(int scenes, int missed) {
    std::vector<MethodSummary> summaries = {method_of("quick", 0, 1), method_of("exact", 0, 2)};
    for (int i = 0; i < scenes; ++i) {
        const std::string scene(1, static_cast<char>('a' + i));
        summaries[0].f.counts_of_scene[scene] = {i % 2 == 0 ? 100 : 100 - missed, 100, 100};
        summaries[1].f.counts_of_scene[scene] = {100, 100, 100};
    }
    for (MethodSummary& s : summaries) {
        score::CurveCount sum;
        for (const auto& [scene, counts] : s.f.counts_of_scene)
            sum += counts;
        s.f.all = sum.f();
    }
    return summaries;
}

TEST(AnswerShares, AreThoseOfDrawingsOfScenes) {
    // Within the margin where at most half of ten scenes drawn are the worse ones: 62 % of
    // drawings.
    const std::vector<MethodSummary> close = two_over(10, 2);
    const std::vector<double> shares = answer_shares(close, {}, 7);
    ASSERT_EQ(shares.size(), 2U);
    EXPECT_NEAR(shares[0], 0.623, 0.03);
    EXPECT_NEAR(shares[0] + shares[1], 1, 1e-9);
    EXPECT_EQ(shares, answer_shares(close, {}, 7));
    const Answer answer = find_answer(close, {});
    EXPECT_EQ(name_of(answer.method), "quick");
    EXPECT_EQ(name_of(rival_of(answer, close, shares)), "exact");
    // At most a hundredth below in any drawing: none names another.
    const std::vector<MethodSummary> steady = two_over(10, 1);
    EXPECT_EQ(rival_of(find_answer(steady, {}), steady, answer_shares(steady, {}, 7)), nullptr);
}

TEST(AnswerShares, AreNoneOfFewScenes) {
    const std::vector<MethodSummary> few = two_over(5, 2);
    EXPECT_TRUE(answer_shares(few, {}, 7).empty());
    EXPECT_EQ(rival_of(find_answer(few, {}), few, {}), nullptr);
}

// Within 2 px all are as good, and the quick one is the cheapest; by their ink it is far below.
TEST(FindAnswer, IsBySoftFWhereMethodsHaveIt) {
    std::vector<MethodSummary> summaries = two_over(6, 0);
    summaries[0].soft_f = summaries[0].f;
    summaries[1].soft_f = summaries[1].f;
    EXPECT_EQ(name_of(find_answer(summaries, {}).method), "quick");
    for (auto& [scene, counts] : summaries[0].soft_f.counts_of_scene)
        counts = {80, 100, 100};
    summaries[0].soft_f.all = 0.8;
    const Answer answer = find_answer(summaries, {});
    EXPECT_EQ(name_of(answer.method), "exact");
    EXPECT_EQ(name_of(answer.next), "quick");
    EXPECT_NEAR(answer_shares(summaries, {}, 7)[1], 1, 1e-9);
}

TEST(FindAnswer, IsNoBaseline) {
    MethodSummary oracle = method_of("oracle", 1, 0);
    oracle.is_baseline = true;
    EXPECT_EQ(find_answer({oracle}, {}).method, nullptr);
    const Answer alone = find_answer({oracle, method_of("a", 0.5, 1)}, {});
    EXPECT_EQ(name_of(alone.method), "a");
    EXPECT_EQ(alone.other(), nullptr);
    EXPECT_EQ(find_answer({}, {}).method, nullptr);
}

}  // namespace
}  // namespace ink::summary
