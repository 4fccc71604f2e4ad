#include "summary/answer.h"

#include <gtest/gtest.h>

#include "summary/summary.h"

namespace ink::summary {
namespace {

MethodSummary method_of(const std::string& name, double f, double ms) {
    MethodSummary summary;
    summary.method = name;
    summary.f_2px = f;
    if (ms > 0) summary.draw_ms = ms;
    return summary;
}

std::string name_of(const MethodSummary* summary) {
    return summary == nullptr ? "" : summary->method;
}

TEST(FindAnswer, IsTheCheapestWithinTheMarginOfTheBest) {
    const std::vector<MethodSummary> summaries = {method_of("rough", 0.90, 0.5),
                                                  method_of("good", 0.985, 1.6),
                                                  method_of("better", 0.99, 1.7),
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

TEST(FindAnswer, TakesTheMoreExactOfTwoThatTakeAsLong) {
    const std::vector<MethodSummary> summaries = {method_of("a", 0.99, 1),
                                                  method_of("b", 0.995, 1)};
    EXPECT_EQ(name_of(find_answer(summaries, {}).method), "b");
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
