#include "report/page_witness.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/escape.h"
#include "draw/witness_report.h"

namespace ink::report {
namespace {

bool is_disputed(const harness::Row& row) {
    return row.status.starts_with("truth_disputed");
}

/// The views of one scene that were held against the witness.
struct SceneViews {
    std::string scene;
    std::set<std::string> views;
    std::set<std::string> disputed;
    const harness::Row* worst = nullptr;
};

/// In order of first appearance.
std::vector<SceneViews> views_of_scenes(const std::vector<harness::Row>& rows) {
    std::vector<SceneViews> scenes;
    for (const harness::Row& row : rows) {
        if (!row.witness_disagreement) continue;
        auto at = std::find_if(scenes.begin(), scenes.end(), [&](const SceneViews& s) {
            return s.scene == row.scene;
        });
        if (at == scenes.end()) {
            scenes.push_back({row.scene, {}, {}, &row});
            at = scenes.end() - 1;
        }
        at->views.insert(row.view);
        if (is_disputed(row)) at->disputed.insert(row.view);
        if (*row.witness_disagreement > *at->worst->witness_disagreement) at->worst = &row;
    }
    return scenes;
}

std::string scene_line(const SceneViews& s) {
    const std::string status =
        s.disputed.empty() ? "agreed" : fmt::format("<b>disputed in {}</b>", s.disputed.size());
    return fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"text\">{}</td><td>{:.3f}</td>"
        "<td>{:.0f}</td><td class=\"text\">{}</td></tr>\n",
        core::escape(s.scene),
        s.views.size(),
        core::escape(s.worst->view),
        100 * *s.worst->witness_disagreement,
        s.worst->witness_px,
        status);
}

std::string disputed_html(const std::vector<SceneViews>& scenes) {
    std::string items;
    for (const SceneViews& s : scenes) {
        for (const std::string& view : s.disputed)
            items += fmt::format("<li>{}, view {}</li>", core::escape(s.scene), core::escape(view));
    }
    if (items.empty()) return "";
    return fmt::format(
        "<div class=\"warning\"><strong>Disputed truths.</strong> No method is scored on these "
        "views:<ul>{}</ul></div>",
        items);
}

}  // namespace

std::string witness_html(const std::vector<harness::Row>& rows) {
    const std::vector<SceneViews> scenes = views_of_scenes(rows);
    if (scenes.empty()) return "";
    std::string body;
    for (const SceneViews& s : scenes)
        body += scene_line(s);
    return fmt::format(
        "<p>{}</p>{}<div class=\"scroll\"><table><thead><tr><th scope=\"col\">scene</th>"
        "<th scope=\"col\">views</th><th scope=\"col\" class=\"text\">worst view</th>"
        "<th scope=\"col\">disagreement %</th><th scope=\"col\">of lines px, both ways</th>"
        "<th scope=\"col\" class=\"text\">status</th></tr></thead><tbody>{}</tbody></table></div>",
        core::escape(draw::witness_sentence(rows)),
        disputed_html(scenes),
        body);
}

}  // namespace ink::report
