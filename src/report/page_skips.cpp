#include "report/page_skips.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/escape.h"
#include "experiment/summary/skip_totals.h"
#include "harness/skip_switches.h"
#include "report/verdict.h"

namespace ink::report {
namespace {

constexpr double kWorthwhile = 1.05;  // less is within what repeated runs differ by

std::string percent(double share) {
    if (share > 0 && share < 0.001) return "&lt; 0.1 %";
    return fmt::format("{:.1f} %", 100 * share);
}

std::string ms(std::int64_t ns) {
    return format_ms(static_cast<double>(ns) * 1e-6);
}

std::string total_cell(const experiment::SkipTotal& total, std::size_t skip) {
    if (total.most == nullptr) return "<td>–</td>";
    const double share = experiment::share_of(total.count);
    if (share == 0) return "<td>0</td>";
    const double most = experiment::share_of((*total.most->skips)[skip]);
    return fmt::format("<td>{}<small>{}<br>{}<br>{}</small></td>",
                       percent(share),
                       percent(most),
                       core::escape(total.most->scene),
                       core::escape(total.most->view));
}

std::string totals_table(const std::vector<experiment::SkipTotals>& totals) {
    std::string head;
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        head += fmt::format("<th scope=\"col\" title=\"{}\">{}<br><small>{}</small></th>",
                            info.summary,
                            info.name,
                            info.unit);
    }
    std::string body;
    for (const experiment::SkipTotals& t : totals) {
        body += fmt::format("<tr><th scope=\"row\">{}</th>", core::escape(t.method));
        for (std::size_t skip = 0; skip < t.of_skip.size(); ++skip)
            body += total_cell(t.of_skip[skip], skip);
        body += "</tr>\n";
    }
    return fmt::format(
        "<div class=\"scroll\"><table class=\"cause-table\"><thead><tr><th "
        "scope=\"col\">method</th>"
        "{}</tr></thead><tbody>{}</tbody></table></div>",
        head,
        body);
}

std::string terms() {
    std::string list;
    for (const raster::SkipInfo& info : raster::skip_infos())
        list += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", info.name, info.summary);
    return fmt::format("<dl class=\"terms\">{}</dl>", list);
}

/// Which skips were not allowed while rows were timed, if any two rows agree on it.
std::string forbidden_note(const std::vector<harness::Row>& rows) {
    std::set<std::string> forbidden;
    for (const harness::Row& row : rows) {
        if (row.skips) forbidden.insert(row.skips_off);
    }
    std::string note;
    for (std::string names : forbidden) {
        if (names.empty()) continue;
        for (auto at = names.find(';'); at != std::string::npos; at = names.find(';', at))
            names.replace(at, 1, ", ");
        note += fmt::format(
            "{}{}", note.empty() ? "Not allowed while these rows were timed: " : "; or ", names);
    }
    if (note.empty()) return "";
    return fmt::format(
        "<p class=\"note\">{}. Each view is drawn again and again to be timed, so tiles that stand "
        "still would make all but its first drawing nearly free: that skip is measured on a "
        "sequence.</p>",
        core::escape(note));
}

/// One scene with one method: the arms that were timed; null where one is missing.
struct Arms {
    const studies::SkipTime* on = nullptr;
    const studies::SkipTime* one_off = nullptr;
    const studies::SkipTime* all_off = nullptr;
};

Arms find_arms(const std::vector<studies::SkipTime>& study,
               const std::string& scene,
               const std::string& method) {
    Arms arms;
    for (const studies::SkipTime& t : study) {
        if (t.scene != scene || t.method != method) continue;
        if (t.arm == studies::SkipArm::on) arms.on = &t;
        if (t.arm == studies::SkipArm::one_off) arms.one_off = &t;
        if (t.arm == studies::SkipArm::all_off) arms.all_off = &t;
    }
    return arms;
}

bool is_timed(const studies::SkipTime* time) {
    return time != nullptr && time->status == "ok" && time->draw_ns_min;
}

/// How many times as fast a frame is with skips as without, by their minima, and both times.
std::string gain(const studies::SkipTime& with, const studies::SkipTime& without) {
    const double ratio =
        static_cast<double>(*without.draw_ns_min) / static_cast<double>(*with.draw_ns_min);
    const bool is_worth_it = ratio >= kWorthwhile;
    return fmt::format("{}× {:.{}f}{}<small>{} → {} ms</small>",
                       is_worth_it ? "<b>" : "",
                       ratio,
                       ratio < 10 ? 2 : 0,
                       is_worth_it ? "</b>" : "",
                       ms(*without.draw_ns_min),
                       ms(*with.draw_ns_min));
}

std::string failed_cell(const Arms& arms) {
    for (const studies::SkipTime* time : {arms.on, arms.one_off, arms.all_off}) {
        if (time != nullptr && time->status != "ok") {
            return fmt::format("<td title=\"{}\"><strong>failed</strong></td>",
                               core::escape(time->status));
        }
    }
    return "<td>–</td>";
}

std::string worth_cell(const Arms& arms) {
    if (!is_timed(arms.on) || !is_timed(arms.all_off)) return failed_cell(arms);
    if (arms.one_off == nullptr) return fmt::format("<td>{}</td>", gain(*arms.on, *arms.all_off));
    if (!is_timed(arms.one_off)) return failed_cell(arms);
    const raster::SkipCount& count = arms.on->counts[static_cast<std::size_t>(*arms.on->skip)];
    if (count.of == 0) return "<td title=\"this method has nothing of the kind to skip\">–</td>";
    // Times of work that is the same in both arms differ by chance alone: no factor then.
    const std::string worth = count.skipped == 0
                                  ? fmt::format("0<small>{} ms</small>", ms(*arms.on->draw_ns_min))
                                  : gain(*arms.on, *arms.one_off);
    const std::string share = count.skipped == 0 ? "nothing" : percent(experiment::share_of(count));
    return fmt::format("<td>{}<small>{} skipped<br>no skips: {} ms</small></td>",
                       worth,
                       share,
                       ms(*arms.all_off->draw_ns_min));
}

/// A line of the study's tables: what stands at its left.
struct StudyLine {
    std::string scene;
    std::string heading;  ///< HTML, as the next
    std::string content;  ///< what there is to see
};

std::string study_table(const std::vector<studies::SkipTime>& study,
                        const std::vector<StudyLine>& lines,
                        std::string_view corner) {
    std::vector<std::string> methods;
    for (const studies::SkipTime& t : study) {
        if (std::find(methods.begin(), methods.end(), t.method) == methods.end()) {
            methods.push_back(t.method);
        }
    }
    std::string head;
    for (const std::string& method : methods)
        head += fmt::format("<th scope=\"col\">{}</th>", core::escape(method));
    std::string body;
    for (const StudyLine& line : lines) {
        body += fmt::format(
            "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td>", line.heading, line.content);
        for (const std::string& method : methods)
            body += worth_cell(find_arms(study, line.scene, method));
        body += "</tr>\n";
    }
    return fmt::format(
        "<div class=\"scroll\"><table class=\"cause-table\"><thead><tr><th scope=\"col\">{}</th>"
        "<td class=\"text\">on</td>{}</tr></thead><tbody>{}</tbody></table></div>",
        corner,
        head,
        body);
}

/// The scenes of the study, those of one skip or those of the three views, in order.
std::vector<StudyLine> study_lines(const std::vector<studies::SkipTime>& study, bool of_one_skip) {
    std::vector<StudyLine> lines;
    for (const studies::SkipTime& t : study) {
        if (t.skip.has_value() != of_one_skip) continue;
        if (!lines.empty() && lines.back().scene == t.scene) continue;
        const std::string triangles = fmt::format("{} triangles", t.triangles);
        if (of_one_skip) {
            const auto& info = raster::skip_infos()[static_cast<std::size_t>(*t.skip)];
            lines.push_back({t.scene,
                             std::string(info.name),
                             fmt::format("{}<small>{}</small>", core::escape(t.scene), triangles)});
        } else {
            lines.push_back({t.scene, core::escape(t.scene), triangles});
        }
    }
    return lines;
}

std::string study_html(const std::vector<studies::SkipTime>& study) {
    if (study.empty()) {
        return "<p class=\"note\">What each skip is worth in time was not measured: "
               "<code>--skip-study</code> does.</p>";
    }
    std::string html =
        "<h3>What each is worth</h3><p class=\"note\">One scene per skip, made for it. How many "
        "times as fast a frame is with it as without it (least times, without → with), everything "
        "else skipped in both; then what share it left out, and the time with no skip at all. The "
        "pictures were compared bit for bit. Bold: 1.05 and more.</p>";
    html += study_table(study, study_lines(study, true), "skip");
    html +=
        "<h3>An empty view, a small object, a full view</h3><p class=\"note\">One object, seen "
        "from three places. How many times as fast a frame is with all skips as with none.</p>";
    html += study_table(study, study_lines(study, false), "view");
    return html;
}

}  // namespace

std::string_view skips_intro() {
    return "What was left undone because the picture does not need it: the share over all cells, "
           "and below it the largest in one cell and where that was. A skip never changes a bit of "
           "a picture.";
}

std::string skips_html(const std::vector<harness::Row>& rows,
                       const std::vector<studies::SkipTime>& study) {
    const std::vector<experiment::SkipTotals> totals = experiment::skip_totals(rows);
    if (totals.empty()) return "";
    return totals_table(totals) + terms() + forbidden_note(rows) + study_html(study);
}

}  // namespace ink::report
