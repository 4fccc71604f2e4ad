#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ink::summary {

struct MethodSummary;

/// A method that takes less than this many times as long as the cheapest is as cheap. Methods that
/// differ in one pass lie 1.05 to 1.2 apart: a limit among them is crossed by what times move by
/// from one run to the next, and the answer changes its name.
inline constexpr double kAlikeTimes = 1.3;

/// From one run to the next the ratio of two methods' times may move by as much (`ratios` of
/// bench/README.md).
inline constexpr double kUnsureTimes = 1.1;

/// What a reader asks of the answer to "which method makes the fewest errors in this time?".
struct AnswerRule {
    double f_margin = 0.01;  ///< an F this far below the best measured is as good; soft F likewise
    /// Longest time of a frame, a median over views; 0: any. A method without a time is within
    /// none.
    double budget_ms = 0;

    friend bool operator==(const AnswerRule&, const AnswerRule&) = default;
};

/// The answer, and what it is to be held against. Null for what there is none of; they point into
/// the summaries.
struct Answer {
    /// Of the methods within the budget whose F, or soft F where the run has it
    /// (MethodSummary::judged), is at most the margin below the best of them, the
    /// cheapest by this program's clock; of those that are as cheap, the most exact; of
    /// equals, one that draws by itself before one that chooses among others, then the first. The
    /// most exact itself where none such was timed.
    const MethodSummary* method = nullptr;
    const MethodSummary* most_exact = nullptr;  ///< within the budget
    const MethodSummary* next = nullptr;        ///< the most exact after that, of other images
    const MethodSummary* fastest = nullptr;     ///< of all with a score, whatever the budget
    /// As good, with other images: another run may name them, for times move that much or were
    /// taken on a busy machine.
    std::vector<const MethodSummary*> as_cheap = {};

    /// What the answer is held against: the most exact, or the next if it is that itself.
    [[nodiscard]] const MethodSummary* other() const {
        return method == most_exact ? next : most_exact;
    }
};

/// Baselines give no answer.
[[nodiscard]] Answer find_answer(const std::vector<MethodSummary>& summaries,
                                 const AnswerRule& rule);

/// In which share of drawings of scenes, with replacement, each summary is the answer: drawn 2000
/// times with their views, F pooled anew, times as they are. Empty with fewer than six scenes.
[[nodiscard]] std::vector<double> answer_shares(const std::vector<MethodSummary>& summaries,
                                                const AnswerRule& rule,
                                                std::uint64_t seed);

/// The method that drawings of scenes name most often in place of the answer, if they name another
/// one in more than a quarter, and both have a time; else null.
[[nodiscard]] const MethodSummary* rival_of(const Answer& answer,
                                            const std::vector<MethodSummary>& summaries,
                                            const std::vector<double>& shares);

/// What a method is in the answer: "answer", "best" for the most exact, "both", or "".
[[nodiscard]] std::string place_in(const Answer& answer, const MethodSummary& summary);

}  // namespace ink::summary
