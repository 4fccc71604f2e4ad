#include "report/text/answer_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "statistics/bootstrap.h"

namespace ink::report {
namespace {

using summary::Answer;
using summary::MethodSummary;
using summary::PairedDifference;

std::string strong(const std::string& name, Markup markup) {
    return markup == Markup::markdown ? "**" + name + "**" : name;
}

std::string code(const std::string& name, Markup markup) {
    return markup == Markup::markdown ? "`" + name + "`" : name;
}

/// "1 scene", "4 models": models where all are model files.
std::string scenes_text(const std::vector<harness::Row>& rows, int count) {
    const bool are_models =
        std::ranges::all_of(rows, [](const harness::Row& row) { return row.split == "real"; });
    return fmt::format("{} {}{}", count, are_models ? "model" : "scene", count == 1 ? "" : "s");
}

std::string f_text(const MethodSummary& s) {
    return fmt::format("{:.3f}", *s.judged().all);
}

/// "72 % of its error in bars"; "" where it does not sit in one scene.
std::string error_scene_text(const MethodSummary& s) {
    if (!summary::is_error_in_one_scene(s)) return "";
    const summary::FSummary& f = s.judged();
    return fmt::format("{:.0f} % of its error in {}", 100 * *f.error_scene_share, f.error_scene);
}

/// " in 1.60 ms"; "" without a time.
std::string time_text(const char* in, const MethodSummary& s) {
    if (!s.draw_ms) return "";
    return fmt::format(
        " {} {} ms{}", in, format_ms(s.draw_ms), s.has_own_clock ? " by its own clock" : "");
}

/// The method that drawings of scenes name instead in more than a quarter, or null, and how often.
struct Rival {
    const MethodSummary* method = nullptr;
    double share = 0;
};

Rival rival_of(const summary::Comparison& comparison, const Answer& answer) {
    const auto& summaries = comparison.summaries;
    const auto& shares = comparison.shares;
    const MethodSummary* rival = summary::rival_of(answer, summaries, shares);
    return rival == nullptr
               ? Rival{}
               : Rival{rival, shares[static_cast<std::size_t>(rival - summaries.data())]};
}

/// How often drawings of scenes name the rival, and what decides.
std::string rival_sentence(const Answer& answer,
                           const Rival& rival,
                           const summary::AnswerRule& rule,
                           Markup markup) {
    if (rival.method == nullptr) return "";
    // Both are as cheap as they are in every drawing: the gap of the cheaper one moves.
    const MethodSummary& cheaper =
        *rival.method->draw_ms < *answer.method->draw_ms ? *rival.method : *answer.method;
    return fmt::format(
        " {:.0f} % of drawings of scenes name the second: {} is {:.4f} below the best, and the "
        "margin is {:g}.",
        100 * rival.share,
        code(cheaper.method, markup),
        *answer.most_exact->judged().all - *cheaper.judged().all,
        rule.f_margin);
}

/// How the other differs from the answer; nothing without a view that both have.
std::optional<PairedDifference> difference_of(const summary::Comparison& comparison,
                                              const Answer& answer) {
    const auto& differences = comparison.measure() == summary::Measure::soft_f
                                  ? comparison.soft_differences
                                  : comparison.differences;
    const auto paired = std::ranges::find_if(differences, [&](const PairedDifference& d) {
        return d.a == answer.other()->method && d.b == answer.method->method;
    });
    return paired == differences.end() ? std::nullopt : std::optional(*paired);
}

/// "; better on 3 of 4": on how many scenes the more exact of the two is.
std::string better_text(const PairedDifference& paired) {
    if (paired.scenes < 2) return "";
    const int better = paired.difference < 0 ? paired.worse : paired.better;
    return fmt::format("; better on {} of {}", better, paired.scenes);
}

/// What the interval of the difference is, or why there is none.
std::string interval_sentence(const std::vector<harness::Row>& rows,
                              const PairedDifference& paired) {
    const std::string scenes = scenes_text(rows, paired.scenes);
    if (!paired.range) {
        return fmt::format(" {} {} too few for an interval{}.",
                           scenes,
                           paired.scenes == 1 ? "is" : "are",
                           better_text(paired));
    }
    return fmt::format(
        " The 95 % interval is resampled over these {}; such intervals cover about {} %.",
        scenes,
        statistics::known_coverage_percent(paired.scenes));
}

/// What the answer is held against.
std::string other_sentences(const std::vector<harness::Row>& rows,
                            const summary::Comparison& comparison,
                            const Answer& answer,
                            Markup markup) {
    const MethodSummary& other = *answer.other();
    const auto paired = difference_of(comparison, answer);
    const bool is_lead = paired && paired->is_significant();
    const bool is_answer_best = answer.method == answer.most_exact;
    const std::string scene = error_scene_text(other);
    return fmt::format(" {}{} {} {}{}{}{}.{}",
                       is_lead && is_answer_best ? "It leads: " : "",
                       code(other.method, markup),
                       is_lead && !is_answer_best ? "leads with" : "has",
                       f_text(other),
                       scene.empty() ? "" : fmt::format(" ({})", scene),
                       time_text("at", other),
                       paired ? fmt::format(" ({})", format_paired_difference(*paired, true)) : "",
                       paired ? interval_sentence(rows, *paired) : "");
}

/// "36 scenes (104 views of 1280x720 px)".
std::string extent_text(const std::vector<harness::Row>& rows, const MethodSummary& s) {
    return fmt::format("{} ({} view{} of {}x{} px)",
                       scenes_text(rows, s.scenes),
                       s.views,
                       s.views == 1 ? "" : "s",
                       rows.front().width,
                       rows.front().height);
}

std::string times_as_long(const MethodSummary& a, const MethodSummary& b) {
    if (!a.draw_ms || !b.draw_ms || a.has_own_clock || b.has_own_clock) return "";
    return fmt::format(", {:.1f} times as long", *b.draw_ms / *a.draw_ms);
}

}  // namespace

std::string format_ms(const std::optional<double>& ms) {
    if (!ms) return "-";
    // What rounds to 10 or 100 is shown as such: 9.996 is "10.0", not "10.00".
    const int decimals = *ms < 0.0995 ? 3 : *ms < 9.995 ? 2 : *ms < 99.95 ? 1 : 0;
    return fmt::format("{:.{}f}", *ms, decimals);
}

std::string measure_text(summary::Measure measure) {
    return measure == summary::Measure::soft_f ? "soft F" : "F";
}

std::string measure_extent(const std::vector<harness::Row>& rows, summary::Measure measure) {
    const auto row =
        std::ranges::find_if(rows, [](const harness::Row& r) { return r.soft.has_value(); });
    return measure == summary::Measure::f_2px || row == rows.end()
               ? "at 2 px"
               : fmt::format("of lines {:g} px wide", row->soft->line_width_px);
}

std::string times_text(const Answer& answer, Markup markup) {
    if (answer.as_cheap.empty()) return "";
    std::vector<std::string> names;
    for (const MethodSummary* s : answer.as_cheap)
        names.push_back(code(s->method, markup));
    return fmt::format("another run may name {}: the times are that close", fmt::join(names, ", "));
}

AnswerText answer_text(const std::vector<harness::Row>& rows,
                       const summary::Comparison& comparison,
                       Markup markup) {
    const Answer answer = comparison.answer();
    const summary::AnswerRule& rule = comparison.rule;
    const std::string budget =
        rule.budget_ms > 0 ? fmt::format("Within {} ms, ", format_ms(rule.budget_ms)) : "";
    if (answer.method == nullptr && answer.fastest != nullptr) {
        return {fmt::format("{}none has a score: none is faster than {} ms ({})",
                            budget,
                            format_ms(answer.fastest->draw_ms),
                            code(answer.fastest->method, markup)),
                ""};
    }
    if (answer.method == nullptr)
        return {"No method was scored on any view, so there is no verdict", ""};
    const MethodSummary& method = *answer.method;
    const Rival rival = rival_of(comparison, answer);
    const std::string measure = measure_text(method.measure());
    std::string first = fmt::format("{}{}: {} {}{}",
                                    budget,
                                    strong(method.method, markup),
                                    measure,
                                    f_text(method),
                                    time_text("in", method));
    if (rival.method != nullptr) {
        first += fmt::format(", or {}: {} {}{}",
                             strong(rival.method->method, markup),
                             measure,
                             f_text(*rival.method),
                             time_text("in", *rival.method));
    }
    const bool is_alone = answer.other() == nullptr;
    if (is_alone) first += ", the only method";
    if (!is_alone && &method == answer.most_exact)
        first += rival.method == nullptr ? ", the most exact" : "; the first is the most exact";
    if (!method.draw_ms && !is_alone) first += "; no time was taken";
    std::string rest = rival_sentence(answer, rival, rule, markup);
    if (!answer.as_cheap.empty()) rest += " A" + times_text(answer, markup).substr(1) + ".";
    const std::string scene = error_scene_text(method);
    if (!scene.empty()) rest += fmt::format(" It has {}.", scene);
    if (!is_alone) rest += other_sentences(rows, comparison, answer, markup);
    return {first, rest.empty() ? "" : rest.substr(1)};
}

std::string paper_sentence(const std::vector<harness::Row>& rows,
                           const summary::Comparison& comparison) {
    const Answer answer = comparison.answer();
    if (answer.method == nullptr) return "";
    const MethodSummary& method = *answer.method;
    const std::string measure = measure_text(method.measure());
    std::string text = fmt::format("Over {}, {} has {} = {} {}{}",
                                   extent_text(rows, method),
                                   method.method,
                                   measure,
                                   f_text(method),
                                   measure_extent(rows, method.measure()),
                                   time_text("in", method));
    const MethodSummary* other = answer.other();
    if (other == nullptr) return text + ".";
    text += fmt::format("; {}, {} has {} = {}{}",
                        &method == answer.most_exact ? "the next" : "the most exact method",
                        other->method + ",",
                        measure,
                        f_text(*other),
                        time_text("in", *other));
    text += times_as_long(method, *other);
    const auto paired = difference_of(comparison, answer);
    if (!paired) return text + ".";
    const std::string difference = format_paired_difference(*paired, true);
    return text + fmt::format(" (difference {}{}).",
                              difference,
                              paired->range ? ", 95 % interval over scenes" : "");
}

}  // namespace ink::report
