#include "report/page_scenes.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/escape.h"
#include "core/text_table.h"
#include "draw/palette.h"
#include "experiment/summary/summary.h"
#include "report/page_causes.h"
#include "report/page_tables.h"
#include "report/verdict.h"

namespace ink::report {
namespace {

const harness::Row* find_row(const std::vector<harness::Row>& rows,
                             const harness::ShownView& view,
                             const std::string& method) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const harness::Row& row) {
        return row.scene == view.scene && row.view == view.view && row.method == method;
    });
    return found == rows.end() ? nullptr : &*found;
}

/// "F .912 · 3.10 ms", and what went wrong below.
std::string words_on(const harness::Row* row) {
    if (row == nullptr) return "";
    std::string line = "F " + core::format_share(row->f_2px);
    if (row->draw_ns)
        line += fmt::format(" · {} ms", format_ms(static_cast<double>(*row->draw_ns) * 1e-6));
    return fmt::format("<span>{}</span><span>{} false negatives, {} false positives</span>",
                       line,
                       row->false_negatives,
                       row->false_positives);
}

std::string alt_of(const harness::ShownView& view,
                   const PagePicture& image,
                   const harness::Row* row) {
    const std::string place = fmt::format("{}, view {}", view.scene, view.view);
    if (image.method.empty()) return core::escape("True lines of " + place + ", coloured by class");
    std::string text = fmt::format("Lines of {} on {}, errors in colour", image.method, place);
    if (row != nullptr && row->is_ok()) {
        text += fmt::format(": F {}, {} false negatives, {} false positives",
                            core::format_share(row->f_2px),
                            row->false_negatives,
                            row->false_positives);
    }
    return core::escape(text);
}

std::string swatch(const draw::Colour& colour, std::string_view words) {
    return fmt::format("<li><i style=\"background:{}\"></i>{}</li>", colour.hex, words);
}

std::string legend_html() {
    std::string truth_colours;
    for (const truth::LineClass c : truth::kLineClasses)
        truth_colours += swatch(draw::colour_of(c), truth::name(c));
    return fmt::format(
        "<ul class=\"legend\" aria-label=\"Colours of methods' pictures\">{}{}</ul>{}"
        "<ul class=\"legend\" aria-label=\"Colours of the truth\"><li class=\"soft\">Truth:</li>{}"
        "</ul>",
        swatch(draw::kHitColour, "right, within 2 px of a true line"),
        swatch(draw::kIgnoredColour, "not counted: crowded, or at the frame"),
        cause_legend_html(),
        truth_colours);
}

/// Which picture of a scene is seen at first; 0, the truth, if there is no other.
std::size_t first_shown(const PageScene& scene, const std::string& first_method) {
    for (std::size_t i = 1; i < scene.images.size(); ++i) {
        if (scene.images[i].method == first_method) return i;
    }
    return scene.images.size() > 1 ? 1 : 0;
}

std::string tools_html(const PageScenes& scenes, const std::string& first_method) {
    std::vector<std::string> methods;
    for (const PageScene& scene : scenes.scenes) {
        for (const PagePicture& image : scene.images) {
            const bool is_known =
                std::find(methods.begin(), methods.end(), image.method) != methods.end();
            if (!image.method.empty() && !is_known) methods.push_back(image.method);
        }
    }
    std::string options;
    for (const std::string& method : methods)
        options += fmt::format("<option{}>{}</option>",
                               method == first_method ? " selected" : "",
                               core::escape(method));
    return fmt::format(
        "<div class=\"tools\"><label>In every scene show <select id=\"pick-method\">{}</select>"
        "</label><label>Layout <select id=\"pick-layout\"><option value=\"slide\">divider"
        "</option><option value=\"pair\">side by side</option></select></label>"
        "<label>Zoom <select id=\"pick-zoom\"><option value=\"1\">fit</option><option "
        "value=\"2\">2 ×</option><option value=\"4\">4 ×</option></select></label></div>",
        options);
}

std::string stage_html(const PageScene& scene,
                       const std::vector<harness::Row>& rows,
                       std::size_t shown) {
    const harness::ShownView& view = *scene.view;
    std::string images;
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        const PagePicture& image = scene.images[i];
        const harness::Row* row = find_row(rows, view, image.method);
        const std::string kind = i == 0 ? "truth" : i == shown ? "pred on" : "pred";
        images += fmt::format(R"(<img class="{}" data-method="{}" alt="{}" src="{}">)",
                              kind,
                              core::escape(image.method),
                              alt_of(view, image, row),
                              image.whole);
    }
    const bool has_methods = scene.images.size() > 1;
    const std::string range = fmt::format(
        R"(<input type="range" min="0" max="100" step="1" value="50" aria-label="Divider between truth, left, and method, right, on {}">)",
        core::escape(view.scene));
    return fmt::format(
        "<figure><div class=\"view\" style=\"aspect-ratio:{} / {}\"><div "
        "class=\"frame\">{}{}</div></div>{}<figcaption "
        "class=\"side\"><span>truth, coloured by class</span><span class=\"right\">{}</span>"
        "</figcaption></figure>",
        view.labels.width_px(),
        view.labels.height_px(),
        images,
        has_methods ? "<span class=\"grip\" aria-hidden=\"true\"></span>" : "",
        has_methods ? range : "",
        has_methods ? core::escape(scene.images[shown].method) + ", errors in colour" : "");
}

std::string picker_html(const PageScene& scene,
                        const std::vector<harness::Row>& rows,
                        const std::string& anchor,
                        std::size_t shown) {
    std::string choices;
    for (std::size_t i = 1; i < scene.images.size(); ++i) {
        const PagePicture& image = scene.images[i];
        choices += fmt::format(
            R"(<label><input type="radio" name="{}" value="{}"{}><img alt="" src="{}"><span><b>{}</b>{}</span></label>)",
            anchor,
            core::escape(image.method),
            i == shown ? " checked" : "",
            image.thumb,
            core::escape(image.method),
            words_on(find_row(rows, *scene.view, image.method)));
    }
    if (choices.empty()) return "<p class=\"note\">No method drew this view.</p>";
    return fmt::format(
        "<fieldset class=\"picker\"><legend>Compare the truth with</legend>{}</fieldset>", choices);
}

/// The counts behind the colours of one view, folded away.
std::string counts_html(const harness::ShownView& view, const std::vector<harness::Row>& rows) {
    std::vector<const harness::Row*> of_view;
    for (const harness::Row& row : rows) {
        if (row.scene == view.scene && row.view == view.view) of_view.push_back(&row);
    }
    return fmt::format(
        "<details class=\"counts\"><summary>Counts behind the colours</summary>{}</details>",
        cause_table_html(experiment::cause_totals(of_view)));
}

std::string scene_html(const PageScene& scene,
                       const std::vector<harness::Row>& rows,
                       const std::string& anchor,
                       const std::string& first_method) {
    const std::size_t shown = first_shown(scene, first_method);
    const harness::ShownView& view = *scene.view;
    const auto any = std::find_if(rows.begin(), rows.end(), [&](const harness::Row& row) {
        return row.scene == view.scene && row.view == view.view;
    });
    const std::string facts =
        any == rows.end() ? ""
                          : fmt::format(
                                "<span class=\"tag\">{}</span><span class=\"note\">{} × {} px, "
                                "{} triangles</span>",
                                any->split == "train" ? "training" : "held-out",
                                any->width,
                                any->height,
                                any->triangles);
    return fmt::format(
        "<article class=\"scene\" id=\"{}\"><div><h3>{}</h3><span class=\"note\">view {}</span>{}"
        "</div><div class=\"stage\">{}{}</div>{}</article>\n",
        anchor,
        core::escape(view.scene),
        core::escape(view.view),
        facts,
        stage_html(scene, rows, shown),
        picker_html(scene, rows, anchor, shown),
        counts_html(view, rows));
}

std::string room_note(const PageScenes& scenes) {
    std::string note =
        "Lines of the truth and missing ones are drawn two pixels wide, so that they "
        "are seen; what a method drew has its own width. ";
    if (scenes.shrink_factor > 1) {
        note += fmt::format(
            "To keep this page small, pictures are shown at 1/{} of their size; of "
            "each block the worst pixel is kept, so errors look thicker than they "
            "are. ",
            scenes.shrink_factor);
    }
    if (scenes.left_out > 0) {
        note += fmt::format("{} more scene{} had no room here; the strips are beside this page.",
                            scenes.left_out,
                            scenes.left_out == 1 ? "" : "s");
    }
    return fmt::format("<p class=\"note\">{}</p>", note);
}

}  // namespace

std::vector<std::string> pictured_scenes(const PageScenes& scenes) {
    std::vector<std::string> names;
    for (const PageScene& scene : scenes.scenes)
        names.push_back(scene.view->scene);
    return names;
}

std::string scenes_html(const PageScenes& scenes,
                        const std::vector<harness::Row>& rows,
                        const std::string& first_method) {
    if (scenes.scenes.empty()) return "<p class=\"note\">No view was drawn.</p>";
    std::string html = legend_html() + tools_html(scenes, first_method) + room_note(scenes);
    for (std::size_t i = 0; i < scenes.scenes.size(); ++i)
        html += scene_html(scenes.scenes[i], rows, fmt::format("scene-{}", i + 1), first_method);
    return html;
}

}  // namespace ink::report
