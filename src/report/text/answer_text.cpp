#include "report/text/answer_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "statistics/bootstrap.h"

namespace ink::report {
namespace {

/// "85 % interval": what an interval over so many scenes is worth, whatever it was made for.
std::string interval_name(int scenes) {
    return fmt::format("{} % interval", statistics::known_coverage_percent(scenes));
}

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

/// " in 1.60 ms", of `in` = " in"; "" without a time.
std::string time_text(const char* in, const MethodSummary& s) {
    if (!s.draw_ms) return "";
    return fmt::format(
        "{} {} ms{}", in, format_ms(s.draw_ms), s.has_own_clock ? " by its own clock" : "");
}

std::string times_as_long(const MethodSummary& a, const MethodSummary& b) {
    if (!a.draw_ms || !b.draw_ms || a.has_own_clock || b.has_own_clock) return "";
    return fmt::format(", {:.1f} times as long", *b.draw_ms / *a.draw_ms);
}

/// "99.6 %"; "100 %" of nothing less than all; "nothing" of nothing.
std::string percent_text(std::int64_t part, std::int64_t whole) {
    if (whole == 0) return "nothing";
    if (part == whole) return "100 %";
    const double share = static_cast<double>(part) / static_cast<double>(whole);
    return fmt::format("{:.1f} %", std::min(99.9, 100 * share));
}

/// "quick finds 95.3 % of the outline, and 95.3 % of what it draws is right, in 1.60 ms".
std::string finding_text(const MethodSummary& s, Markup markup) {
    const bool is_ink = s.measure() == summary::Measure::soft_f;
    score::CurveCount sum;
    for (const auto& [scene, counts] : s.judged().counts_of_scene)
        sum += counts;
    return fmt::format("{} finds {} of the {}, and {} of {} is right{}",
                       strong(s.method, markup),
                       percent_text(sum.k, sum.n_truth),
                       is_ink ? "ink" : "outline",
                       percent_text(sum.k, sum.n_pred),
                       is_ink ? "the ink it draws" : "what it draws",
                       time_text(", in", s));
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

/// Why the difference has no interval; "" where it has one.
std::string interval_sentence(const std::vector<harness::Row>& rows,
                              const PairedDifference& paired) {
    if (paired.range) return "";
    return fmt::format(" {} {} too few for an interval{}.",
                       scenes_text(rows, paired.scenes),
                       paired.scenes == 1 ? "is" : "are",
                       better_text(paired));
}

/// " (+0.006 [+0.002, +0.008], 85 % interval over 12 models)".
std::string difference_text(const std::vector<harness::Row>& rows, const PairedDifference& paired) {
    const std::string interval =
        fmt::format(", {} over {}", interval_name(paired.scenes), scenes_text(rows, paired.scenes));
    return fmt::format(
        " ({}{})", format_paired_difference(paired, true), paired.range ? interval : "");
}

/// Why it is the answer, and what it is held against.
std::string reason_sentences(const std::vector<harness::Row>& rows,
                             const summary::Comparison& comparison,
                             const Answer& answer,
                             Markup markup) {
    const MethodSummary& method = *answer.method;
    const std::string in_time = comparison.rule.budget_ms > 0 ? " in that time" : "";
    const std::string own =
        fmt::format("Its {} is {}", measure_text(method.measure()), f_text(method));
    if (answer.other() == nullptr) return fmt::format("{}; it is the only method{}.", own, in_time);
    const MethodSummary& other = *answer.other();
    const auto paired = difference_of(comparison, answer);
    const bool is_lead = paired && paired->is_significant();
    const bool is_best = answer.method == answer.most_exact;
    const std::string scene = error_scene_text(other);
    return fmt::format(
        "{}{} {} {}{}{}{}{}.{}",
        is_best ? fmt::format("{}, the highest{}.{} ", own, in_time, is_lead ? " It leads:" : "")
                : fmt::format("{}; none is higher{} by more than {:g}. The most exact, ",
                              own,
                              in_time,
                              comparison.rule.f_margin),
        code(other.method, markup) + (is_best ? "" : ","),
        is_lead && !is_best ? "leads with" : "has",
        f_text(other),
        scene.empty() ? "" : fmt::format(" ({})", scene),
        time_text(" in", other),
        is_best ? "" : times_as_long(method, other),
        paired ? difference_text(rows, *paired) : "",
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
    std::string first = budget + finding_text(method, markup);
    if (rival.method != nullptr) first += "; or " + finding_text(*rival.method, markup);
    if (!method.draw_ms && answer.other() != nullptr) first += "; no time was taken";
    std::string rest = reason_sentences(rows, comparison, answer, markup);
    rest += rival_sentence(answer, rival, rule, markup);
    if (!answer.as_cheap.empty()) rest += " A" + times_text(answer, markup).substr(1) + ".";
    const std::string scene = error_scene_text(method);
    if (!scene.empty()) rest += fmt::format(" {} has {}.", code(method.method, markup), scene);
    return {first, rest};
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
                                   time_text(" in", method));
    const MethodSummary* other = answer.other();
    if (other == nullptr) return text + ".";
    text += fmt::format("; {}, {} has {} = {}{}",
                        &method == answer.most_exact ? "the next" : "the most exact method",
                        other->method + ",",
                        measure,
                        f_text(*other),
                        time_text(" in", *other));
    text += times_as_long(method, *other);
    const auto paired = difference_of(comparison, answer);
    if (!paired) return text + ".";
    const std::string difference = format_paired_difference(*paired, true);
    const std::string interval = ", " + interval_name(paired->scenes) + " over scenes";
    return text + fmt::format(" (difference {}{}).", difference, paired->range ? interval : "");
}

}  // namespace ink::report
