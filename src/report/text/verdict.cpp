#include "report/text/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "core/text_table.h"
#include "harness/clock/timing.h"
#include "inspect/crosscheck_report.h"
#include "statistics/bootstrap.h"

namespace ink::report {
namespace {

/// "36", or "35/36" where a cell failed.
std::string views_of(const summary::MethodSummary& s) {
    const std::string views = fmt::format("{}", s.views);
    return s.failed == 0 ? views : fmt::format("{}/{}", views, s.views + s.failed);
}

/// ".881-.932"; "-" for nothing.
std::string format_range(const std::optional<statistics::Interval>& range) {
    return range ? core::format_share(range->low) + "-" + core::format_share(range->high) : "-";
}

/// Whole, so that it can be copied.
std::string name_of(const summary::MethodSummary& s) {
    if (s.is_baseline) return s.method + " *";
    return s.method + (s.has_own_clock ? " +" : "");
}

/// What the intervals of methods are worth.
int coverage_percent(const summary::Comparison& comparison) {
    int scenes = 0;
    for (const summary::MethodSummary& s : comparison.summaries)
        scenes = std::max(scenes, s.scenes);
    return statistics::known_coverage_percent(scenes);
}

/// What methods are judged by stands first, with its interval and parts; F after soft F.
core::Cells cells_of(const summary::Comparison& comparison) {
    const bool is_soft = comparison.measure() == summary::Measure::soft_f;
    const char* const judged = is_soft ? "soft F" : "F 2px";
    constexpr std::ptrdiff_t kAfterParts = 6;
    core::Cells cells = {{"method",
                          judged,
                          fmt::format("{} %", coverage_percent(comparison)),
                          "train",
                          "held-out",
                          "real",
                          "draw ms",
                          "B/px",
                          "views"}};
    if (is_soft) cells.front().insert(cells.front().begin() + kAfterParts, "F 2px");
    for (const summary::MethodSummary& s : comparison.summaries) {
        const summary::FSummary& f = s.by(comparison.measure());
        cells.push_back({name_of(s),
                         core::format_share(f.all),
                         format_range(f.range),
                         core::format_share(f.train),
                         core::format_share(f.heldout),
                         core::format_share(f.real),
                         format_ms(s.draw_ms),
                         s.bytes_per_px ? fmt::format("{}", *s.bytes_per_px) : "-",
                         views_of(s)});
        if (!is_soft) continue;
        cells.back().insert(cells.back().begin() + kAfterParts, core::format_share(s.f.all));
    }
    return cells;
}

/// What the marks behind names mean.
std::string marks(const std::vector<summary::MethodSummary>& summaries) {
    const bool has_own_clock =
        std::ranges::any_of(summaries, [](const auto& s) { return s.has_own_clock; });
    return std::string("`*` a baseline, no method") +
           (has_own_clock ? "; `+` from outside: images made elsewhere, times by their own clock"
                          : "");
}

/// On which parts of the suite the verdict holds: the best method of each part, or which the only
/// part is.
std::string by_part(const summary::Comparison& comparison) {
    using F = summary::FSummary;
    struct Part {
        const char* name;
        std::optional<double> F::*f;
    };
    constexpr Part kParts[] = {{"training scenes", &F::train},
                               {"held-out scenes", &F::heldout},
                               {"real models", &F::real}};
    const summary::Measure measure = comparison.measure();
    std::vector<std::string> texts;
    const char* only = "";
    for (const Part& part : kParts) {
        const summary::MethodSummary* best = nullptr;
        const auto f_of = [&](const summary::MethodSummary& s) { return s.by(measure).*part.f; };
        for (const summary::MethodSummary& s : comparison.summaries) {
            if (s.is_baseline || !f_of(s)) continue;
            if (best == nullptr || *f_of(s) > *f_of(*best)) best = &s;
        }
        if (best == nullptr) continue;
        only = part.name;
        texts.push_back(fmt::format("{} on {} ({} {})",
                                    best->method,
                                    part.name,
                                    measure_text(measure),
                                    core::format_share(f_of(*best))));
    }
    if (texts.empty()) return "";
    if (texts.size() == 1) return fmt::format(" It holds for {}: no others took part.", only);
    return fmt::format(" Best by part: {}.", fmt::join(texts, ", "));
}

std::string failures(const std::vector<summary::MethodSummary>& summaries) {
    int failed = 0;
    for (const summary::MethodSummary& s : summaries)
        failed += s.failed;
    if (failed == 0) return "";
    return fmt::format(" {} cell{} no score and no part in these numbers.",
                       failed,
                       failed == 1 ? " has" : "s have");
}

/// The baseline that sees as much of a pixel as a method of one sample a pixel, by where its rows
/// say that it samples.
const char* baseline_of(const std::string& method, const std::vector<harness::Row>& rows) {
    const auto of_method = [&](const harness::Row& row) { return row.method == method; };
    const auto row = std::ranges::find_if(rows, of_method);
    const bool has_corners =
        row != rows.end() &&
        (";" + row->params + ";").find(";samples=corner;") != std::string::npos;
    return has_corners ? "exact_corner" : "sampled";
}

/// A warning that names the methods of one sample a pixel that score above `baseline`, which
/// samples where they do; empty if there is none. They do so by luck or by width: what passes
/// between the samples shows in neither.
std::string sample_warning(const char* baseline,
                           const std::vector<harness::Row>& rows,
                           const std::vector<summary::MethodSummary>& summaries) {
    const auto exact = std::ranges::find_if(summaries, [&](const summary::MethodSummary& s) {
        return s.method == baseline && s.f.all;
    });
    if (exact == summaries.end()) return "";
    std::string better;
    for (const summary::MethodSummary& s : summaries) {
        const bool is_better = s.f.all && *s.f.all > *exact->f.all;
        if (s.is_baseline || !is_better || !summary::takes_one_sample(s.method)) continue;
        if (std::string_view(baseline_of(s.method, rows)) != baseline) continue;
        better += fmt::format(
            "{}{} (F {})", better.empty() ? "" : ", ", s.method, core::format_share(s.f.all));
    }
    if (better.empty()) return "";
    return fmt::format(
        "Warning: {} above `{}` (F {}), one exact sample a pixel. Some things here "
        "are thinner than a pixel: one sample finds them by chance, so other views may score less.",
        better,
        baseline,
        core::format_share(exact->f.all));
}

/// Names the methods whose error sits in one scene, for their F is known less well than it seems;
/// empty if there is none.
std::string error_scenes(const std::vector<summary::MethodSummary>& summaries) {
    std::vector<std::string> texts;
    for (const summary::MethodSummary& s : summaries) {
        if (s.is_baseline || !summary::is_error_in_one_scene(s)) continue;
        const summary::FSummary& f = s.judged();
        texts.push_back(
            fmt::format("{} {:.0f} % in {}", s.method, 100 * *f.error_scene_share, f.error_scene));
    }
    if (texts.empty()) return "";
    return fmt::format("Most of the error in one scene: {}.", fmt::join(texts, ", "));
}

/// A warning that names the view in which rounding of coordinates shows most; empty if in none.
std::string rounding_warning(const std::vector<harness::Row>& rows) {
    const auto most = std::ranges::max_element(
        rows, [](auto& a, auto& b) { return a.rounding_px < b.rounding_px; });
    if (most == rows.end() || !most->shows_rounding()) return "";
    std::set<std::pair<std::string, std::string>> views;
    for (const harness::Row& row : rows)
        if (row.shows_rounding()) views.insert({row.scene, row.view});
    return fmt::format(
        "Warning: in {} view{} rounding of coordinates may move lines visibly, by {:.3g} px in {} "
        "of {}; a file with more digits, or nearer to its origin, has it right (`rounding_px` in "
        "rows.csv).",
        views.size(),
        views.size() == 1 ? "" : "s",
        most->rounding_px,
        most->view,
        most->scene);
}

/// What stands below the verdict's sentence, each a line of its own.
std::vector<std::string> warnings(const std::vector<harness::Row>& rows,
                                  const std::vector<summary::MethodSummary>& summaries) {
    std::vector<std::string> lines = {error_scenes(summaries),
                                      sample_warning("sampled", rows, summaries),
                                      sample_warning("exact_corner", rows, summaries),
                                      inspect::crosscheck_sentence(rows),
                                      rounding_warning(rows)};
    std::erase(lines, "");
    return lines;
}

/// How many scenes and views of the run have a score, where some have none.
std::string scored_text(const std::vector<harness::Row>& rows, const summary::MethodSummary& most) {
    std::set<std::string> scenes;
    std::set<harness::Place> places;
    for (const harness::Row& row : rows) {
        scenes.insert(row.scene);
        places.insert(harness::place_of(row));
    }
    const auto of_all = [](int count, std::size_t all, const char* what) {
        const bool is_whole = static_cast<std::size_t>(count) == all;
        return fmt::format("{}{} {}{}",
                           count,
                           is_whole ? "" : fmt::format(" of {}", all),
                           what,
                           all == 1 ? "" : "s");
    };
    return of_all(most.views, places.size(), "view") + " of " +
           of_all(most.scenes, scenes.size(), "scene");
}

/// Over what the answer is, on which parts it holds, how many cells failed.
std::string extent_sentences(const std::vector<harness::Row>& rows,
                             const summary::Comparison& comparison) {
    const summary::MethodSummary* most = summary::find_answer(comparison.summaries, {}).most_exact;
    if (most == nullptr) return failures(comparison.summaries);
    const summary::Measure measure = comparison.measure();
    return fmt::format(" {} is {}, over {} pooled.{}{}",
                       measure == summary::Measure::soft_f ? "Soft F" : "F",
                       measure_extent(rows, measure),
                       scored_text(rows, *most),
                       by_part(comparison),
                       failures(comparison.summaries));
}

/// What must be known before any number is read; "" of a finished run.
std::string unfinished_line(const Missing& missing) {
    if (missing.missing_parts == 0) return "";
    return fmt::format(
        "This run is not finished: {} of {} parts are missing, and every number is of the "
        "rest.\n\n",
        missing.missing_parts,
        missing.parts);
}

}  // namespace

std::string verdict_table(const std::vector<harness::Row>& rows,
                          const summary::Comparison& comparison,
                          const Missing& missing) {
    const std::vector<summary::MethodSummary>& summaries = comparison.summaries;
    const std::string sentence =
        answer_text(rows, comparison, Markup::none).whole() + extent_sentences(rows, comparison);
    if (summaries.empty()) return sentence;
    std::string text = fmt::format("{}{}{}\n\n{}",
                                   unfinished_line(missing),
                                   core::aligned(cells_of(comparison)),
                                   marks(summaries),
                                   sentence);
    for (const std::string& line : warnings(rows, summaries))
        text += "\n" + line;
    return text;
}

std::string verdict_markdown(const std::vector<harness::Row>& rows,
                             const summary::Comparison& comparison,
                             const Missing& missing) {
    const std::vector<summary::MethodSummary>& summaries = comparison.summaries;
    const std::string sentence = answer_text(rows, comparison, Markup::markdown).whole() +
                                 extent_sentences(rows, comparison);
    if (summaries.empty()) return sentence + "\n";
    std::string text = fmt::format("{}{}\n{}\n\n{}\n",
                                   unfinished_line(missing),
                                   core::markdown(cells_of(comparison)),
                                   marks(summaries),
                                   sentence);
    const std::string paper = paper_sentence(rows, comparison);
    if (!paper.empty()) text += "\nFor a paper: " + paper + "\n";
    for (const std::string& line : warnings(rows, summaries))
        text += "\n" + line + "\n";
    // On the terminal it stands among the warnings of the run.
    const std::string busy = harness::uncertain_times(rows);
    if (!busy.empty()) text += "\n" + busy + ".\n";
    return text;
}

VerdictWords verdict_words(const std::vector<harness::Row>& rows,
                           const summary::Comparison& comparison) {
    const std::string extent = extent_sentences(rows, comparison);
    return {answer_text(rows, comparison, Markup::none),
            extent.empty() ? "" : extent.substr(1),
            paper_sentence(rows, comparison),
            fmt::format("{} % interval", coverage_percent(comparison)),
            warnings(rows, comparison.summaries)};
}

}  // namespace ink::report
