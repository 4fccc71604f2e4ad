#pragma once

#include <string>
#include <vector>

namespace ink::summary {

struct MethodSummary;

/// What a reader asks of the answer to "which method makes the fewest errors in this time?".
struct AnswerRule {
    double f_margin = 0.01;  ///< an F this far below the best measured is as good
    /// Longest median time of a frame; 0: any. A method without a time is within no budget.
    double budget_ms = 0;

    friend bool operator==(const AnswerRule&, const AnswerRule&) = default;
};

/// The answer, and what it is to be held against. Null for what there is none of; they point into
/// the summaries.
struct Answer {
    /// Of the methods within the budget, the cheapest by this program's clock whose F is at most
    /// the margin below the best of them; the most exact itself where none such was timed.
    const MethodSummary* method = nullptr;
    const MethodSummary* most_exact = nullptr;  ///< within the budget
    const MethodSummary* next = nullptr;        ///< the most exact after that
    const MethodSummary* fastest = nullptr;     ///< of all with a score, whatever the budget

    /// What the answer is held against: the most exact, or the next if it is that itself.
    [[nodiscard]] const MethodSummary* other() const {
        return method == most_exact ? next : most_exact;
    }
};

/// Baselines give no answer.
[[nodiscard]] Answer find_answer(const std::vector<MethodSummary>& summaries,
                                 const AnswerRule& rule);

/// What a method is in the answer: "answer", "best" for the most exact, "both", or "".
[[nodiscard]] std::string place_in(const Answer& answer, const MethodSummary& summary);

}  // namespace ink::summary
