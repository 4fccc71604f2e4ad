#include "report/stress_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/escape.h"
#include "core/whole_file.h"
#include "experiment/summary/summary.h"
#include "harness/out_folder.h"
#include "report/page_assets.h"
#include "report/stress_chart.h"

namespace ink::report {
namespace {

std::string fact(std::string_view name, const std::string& value) {
    return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, value);
}

std::string headline(const experiment::RunData& run, const studies::StressCounts& counts) {
    if (!run.record.missing_blocks.empty())
        return "Stopped before its end; what was finished is here";
    if (counts.is_clean()) {
        return "Nothing crashed, nothing overflowed, every number is finite, every image is the "
               "same that must be";
    }
    return "Something went wrong that must not: see the counts";
}

/// The axes that have rows, in the order of the design.
std::vector<const studies::StressAxis*> axes_of(const std::vector<studies::StressRow>& rows) {
    std::set<std::string> names;
    for (const studies::StressRow& row : rows)
        names.insert(row.axis);
    std::vector<const studies::StressAxis*> axes;
    for (const studies::StressAxis& axis : studies::stress_axes())
        if (names.contains(axis.name)) axes.push_back(&axis);
    return axes;
}

std::string facts_html(const std::vector<studies::StressRow>& rows,
                       const studies::StressCounts& counts) {
    std::set<std::string> methods;
    for (const studies::StressRow& row : rows)
        if (!harness::is_baseline(row.row.method)) methods.insert(row.row.method);
    return fmt::format("<dl class=\"facts\">{}{}{}{}{}{}{}</dl>",
                       fact("methods", std::to_string(methods.size())),
                       fact("axes", std::to_string(axes_of(rows).size())),
                       fact("cells", std::to_string(rows.size())),
                       fact("non-finite", std::to_string(counts.non_finite)),
                       fact("overflow", std::to_string(counts.overflow)),
                       fact("lost cells", std::to_string(counts.lost)),
                       fact("differing", std::to_string(counts.differing)));
}

/// An interrupted run says how much is missing.
std::string missing_html(const experiment::RunRecord& record) {
    if (record.missing_blocks.empty()) return "";
    return fmt::format(
        "<div class=\"warning\" role=\"alert\"><strong>This run is not finished.</strong> {} of {} "
        "parts are missing, the first is {}. The same command goes on where it stopped.</div>",
        record.missing_blocks.size(),
        record.blocks,
        core::escape(record.missing_blocks.front()));
}

/// Every cell that failed, once with its reason.
std::string lost_html(const std::vector<studies::StressRow>& rows) {
    std::set<std::string> items;
    for (const studies::StressRow& row : rows) {
        if (row.counts.lost == 0) continue;
        items.insert(fmt::format("<li>{} on {} {}: {}</li>",
                                 core::escape(row.row.method),
                                 core::escape(row.row.scene),
                                 core::escape(row.row.view),
                                 core::escape(row.row.status)));
    }
    if (items.empty()) return "";
    return fmt::format(
        "<div class=\"warning\" role=\"alert\"><strong>Lost cells</strong><ul>{}"
        "</ul></div>",
        fmt::join(items, ""));
}

std::string point_cell(const experiment::StressPointSummary& point) {
    if (!point.f) return "<td>–</td>";
    const std::string range =
        point.f_range
            ? fmt::format("{:.3f} to {:.3f}", 1 - point.f_range->high, 1 - point.f_range->low)
            : "one case";
    return fmt::format("<td title=\"{}\">{:.3f}</td>", range, *point.error());
}

std::string table_html(const studies::StressAxis& axis,
                       const std::vector<experiment::StressCurve>& curves) {
    std::string head = "<th scope=\"col\">method</th>";
    for (const experiment::StressPointSummary& point : curves.front().points) {
        head += fmt::format("<th scope=\"col\">{}</th>",
                            core::escape(experiment::format_stress_value(axis, point.value)));
    }
    std::string body;
    for (const experiment::StressCurve& curve : curves) {
        body += fmt::format("<tr{}><th scope=\"row\">{}</th>",
                            harness::is_baseline(curve.method) ? " class=\"baseline\"" : "",
                            core::escape(curve.method));
        for (const experiment::StressPointSummary& point : curve.points)
            body += point_cell(point);
        body += "</tr>\n";
    }
    return fmt::format(
        "<details class=\"counts\"><summary>Every error</summary><div "
        "class=\"scroll\"><table class=\"cause-table\"><thead><tr>{}</tr></thead>"
        "<tbody>{}</tbody></table></div></details>",
        head,
        body);
}

std::string counts_sentence(const std::vector<experiment::StressCurve>& curves) {
    studies::StressCounts counts;
    int cells = 0;
    for (const experiment::StressCurve& curve : curves) {
        for (const experiment::StressPointSummary& point : curve.points) {
            counts.add(point.counts);
            cells += point.cases;
        }
    }
    return fmt::format(
        "{} cells: {} numbers not finite, {} codes overflown, {} cells lost{}.",
        cells,
        counts.non_finite,
        counts.overflow,
        counts.lost,
        counts.differing > 0 ? fmt::format(", {} images that differ", counts.differing) : "");
}

std::string axis_html(const studies::StressAxis& axis,
                      const std::vector<experiment::StressPointSummary>& points) {
    const std::vector<experiment::StressCurve> curves =
        experiment::stress_curves(points, axis.name);
    if (curves.empty()) return "";
    return fmt::format(
        "<section id=\"{0}\"><h2>{0}</h2><p class=\"soft\">{1}</p>"
        "<div class=\"scroll chart\">{2}</div><p><strong>Measured.</strong> {3}</p>"
        "<p class=\"note\">{4}</p>{5}</section>\n",
        core::escape(axis.name),
        core::escape(axis.sentence),
        stress_chart(axis, curves).inline_element("Error against " + axis.title),
        core::escape(experiment::stress_sentence(axis, curves)),
        core::escape(counts_sentence(curves)),
        table_html(axis, curves));
}

std::string about_html(const experiment::RunData& run) {
    const harness::Row& first = run.tables.stress.front().row;
    return fmt::format(
        "<section id=\"about\"><h2>How to read this</h2><p>Error is 1 − F at 2 px, counts pooled "
        "over the cases of a point: two to four scenes, the same along an axis. Whiskers are 95 % "
        "intervals of the cluster bootstrap over these scenes; with so few they are wide and "
        "rough. Dotted: exact lines seen once per pixel centre, the ceiling of what looks at "
        "pixels. Dashed: tuned rows, in the colour of their base. Truth is of the polyhedron as "
        "given. Images are {} x {} px; nothing here is timed.</p>"
        "<p>Non-finite: vertices placed and projected, normals, full buffers in every depth "
        "encoding, the truth's curves, scores. Overflow: depths outside 0..1, and "
        "pixels at which a packed code that is made to fit its bits comes out otherwise "
        "when it may wrap. Rows are in <code>stress.csv</code>, points in "
        "<code>stress_summary.csv</code>.</p><dl class=\"terms\"><dt>command</dt><dd><code>{}"
        "</code></dd> <dt>build</dt><dd>{}</dd></dl></section>",
        first.width,
        first.height,
        core::escape(run.record.command),
        core::escape(run.record.build));
}

}  // namespace

std::string stress_page(const experiment::RunData& run) {
    const std::vector<studies::StressRow>& rows = run.tables.stress;
    const std::uint64_t seed = rows.empty() ? 0 : rows.front().row.seed;
    const std::vector<experiment::StressPointSummary> points =
        experiment::summarise_stress(rows, seed);
    const studies::StressCounts counts = experiment::total_counts(rows);
    std::string links;
    std::string body;
    for (const studies::StressAxis* axis : axes_of(rows)) {
        const std::string html = axis_html(*axis, points);
        if (html.empty()) continue;
        links += fmt::format("<a href=\"#{0}\">{0}</a>", core::escape(axis->name));
        body += html;
    }
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>Inkbench: stress</title>\n<style>{}</style></head>\n<body>\n"
        "<header><div class=\"wrap\"><div class=\"brand\">{}<span><strong>Inkbench</strong> · "
        "one difficulty at a time</span></div><h1>{}</h1>{}{}{}</div></header>\n"
        "<nav aria-label=\"Axes\"><div class=\"wrap\">{}<a href=\"#about\">How to read "
        "this</a></div></nav>\n<main class=\"wrap\">\n{}{}</main>\n</body></html>\n",
        page_style(),
        page_mark(),
        headline(run, counts),
        missing_html(run.record),
        facts_html(rows, counts),
        lost_html(rows),
        links,
        body,
        rows.empty() ? "" : about_html(run));
}

std::filesystem::path write_stress_page(const experiment::RunData& run,
                                        const std::filesystem::path& folder) {
    const std::vector<studies::StressRow>& rows = run.tables.stress;
    const std::uint64_t seed = rows.empty() ? 0 : rows.front().row.seed;
    const std::vector<experiment::StressPointSummary> points =
        experiment::summarise_stress(rows, seed);
    harness::make_out_folder(folder / "figures");
    for (const studies::StressAxis* axis : axes_of(rows)) {
        const std::vector<experiment::StressCurve> curves =
            experiment::stress_curves(points, axis->name);
        if (curves.empty()) continue;
        core::write_whole_file(folder / "figures" / fmt::format("stress_{}.svg", axis->name),
                               stress_chart(*axis, curves).file(axis->title));
    }
    const std::filesystem::path page = folder / "stress.html";
    core::write_whole_file(page, stress_page(run));
    return page;
}

}  // namespace ink::report
