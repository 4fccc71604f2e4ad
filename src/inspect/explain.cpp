#include "inspect/explain.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/trigonometric.hpp>

#include "core/error.h"
#include "harness/cells/cell.h"
#include "scene/scene_statistics.h"

namespace ink::inspect {
namespace {

Fact count(std::string name, std::size_t value, std::string unit, std::string doc) {
    return {std::move(name), static_cast<double>(value), std::move(unit), std::move(doc)};
}

Fact flag(std::string name, bool value, std::string doc) {
    return {std::move(name), value ? 1.0 : 0.0, "", std::move(doc), true};
}

void add_edges(std::vector<Fact>& facts,
               const std::string& name,
               const scene::EdgeTally& tally,
               const std::string& doc) {
    facts.push_back(count(name, tally.count, "edges", doc));
    facts.push_back({name + "_length", tally.length_world, "world", "total length of these edges"});
}

void add_deviations(std::vector<Fact>& facts, const scene::SceneStatistics& statistics) {
    const int bin_deg = 180 / scene::kDeviationBins;
    for (int bin = 0; bin < scene::kDeviationBins; ++bin) {
        const std::size_t edges = statistics.deviations[static_cast<std::size_t>(bin)];
        if (edges == 0) continue;
        facts.push_back(count(
            fmt::format("deviations_{}_deg", bin * bin_deg),
            edges,
            "edges",
            fmt::format("that bend by {} to {} degrees", bin * bin_deg, (bin + 1) * bin_deg)));
    }
}

double whole_degrees(double rad) {
    return std::round(glm::degrees(rad));
}

std::vector<Fact> facts_of(const scene::SceneStatistics& l) {
    std::vector<Fact> facts = {
        count("triangles", l.triangles, "triangles", "degenerate and repeated ones left out"),
        count("vertices", l.vertices, "places", "after welding vertices at the same place"),
        count("objects", l.objects, "objects", "placed meshes"),
        count("materials", l.materials, "materials", "used by a triangle"),
        {"crease_angle", glm::degrees(l.crease_rad), "deg", "least dihedral deviation of a crease"},
    };
    add_edges(facts, "creases", l.creases, "with at least that deviation");
    add_edges(facts, "smooth", l.smooth, "with less: a curved surface made of facets");
    add_edges(facts, "flat", l.flat, "within a plane");
    add_edges(facts, "seams", l.seams, "between two objects, flatter than a crease");
    add_edges(facts, "boundary", l.boundary, "with one face");
    add_edges(facts, "nonmanifold", l.nonmanifold, "with three faces or more");
    add_edges(facts, "inside_out", l.inside_out, "smooth, but one face shows its back");
    add_deviations(facts, l);
    const std::vector<Fact> rest = {
        {"crease_proposal",
         whole_degrees(l.crease_proposal.angle_rad),
         "deg",
         "crease angle in the widest gap of deviations, for --crease"},
        {"crease_gap_from", whole_degrees(l.crease_proposal.from_rad), "deg", "where it begins"},
        {"crease_gap_to", whole_degrees(l.crease_proposal.to_rad), "deg", "and ends"},
        {"largest_smooth",
         glm::degrees(l.largest_smooth_rad),
         "deg",
         "largest dihedral deviation below a crease"},
        {"least_crease",
         glm::degrees(l.least_crease_rad),
         "deg",
         "least dihedral deviation found at a crease"},
        count("components", l.components, "components", "parts that share no edge"),
        count("watertight_components",
              l.watertight_components,
              "components",
              "closed and turned outwards"),
        count("convex_components",
              l.convex_components,
              "components",
              "watertight, and cannot hide their own front"),
        count("loose_triangles", l.loose_triangles, "triangles", "without a neighbour"),
        {"thin_lines",
         100 * l.thin_share,
         "%",
         "of their length, at components thinner than half a pixel of 720"},
        count("cracked_corners",
              l.cracked_corners,
              "corners",
              "of boundary edges, very near another corner"),
        count("overlapping_components",
              l.overlapping_components,
              "pairs",
              "that might cross each other"),
        {"extent_ratio", l.extent_ratio, "times", "the largest object over the smallest"},
        count(
            "near_sheets", l.near_sheets.pairs, "pairs", "parallel faces of two components, close"),
        {"near_sheets_gap", l.near_sheets.least_gap_share, "radii", "the least gap among them"},
        flag("may_hide", l.may_hide(), "a part may hide another, or itself"),
        flag("may_cross", l.may_cross(), "components may pierce each other"),
        flag("watertight", l.is_watertight(), "every component is closed and turned outwards"),
    };
    facts.insert(facts.end(), rest.begin(), rest.end());
    return facts;
}

std::string value_of(const Fact& fact) {
    if (fact.is_flag) return fact.value != 0 ? "yes" : "no";
    return fmt::format("{:.7g}", fact.value);
}

/// What a scene has not, and details, JSON has.
bool is_shown(const Fact& fact) {
    const bool is_detail = fact.name.ends_with("_length") || fact.name.starts_with("deviations_") ||
                           fact.name.starts_with("crease_gap_");
    return fact.is_flag || (fact.value != 0 && !is_detail);
}

MethodExplanation explain_method(const method::MethodConfig& config,
                                 const harness::SceneViews& scene_views) {
    harness::PreparedMethod prepared(config, scene_views.scene);
    if (!prepared.failure().empty()) {
        throw core::Error(config.info->name, prepared.failure(), "a scene that it can prepare");
    }
    if (!scene_views.views.empty()) {
        const scene::View& view = scene_views.views.front();
        edge::EdgeImage image(view.width_px, view.height_px);
        prepared.method().draw({view}, image);
    }
    return {config.info->name, prepared.method().skip_counts(), prepared.method().plan()};
}

std::string text_of(const MethodExplanation& method) {
    std::string text = fmt::format("\n{}: what it left undone in the first view\n", method.method);
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        const auto& [skipped, of] = method.skips[static_cast<std::size_t>(info.skip)];
        if (skipped == 0) continue;
        text += fmt::format(
            "  {:<20} {:>7} of {:>7} {:<9} {}\n", info.name, skipped, of, info.unit, info.summary);
    }
    if (method.plan.empty()) return text;
    text += fmt::format("{}: what it chose, and why\n", method.method);
    for (const method::PlanLine& line : method.plan)
        text += fmt::format("  {}: {}\n", line.what, line.why);
    return text;
}

}  // namespace

Explanation explain(const harness::SceneViews& scene_views,
                    const std::vector<method::MethodConfig>& configs,
                    double crease_deg) {
    const scene::Scene& scene = scene_views.scene;
    Explanation explanation{
        scene.name, facts_of(scene::make_scene_statistics(scene, glm::radians(crease_deg))), {}};
    for (const method::MethodConfig& config : configs)
        explanation.methods.push_back(explain_method(config, scene_views));
    return explanation;
}

std::string as_text(const Explanation& explanation) {
    std::string text = fmt::format("{}: its scene statistics\n", explanation.scene);
    for (const Fact& fact : explanation.facts) {
        if (!is_shown(fact)) continue;
        text += fmt::format(
            "  {:<20} {:>12} {:<10} {}\n", fact.name, value_of(fact), fact.unit, fact.doc);
    }
    for (const MethodExplanation& method : explanation.methods)
        text += text_of(method);
    return text;
}

}  // namespace ink::inspect
