#include "summary/summary_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>

#include "core/vocabulary.h"
#include "harness/images/view_images.h"
#include "statistics/bootstrap.h"
#include "statistics/spread.h"
#include "summary/summary.h"

namespace ink::summary {
namespace {

/// The 95 % interval of each class's recall pooled over `rows`, which are of one method: scenes
/// resampled with all their views, as f_interval does it with the rows' seed.
///
/// A class that is there in fewer than six scenes has none.
std::map<std::string, statistics::Interval> class_recall_intervals(
    const std::vector<const harness::Row*>& rows) {
    std::map<std::string, SceneSums> classes;
    for (const harness::Row* row : rows)
        for (const auto& [name, found] : row->by_class)
            classes[name].add(row->scene, found);
    std::map<std::string, statistics::Interval> intervals;
    for (const auto& [name, scenes] : classes) {
        const auto interval = statistics::f_interval(scenes.counts, {.seed = rows.front()->seed});
        if (interval) intervals[name] = *interval;
    }
    return intervals;
}

/// What a line is made from.
struct Line {
    MethodSummary summary;
    std::map<std::string, statistics::Interval> recall_ranges;
    std::string answer;
    std::optional<double> answer_share = {};
};
using SummaryTable = core::TableOf<Line>;

/// The two ends of an interval.
void add_ends(const core::PartOf<statistics::Interval>& range,
              core::Column low,
              core::Column high) {
    range.add_derived(std::move(low), &statistics::Interval::low);
    range.add_derived(std::move(high), &statistics::Interval::high);
}

void add_recalls(SummaryTable& table) {
    for (const core::Term& group : core::vocabulary().recall_groups) {
        const std::string name(group.name);
        const std::string key = "recall_" + name;
        table.part_if([name](const Line& of) { return of.summary.recall_by_class.contains(name); })
            .add_derived({key, "0..1", "recall of this class, pooled over views"},
                         [name](const Line& of) { return of.summary.recall_by_class.at(name); });
        add_ends(table.part_if([name](const Line& of) { return of.recall_ranges.contains(name); })
                     .part([name](Line & of) -> auto& { return of.recall_ranges.at(name); }),
                 {key + "_lo", "0..1", "lower end of its nominal 95 % interval"},
                 {key + "_hi", "0..1", "upper end"});
    }
}

/// An F with its interval, and over parts of the suite: columns that begin with `name` or `error`.
void add_f(const core::PartOf<FSummary>& f,
           core::Column whole,
           const std::string& name,
           const std::string& error) {
    using S = FSummary;
    f.add_derived(std::move(whole), &S::all);
    add_ends(f.part(&S::range),
             {name + "_lo", "0..1", "lower end of its nominal 95 % interval, scenes resampled"},
             {name + "_hi", "0..1", "upper end"});
    f.add_derived({error + "_scene", "", "the scene with most of its error"}, &S::error_scene);
    f.add_derived({error + "_scene_share", "0..1", "of its error, that of that scene"},
                  &S::error_scene_share);
    f.add_derived({name + "_train", "0..1", "the same over training scenes"}, &S::train);
    f.add_derived({name + "_heldout", "0..1", "the same over held-out scenes"}, &S::heldout);
    f.add_derived({name + "_real", "0..1", "the same over model files"}, &S::real);
    f.add_derived({name + "_macro", "0..1", "mean of the scenes' own F"}, &S::macro);
    f.add_derived({name + "_kinds", "0..1", "mean of F over kinds of scenes (kinds.csv)"},
                  &S::mean_of_kinds);
}

void add_scores(const core::PartOf<MethodSummary>& summary, bool has_soft_f) {
    using S = MethodSummary;
    add_f(summary.part(&S::f),
          {"f_2px", "0..1", "F within 2 px of the counts of all views"},
          "f",
          "error");
    summary.add_derived({"f_1px", "0..1", "F within 1 px of the counts of all views"}, &S::f_1px);
    summary.add_derived({"precision", "0..1", "pooled, within 2 px"}, &S::precision);
    summary.add_derived({"recall", "0..1", "pooled, within 2 px"}, &S::recall);
    summary.add_derived({"ap", "0..1", "area under the precision envelope of the pooled curves"},
                        &S::ap);
    if (!has_soft_f) return;
    add_f(
        summary.part(&S::soft_f),
        {"soft_f", "0..1", "soft F of the ink of all views; this and the next only with coverage"},
        "soft",
        "soft_error");
}

SummaryTable make_table(bool has_soft_f) {
    using S = MethodSummary;
    SummaryTable table("summary.csv", "A line per method, over all cells of study `compare`.");
    const auto summary = table.part(&Line::summary);
    summary.add_derived({"method", "", "as in rows.csv"}, &S::method);
    summary.add_derived({"kind", "", "method or baseline"},
                        [](const S& s) { return s.is_baseline ? "baseline" : "method"; });
    table.add_derived({"answer",
                       "",
                       "answer: the cheapest whose F (with coverage: soft F) is at most the margin "
                       "below the best within the budget, the most exact of those that take less "
                       "than 1.3 times as long; "
                       "best: the most exact of all; both",
                       true},
                      &Line::answer);
    table.add_derived({"answer_share",
                       "0..1",
                       "of 2000 drawings of scenes, those that name it the answer; none with fewer "
                       "than six scenes",
                       true},
                      &Line::answer_share);
    summary.add_derived({"views", "", "on which it was scored"}, &S::views);
    summary.add_derived({"scenes", "", "of these views"}, &S::scenes);
    summary.add_derived({"failed", "", "cells without a score"}, &S::failed);
    add_scores(summary, has_soft_f);
    summary.add_derived({"draw_ms", "ms", "median over views of draw_ns", true}, &S::draw_ms);
    add_ends(summary.part(&S::draw_ms_quartiles),
             {"draw_ms_lo", "ms", "lower quartile", true},
             {"draw_ms_hi", "ms", "upper quartile", true});
    summary.add_derived({"bytes_per_px", "B/px", "of the method's buffers, depth included"},
                        &S::bytes_per_px);
    add_recalls(table);
    return table;
}

const SummaryTable& table(bool has_soft_f) {
    static const SummaryTable kPlain = make_table(false);
    static const SummaryTable kWithSoftF = make_table(true);
    return has_soft_f ? kWithSoftF : kPlain;
}

std::string remedy_of(const harness::Row& row) {
    if (row.status.starts_with("too_large")) {
        return "a smaller --size, fewer triangles, or a larger --crease, so that fewer edges are "
               "lines";
    }
    if (row.status.starts_with("reference_disagreement")) {
        return fmt::format(
            "inkbench truth {} --view {} --crosscheck --disagreement where.png shows "
            "the places; --no-crosscheck scores the view anyway",
            row.scene,
            row.view);
    }
    if (row.status.starts_with("empty")) {
        return fmt::format(
            "a view that shows lines of it away from the frame: inkbench explain {} "
            "prints its box and cameras; or a larger --size",
            row.scene);
    }
    if (row.status.starts_with("crowded")) {
        return "a larger --size, or a view in which lines lie farther apart; f_2px_with_crowded of "
               "its rows counts the crowded pixels too";
    }
    if (row.has_own_clock()) {
        return fmt::format("inkbench entrant-test tries a program; a folder has {}/{}.png",
                           harness::file_name(row.scene),
                           harness::file_name(row.view));
    }
    return fmt::format("inkbench draw {} --view {} --method {} -o alone.png draws it alone",
                       row.scene,
                       row.view,
                       row.method);
}

/// What a line of kinds.csv is made from.
struct KindLine {
    std::string method;
    KindSummary kind;
    std::optional<KindSummary> soft = {};
};

core::TableOf<KindLine> kind_columns(bool has_soft_f) {
    using K = KindSummary;
    core::TableOf<KindLine> table(
        "kinds.csv", "A line per method and kind of scene, over all cells of study `compare`.");
    table.add_derived({"method", "", "as in rows.csv"}, &KindLine::method);
    const auto kind = table.part(&KindLine::kind);
    kind.add_derived({"scene_kind", "", "as in rows.csv"}, &K::kind);
    kind.add_derived({"scenes", "", "of this kind that have a score"}, &K::scenes);
    kind.add_derived({"f_2px", "0..1", "F within 2 px of the counts of all their views"}, &K::f);
    kind.add_derived({"least_scene", "", "the scene with the lowest F"}, &K::least_scene);
    kind.add_derived({"f_least", "0..1", "that F"}, &K::f_least);
    if (!has_soft_f) return table;
    const auto soft = table.part(&KindLine::soft);
    soft.add_derived(
        {"soft_f", "0..1", "soft F of their ink; this and the next only with coverage"}, &K::f);
    soft.add_derived({"soft_least_scene", "", "the scene with the lowest"}, &K::least_scene);
    soft.add_derived({"soft_least", "0..1", "that soft F"}, &K::f_least);
    return table;
}

}  // namespace

const core::TableInfo& summary_table(bool has_soft_f) {
    return table(has_soft_f).info();
}

std::string summary_csv(const std::vector<harness::Row>& rows, const Comparison& comparison) {
    const Answer answer = comparison.answer();
    const std::vector<double>& shares = comparison.shares;
    std::vector<Line> lines;
    for (const MethodSummary& summary : comparison.summaries) {
        Line& line =
            lines.emplace_back(Line{summary,
                                    class_recall_intervals(scored_rows(rows, summary.method)),
                                    place_in(answer, summary)});
        if (!shares.empty() && !summary.is_baseline) line.answer_share = shares[lines.size() - 1];
    }
    return table(comparison.measure() == Measure::soft_f).file(lines);
}

core::TableInfo kinds_table() {
    return kind_columns(true).info();
}

std::string kinds_csv(const std::vector<MethodSummary>& summaries) {
    std::vector<KindLine> lines;
    bool has_soft_f = false;
    for (const MethodSummary& summary : summaries) {
        const std::vector<KindSummary>& soft = summary.soft_f.kinds;  // of the same kinds, or none
        for (std::size_t i = 0; i < summary.f.kinds.size(); ++i) {
            lines.push_back({summary.method, summary.f.kinds[i]});
            if (!soft.empty()) lines.back().soft = soft[i];
        }
        has_soft_f = has_soft_f || !soft.empty();
    }
    return lines.empty() ? "" : kind_columns(has_soft_f).file(lines);
}

std::vector<Unscored> unscored_cells(const std::vector<harness::Row>& rows) {
    std::map<harness::Place, bool> has_score;  // of any method
    for (const harness::Row& row : rows) {
        if (harness::is_baseline(row.method)) continue;
        bool& has = has_score[harness::place_of(row)];
        has = has || row.is_ok();
    }
    std::vector<Unscored> cells;
    std::map<harness::Place, bool> is_named;
    for (const harness::Row& row : rows) {
        if (row.is_ok() || harness::is_baseline(row.method)) continue;
        const harness::Place place = harness::place_of(row);
        const bool is_whole_view = !has_score.at(place);
        if (is_whole_view && is_named[place]) continue;
        is_named[place] = true;
        cells.push_back(
            {row.scene, row.view, is_whole_view ? "" : row.method, row.status, remedy_of(row)});
    }
    return cells;
}

bool is_failure(const Unscored& cell) {
    return !cell.reason.starts_with("crowded");
}

bool is_all_unscored(const std::vector<harness::Row>& rows) {
    const auto is_of_method = [](const harness::Row& row) {
        return !harness::is_baseline(row.method);
    };
    return std::ranges::any_of(rows, is_of_method) &&
           std::ranges::none_of(
               rows, [&](const harness::Row& row) { return is_of_method(row) && row.is_ok(); });
}

const core::TableOf<Unscored>& unscored_table() {
    static const auto kTable = [] {
        core::TableOf<Unscored> table(
            "unscored.csv", "A view without any score, or a method without one on a view.");
        table.add({"scene", "", "the scene"}, &Unscored::scene);
        table.add({"view", "", "the view"}, &Unscored::view);
        table.add({"method", "", "the method; empty where the whole view has no score"},
                  &Unscored::method);
        table.add({"reason", "", "status of its rows"}, &Unscored::reason);
        table.add({"remedy", "", "what may help"}, &Unscored::remedy);
        return table;
    }();
    return kTable;
}

std::string unscored_text(const std::vector<Unscored>& cells) {
    std::string text;
    for (const Unscored& cell : cells) {
        text += fmt::format("no score: {} {}{}: {}\n    try: {}\n",
                            cell.scene,
                            cell.view,
                            cell.method.empty() ? "" : " " + cell.method,
                            cell.reason,
                            cell.remedy);
    }
    return text;
}

Measure Comparison::measure() const {
    const auto is_soft = [](const MethodSummary& s) { return s.measure() == Measure::soft_f; };
    return std::ranges::any_of(summaries, is_soft) ? Measure::soft_f : Measure::f_2px;
}

Comparison compare_methods(const std::vector<harness::Row>& rows, const AnswerRule& rule) {
    Comparison made{rule, summarise(rows)};
    const std::uint64_t seed = rows.empty() ? 0 : rows.front().seed;
    made.differences = all_paired_differences(rows, made.summaries, Measure::f_2px);
    made.soft_differences = all_paired_differences(rows, made.summaries, Measure::soft_f);
    made.shares = answer_shares(made.summaries, rule, seed);
    return made;
}

std::map<std::string, std::string> comparison_tables(const std::vector<harness::Row>& rows,
                                                     const Comparison& comparison) {
    std::map<std::string, std::string> tables = {
        {"summary.csv", summary_csv(rows, comparison)},
        {"differences.csv", differences_table().file(comparison.differences)}};
    if (comparison.measure() == Measure::soft_f)
        tables["soft_differences.csv"] = differences_table().file(comparison.soft_differences);
    return tables;
}

}  // namespace ink::summary
