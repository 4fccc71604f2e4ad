#include "summary/answer.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "statistics/bootstrap.h"
#include "summary/summary.h"

namespace ink::summary {
namespace {

constexpr double kRounding = 1e-9;  ///< of F: .98 is .01 below .99
constexpr double kSteadyShare =
    0.75;  ///< of drawings that name the answer, which is then said alone

using Summaries = std::vector<const MethodSummary*>;

double f_of(const MethodSummary* summary) {
    return *summary->judged().all;
}

/// One that draws by itself comes before one that chooses; of equals the first is meant.
bool is_before(const MethodSummary* a, const MethodSummary* b) {
    if (f_of(a) != f_of(b)) return f_of(a) > f_of(b);
    return !is_choice_of_others(a->method) && is_choice_of_others(b->method);
}

/// Null of none.
const MethodSummary* most_exact_of(const Summaries& summaries) {
    const auto best = std::min_element(summaries.begin(), summaries.end(), is_before);
    return best == summaries.end() ? nullptr : *best;
}

/// The more exact of two that take as long.
bool is_cheaper(const MethodSummary* a, const MethodSummary* b) {
    return std::tuple(*a->draw_ms, -f_of(a)) < std::tuple(*b->draw_ms, -f_of(b));
}

bool have_equal_images(const MethodSummary& a, const MethodSummary& b) {
    return a.image_hashes == b.image_hashes && !a.image_hashes.empty();
}

/// Of those that are as good: the most exact that takes less than `limit` times the least time.
/// Null of none.
const MethodSummary* most_exact_within(double limit, const Summaries& as_good) {
    const auto cheapest = std::min_element(as_good.begin(), as_good.end(), is_cheaper);
    if (cheapest == as_good.end()) return nullptr;
    Summaries alike = {*cheapest};  // it may take no time at all
    std::copy_if(as_good.begin(), as_good.end(), std::back_inserter(alike), [&](const auto* s) {
        return *s->draw_ms < limit * *(*cheapest)->draw_ms;
    });
    return most_exact_of(alike);
}

bool are_times_in_doubt(const MethodSummary& a, const MethodSummary& b) {
    return a.draw_ms_doubt && b.draw_ms_doubt && a.draw_ms_doubt->low < b.draw_ms_doubt->high;
}

/// Whose images are the answer's is no other.
Summaries others_that_may_be_named(const MethodSummary& method, const Summaries& as_good) {
    const MethodSummary* more = most_exact_within(kAlikeTimes * kUnsureTimes, as_good);
    const MethodSummary* less = most_exact_within(kAlikeTimes / kUnsureTimes, as_good);
    Summaries others = as_good;
    std::erase_if(others, [&](const MethodSummary* s) {
        const bool may_be = s == more || s == less || are_times_in_doubt(*s, method);
        return s == &method || !may_be || have_equal_images(*s, method);
    });
    return others;
}

}  // namespace

Answer find_answer(const std::vector<MethodSummary>& summaries, const AnswerRule& rule) {
    Summaries timed;
    Summaries within;
    for (const MethodSummary& s : summaries) {
        if (s.is_baseline || !s.f.all) continue;
        if (s.draw_ms) timed.push_back(&s);
        if (rule.budget_ms == 0 || (s.draw_ms && *s.draw_ms <= rule.budget_ms))
            within.push_back(&s);
    }
    Answer answer;
    const auto fastest = std::min_element(timed.begin(), timed.end(), is_cheaper);
    if (fastest != timed.end()) answer.fastest = *fastest;
    answer.method = answer.most_exact = most_exact_of(within);
    if (answer.most_exact == nullptr) return answer;
    Summaries as_good = within;
    std::erase_if(as_good, [&](const MethodSummary* s) {
        const double below = f_of(answer.most_exact) - f_of(s);
        return !s->draw_ms || s->has_own_clock || below > rule.f_margin + kRounding;
    });
    if (!as_good.empty()) {
        answer.method = most_exact_within(kAlikeTimes, as_good);
        answer.as_cheap = others_that_may_be_named(*answer.method, as_good);
    }
    std::erase(within, answer.most_exact);
    Summaries drawn_otherwise = within;
    std::erase_if(drawn_otherwise, [&](const MethodSummary* s) {
        return have_equal_images(*s, *answer.most_exact);
    });
    answer.next = most_exact_of(drawn_otherwise.empty() ? within : drawn_otherwise);
    return answer;
}

std::vector<double> answer_shares(const std::vector<MethodSummary>& summaries,
                                  const AnswerRule& rule,
                                  std::uint64_t seed) {
    std::set<std::string> scenes;
    for (const MethodSummary& s : summaries)
        for (const auto& [scene, counts] : s.f.counts_of_scene)
            scenes.insert(scene);
    if (scenes.size() < statistics::kFewestClusters) return {};
    const statistics::BootstrapOptions options{.seed = seed};
    std::vector<MethodSummary> drawn = summaries;
    std::vector<double> shares(summaries.size(), 0);
    for (const std::vector<double>& times : statistics::drawings_of(scenes.size(), options)) {
        for (MethodSummary& s : drawn) {
            if (!s.f.all) continue;
            FSummary& judged = s.measure() == Measure::soft_f ? s.soft_f : s.f;
            score::CurveCount sum;
            std::size_t i = 0;
            for (const std::string& scene : scenes) {
                const auto own = judged.counts_of_scene.find(scene);
                const auto n = static_cast<std::int64_t>(times[i++]);
                if (own == judged.counts_of_scene.end()) continue;
                const auto& [k, n_pred, n_truth] = own->second;
                sum += {n * k, n * n_pred, n * n_truth};
            }
            judged.all = sum.f();
        }
        const MethodSummary* named = find_answer(drawn, rule).method;
        if (named == nullptr) return {};
        shares[static_cast<std::size_t>(named - drawn.data())] += 1.0 / options.resamples;
    }
    return shares;
}

const MethodSummary* rival_of(const Answer& answer,
                              const std::vector<MethodSummary>& summaries,
                              const std::vector<double>& shares) {
    if (shares.empty() || answer.method == nullptr || !answer.method->draw_ms) return nullptr;
    const auto at = static_cast<std::size_t>(answer.method - summaries.data());
    if (shares[at] >= kSteadyShare) return nullptr;
    std::vector<double> others = shares;
    others[at] = 0;
    const auto most = std::max_element(others.begin(), others.end());
    const MethodSummary& rival = summaries[static_cast<std::size_t>(most - others.begin())];
    return *most > 0 && rival.draw_ms ? &rival : nullptr;
}

std::string place_in(const Answer& answer, const MethodSummary& summary) {
    const bool is_most_exact = &summary == answer.most_exact;
    if (&summary == answer.method) return is_most_exact ? "both" : "answer";
    return is_most_exact ? "best" : "";
}

}  // namespace ink::summary
