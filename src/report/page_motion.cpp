#include "report/page_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/escape.h"
#include "experiment/summary/summary.h"
#include "report/motion_chart.h"

namespace ink::report {
namespace {

std::string chart(const Svg& svg, std::string_view title) {
    return fmt::format("<div class=\"scroll chart\">{}</div>", svg.inline_element(title));
}

std::string table(const std::string& head, const std::string& body) {
    return fmt::format(
        "<div class=\"scroll\"><table class=\"cause-table\"><thead><tr><th scope=\"col\">method"
        "</th>{}</tr></thead><tbody>{}</tbody></table></div>\n",
        head,
        body);
}

std::string heading(std::string_view text) {
    return fmt::format("<th scope=\"col\">{}</th>", text);
}

std::string line_start(const std::string& method) {
    return fmt::format("<tr{}><th scope=\"row\">{}</th>",
                       harness::is_baseline(method) ? " class=\"baseline\"" : "",
                       core::escape(method));
}

std::string per_mille(const std::optional<double>& share) {
    return share ? fmt::format("{:.2f}", 1000 * *share) : "–";
}

std::string life_legend() {
    std::string items = "<li class=\"soft\">False lines that lived</li>";
    for (const LifeClass& life : kLifeClasses) {
        items +=
            fmt::format("<li><i style=\"background:{}\"></i>{}</li>", life.colour.hex, life.label);
    }
    return fmt::format("<ul class=\"legend\">{}</ul>", items);
}

std::string totals_table(const std::vector<studies::MotionTotal>& totals) {
    std::string body;
    for (const studies::MotionTotal& t : totals) {
        const auto median = score::median_life(t.lives);
        const auto pops = t.pops.per_second(t.frames_per_s);
        body += line_start(t.method);
        body += fmt::format("<td>{}{}</td>",
                            t.sequences,
                            t.failed > 0 ? fmt::format("<small>{} failed</small>", t.failed) : "");
        body += fmt::format("<td>{}</td><td>{}</td><td>{}</td>",
                            per_mille(t.flicker.share()),
                            t.flicker.appeared + t.flicker.disappeared,
                            t.flicker.excused);
        body += fmt::format("<td>{}</td><td>{}<small>of {} features</small></td>",
                            pops ? fmt::format("{:.2f}", 60 * *pops) : "–",
                            t.pops.pops,
                            t.pops.runs);
        body += fmt::format("<td>{}</td><td>{}</td></tr>\n",
                            t.false_lines(),
                            median ? fmt::format("{:g}", *median) : "–");
    }
    return table(heading("sequences") + heading("flicker ‰") + heading("flicker px") +
                     heading("excused px") + heading("pops / min") + heading("pops") +
                     heading("false lines") + heading("median life, frames"),
                 body);
}

/// Flicker of every method on every sequence.
std::string sequence_table(const std::vector<studies::MotionRow>& rows,
                           const std::vector<studies::MotionTotal>& totals) {
    std::string head;
    for (const studies::MotionRow& row : rows) {
        if (row.method != rows.front().method) continue;
        head += fmt::format("<th scope=\"col\">{}<small>{}</small></th>",
                            core::escape(row.scene),
                            core::escape(row.path));
    }
    std::string body;
    for (const studies::MotionTotal& t : totals) {
        body += line_start(t.method);
        for (const studies::MotionRow& row : rows) {
            if (row.method != t.method) continue;
            body += row.is_ok() ? fmt::format("<td>{}</td>", per_mille(row.flicker.share()))
                                : fmt::format("<td title=\"{}\"><strong>failed</strong></td>",
                                              core::escape(row.status));
        }
        body += "</tr>\n";
    }
    return "<h3>Flicker by sequence</h3>" + table(head, body);
}

std::string sequences_html(const std::vector<studies::MotionRow>& rows) {
    if (rows.empty()) return "";
    const std::vector<studies::MotionTotal> totals = studies::motion_totals(rows);
    const studies::MotionRow& first = rows.front();
    return fmt::format(
               "<p class=\"note\">Sequences of {} frames at {} x {} px and {:g} a second; the "
               "picture moves by {:g} px a frame at most.</p>",
               first.frames,
               first.width_px,
               first.height_px,
               first.frames_per_s,
               first.step_px) +
           chart(motion_chart(totals), "Flicker, pops and false lines per method") + life_legend() +
           totals_table(totals) + sequence_table(rows, totals);
}

std::string angle(double angle_rad) {
    return fmt::format("{:.1f}°", angle_rad * 180 / std::numbers::pi);
}

/// What is left of a crease at an angle where no whole frame lost it.
std::string there(const studies::Vanishing& at) {
    return at.recall_there ? fmt::format("recall {:.2f} there", *at.recall_there) : "not drawn";
}

std::string vanishing_cell(const studies::RollCurve& curve) {
    if (!curve.is_predicted) return "<td>–</td>";
    if (curve.vanishing.empty()) {
        const bool is_blind = std::all_of(curve.samples.begin(),
                                          curve.samples.end(),
                                          [](const studies::RollSample& s) { return s.is_blind; });
        return is_blind ? "<td>at every angle</td>" : "<td>at none</td>";
    }
    std::string text;
    for (const studies::Vanishing& at : curve.vanishing) {
        text += fmt::format("{}{}<small>{}</small>",
                            text.empty() ? "" : " ",
                            angle(at.predicted_rad),
                            at.measured_rad ? "at " + angle(*at.measured_rad) : there(at));
    }
    return fmt::format("<td>{}</td>", text);
}

std::string crease_swatch(int crease) {
    return fmt::format(
        "<i style=\"background:{}\"></i>crease {}", colour_of_crease(crease).hex, crease + 1);
}

std::string roll_table(const std::vector<studies::RollCurve>& rolls) {
    std::string head;
    for (int crease = 0; crease < 3; ++crease)
        head += heading(crease_swatch(crease) + "<small>least, mean recall</small>");
    for (int crease = 0; crease < 3; ++crease)
        head += heading(crease_swatch(crease) + "<small>no step at, lost at</small>");
    std::string body;
    for (std::size_t i = 0; i < rolls.size();) {
        std::size_t end = i;
        while (end < rolls.size() && rolls[end].method == rolls[i].method)
            ++end;
        body += line_start(rolls[i].method);
        for (std::size_t k = i; k < end; ++k) {
            body += fmt::format(
                "<td>{:.2f}, {:.3f}</td>", rolls[k].least_recall(), rolls[k].mean_recall());
        }
        for (std::size_t k = i; k < end; ++k)
            body += vanishing_cell(rolls[k]);
        body += "</tr>\n";
        i = end;
    }
    return table(head, body);
}

std::string roll_html(const std::vector<studies::RollCurve>& rolls) {
    if (rolls.empty()) return "";
    return fmt::format(
               "<h3>The cube roll</h3><p class=\"note\">A camera rolls once round before a cube, "
               "in {} "
               "steps: the three seen creases keep their place on the cube and turn on the "
               "picture. Lines: "
               "how much of each is drawn. Dashed: the angles at which a method's declared weights "
               "make "
               "both sides of a crease equal, worked out from weights and geometry alone. Shaded: "
               "where "
               "the change is too small for its threshold. Dots: recall in a frame at the very "
               "angle; what is seen there is the kink of depth.</p>",
               rolls.front().samples.size()) +
           chart(roll_chart(rolls), "Recall of a cube's creases against the camera's roll") +
           roll_table(rolls);
}

}  // namespace

std::string_view motion_intro() {
    return "What a slowly moving camera shows of each method. Flicker: drawn pixels that come or "
           "go "
           "from one frame to the next with none within 2 px, unless a true line came or went "
           "there. Pop: a line of the same mesh edge and class that is shown, dropped and shown "
           "again while it is visible throughout. False lines: drawn further than 2 px from any "
           "true one; short lives flash, long ones stay.";
}

std::string motion_html(const std::vector<studies::MotionRow>& rows,
                        const std::vector<studies::RollCurve>& rolls) {
    return sequences_html(rows) + roll_html(rolls);
}

}  // namespace ink::report
