// Every number here was found on the catalogue at 1280x720, one thread; the method's page says how
// it does there and on real models.

#include "methods/auto/auto_plan.h"

#include <fmt/format.h>

#include <glm/trigonometric.hpp>

namespace ink::methods {
namespace {

constexpr double kMostlyThin = 0.5;  // of the length of all lines
constexpr double kMostlyLoose = 0.1;

constexpr double kEdgesPrice = 1.5;  // times ids, of few triangles

/// What looking up lines costs, in times of ids: codes decide where faces are flat or end at lines,
/// and the mesh is asked where smooth edges pass between the samples.
double lookup_price(const scene::SceneStatistics& s) {
    return 1 + s.smooth_share();
}

/// Why the label of a patch is all that a line needs; "" where it is not.
std::string why_labels(const scene::SceneStatistics& s) {
    if (s.loose_share() > kMostlyLoose) return "";
    if (!s.is_curved()) {
        return "no edge is smooth: a flat patch hides no part of itself, and no crease ends in it";
    }
    if (!s.has_creases() && s.convex_components == s.components) {
        return "all components are convex, without a crease: no patch hides a part of itself";
    }
    return "";
}

ScenePlan choose(const scene::SceneStatistics& s, double price) {
    if (s.thin_share > kMostlyThin && kEdgesPrice <= price) {
        return {"edge_hash",
                {{"edge_hash",
                  fmt::format("{:.0f} % of the lines are of parts thinner than a 720th of the "
                              "scene's radius: samples pass them by, edges are drawn",
                              100 * s.thin_share)}}};
    }
    if (const std::string why = why_labels(s); !why.empty()) {
        return {"label8",
                {{"label8", why},
                 {"no distance over the surface, no look-up", "labels differ across every line"},
                 {"surface_lookup from inside",
                  "where the near plane cuts the scene, labels would draw the cut"}}};
    }
    const double lookup = lookup_price(s);
    const std::string predicted =
        fmt::format("looking up lines costs about {:.1f} times ids here, by {:.0f} % smooth edges",
                    lookup,
                    100 * s.smooth_share());
    if (lookup <= price) return {"surface_lookup", {{"surface_lookup", predicted}}};
    return {"surface8_depth",
            {{"surface8_depth",
              "a surface may hide a part of itself: distances over it and depth tell, labels not"},
             {"no look-up", fmt::format("{}, of {:g} at most", predicted, price)}}};
}

}  // namespace

ScenePlan plan_scene(const scene::SceneStatistics& statistics, double price) {
    ScenePlan plan = choose(statistics, price);
    const auto absent = [&](bool is_absent, const char* what, const std::string& why) {
        if (is_absent) plan.lines.push_back({what, why});
    };
    absent(!statistics.has_creases(),
           "nothing for creases",
           fmt::format("no edge bends by {:g} degrees", glm::degrees(statistics.crease_rad)));
    absent(statistics.seams.count == 0, "nothing for seams", "no objects meet without a crease");
    absent(!statistics.may_cross(), "nothing for intersections", "no components can cross");
    return plan;
}

}  // namespace ink::methods
