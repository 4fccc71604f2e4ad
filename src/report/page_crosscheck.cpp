#include "report/page_crosscheck.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/escape.h"
#include "draw/crosscheck_report.h"

namespace ink::report {
namespace {

bool is_in_disagreement(const harness::Row& row) {
    return row.status.starts_with("reference_disagreement");
}

/// The views of one scene that were held against the cross-check.
struct CheckedScene {
    std::string scene;
    std::set<std::string> views;
    std::set<std::string> disagreeing;
    const harness::Row* worst = nullptr;
};

/// In order of first appearance.
std::vector<CheckedScene> views_of_scenes(const std::vector<harness::Row>& rows) {
    std::vector<CheckedScene> scenes;
    for (const harness::Row& row : rows) {
        if (!row.reference_disagreement) continue;
        auto at = std::find_if(scenes.begin(), scenes.end(), [&](const CheckedScene& s) {
            return s.scene == row.scene;
        });
        if (at == scenes.end()) {
            scenes.push_back({row.scene, {}, {}, &row});
            at = scenes.end() - 1;
        }
        at->views.insert(row.view);
        if (is_in_disagreement(row)) at->disagreeing.insert(row.view);
        if (*row.reference_disagreement > *at->worst->reference_disagreement) at->worst = &row;
    }
    return scenes;
}

std::string scene_line(const CheckedScene& s) {
    const std::string status = s.disagreeing.empty()
                                   ? "agreed"
                                   : fmt::format("<b>disagreement in {}</b>", s.disagreeing.size());
    return fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"text\">{}</td><td>{:.3f}</td>"
        "<td>{:.0f}</td><td class=\"text\">{}</td></tr>\n",
        core::escape(s.scene),
        s.views.size(),
        core::escape(s.worst->view),
        100 * *s.worst->reference_disagreement,
        s.worst->crosscheck_px,
        status);
}

std::string disagreement_html(const std::vector<CheckedScene>& scenes) {
    std::string items;
    for (const CheckedScene& s : scenes) {
        for (const std::string& view : s.disagreeing)
            items += fmt::format("<li>{}, view {}</li>", core::escape(s.scene), core::escape(view));
    }
    if (items.empty()) return "";
    return fmt::format(
        "<div class=\"warning\"><strong>Reference disagreement.</strong> No method is scored on "
        "these "
        "views:<ul>{}</ul></div>",
        items);
}

}  // namespace

std::string crosscheck_html(const std::vector<harness::Row>& rows) {
    const std::vector<CheckedScene> scenes = views_of_scenes(rows);
    if (scenes.empty()) return "";
    std::string body;
    for (const CheckedScene& s : scenes)
        body += scene_line(s);
    return fmt::format(
        "<p>{}</p>{}<div class=\"scroll\"><table><thead><tr><th scope=\"col\">scene</th>"
        "<th scope=\"col\">views</th><th scope=\"col\" class=\"text\">worst view</th>"
        "<th scope=\"col\">disagreement %</th><th scope=\"col\">of lines px, both ways</th>"
        "<th scope=\"col\" class=\"text\">status</th></tr></thead><tbody>{}</tbody></table></div>",
        core::escape(draw::crosscheck_sentence(rows)),
        disagreement_html(scenes),
        body);
}

}  // namespace ink::report
