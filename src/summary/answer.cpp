#include "summary/answer.h"

#include <algorithm>
#include <tuple>

#include "summary/summary.h"

namespace ink::summary {
namespace {

constexpr double kRounding = 1e-9;  ///< of F: .98 is .01 below .99

/// Of equals the first; null of none.
const MethodSummary* most_exact_of(const std::vector<const MethodSummary*>& summaries) {
    const auto best =
        std::max_element(summaries.begin(), summaries.end(), [](const auto* a, const auto* b) {
            return *a->f_2px < *b->f_2px;
        });
    return best == summaries.end() ? nullptr : *best;
}

/// The more exact of two that take as long.
bool is_cheaper(const MethodSummary* a, const MethodSummary* b) {
    return std::tuple(*a->draw_ms, -*a->f_2px) < std::tuple(*b->draw_ms, -*b->f_2px);
}

}  // namespace

Answer find_answer(const std::vector<MethodSummary>& summaries, const AnswerRule& rule) {
    std::vector<const MethodSummary*> timed;
    std::vector<const MethodSummary*> within;
    for (const MethodSummary& s : summaries) {
        if (s.is_baseline || !s.f_2px) continue;
        if (s.draw_ms) timed.push_back(&s);
        if (rule.budget_ms == 0 || (s.draw_ms && *s.draw_ms <= rule.budget_ms))
            within.push_back(&s);
    }
    Answer answer;
    const auto fastest = std::min_element(timed.begin(), timed.end(), is_cheaper);
    if (fastest != timed.end()) answer.fastest = *fastest;
    answer.method = answer.most_exact = most_exact_of(within);
    if (answer.most_exact == nullptr) return answer;
    std::vector<const MethodSummary*> as_good = within;
    std::erase_if(as_good, [&](const MethodSummary* s) {
        const double below = *answer.most_exact->f_2px - *s->f_2px;
        return !s->draw_ms || s->has_own_clock || below > rule.f_margin + kRounding;
    });
    const auto cheapest = std::min_element(as_good.begin(), as_good.end(), is_cheaper);
    if (cheapest != as_good.end()) answer.method = *cheapest;
    std::erase(within, answer.most_exact);
    answer.next = most_exact_of(within);
    return answer;
}

std::string place_in(const Answer& answer, const MethodSummary& summary) {
    const bool is_most_exact = &summary == answer.most_exact;
    if (&summary == answer.method) return is_most_exact ? "both" : "answer";
    return is_most_exact ? "best" : "";
}

}  // namespace ink::summary
