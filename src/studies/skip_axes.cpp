#include "studies/skip_axes.h"

#include <fmt/format.h>

#include <functional>
#include <utility>

#include "harness/skip_switches.h"

namespace ink::studies {
namespace {

constexpr double kOn = 1;
constexpr double kOwnOff = 2;
constexpr double kAllOff = 3;

Case case_of(SkipScene made, double value, const CaseSize& size) {
    Case one{"skips_off", value, {std::move(made.scene), {}}};
    const scene::Scene& scene = one.scene_views.scene;
    one.scene_views.views.push_back({scene.cameras.front(), size.width_px, size.height_px});
    for (const auto& [key, setting] : made.settings)
        one.settings.push_back(fmt::format("{}={}", key, setting));
    one.poses = std::move(made.poses);
    return one;
}

raster::SkipSet allowed_at(double value, std::optional<raster::Skip> own) {
    if (value == kAllOff) return raster::SkipSet::none();
    raster::SkipSet allowed = own == raster::Skip::temporal_reuse
                                  ? raster::SkipSet()
                                  : harness::skips_of_repeated_drawings();
    if (value == kOwnOff) allowed.set(*own, false);
    return allowed;
}

/// `make` makes the scene, `light` is the same of few triangles.
Axis axis_of(const std::function<SkipScene()>& make, const SkipScene& light) {
    Axis axis;
    axis.name = "skips_off";
    axis.title = "work that methods may not leave out";
    axis.scale = AxisScale::named;
    axis.values = {kOn, kOwnOff, kAllOff};
    axis.value_names = {"none off", "its own off", "all off"};
    if (!light.skip) {
        axis.values.erase(axis.values.begin() + 1);
        axis.value_names.erase(axis.value_names.begin() + 1);
    }
    axis.sentence =
        "Scenes that were made to have much of one kind of work that an image does not need: with "
        "all of it left out, without that skip alone, and without any.";
    axis.study = harness::Study::skips;
    axis.scene = light.name;
    axis.cases_of_value = 1;
    axis.same_images = true;
    axis.is_scored = false;
    axis.repetitions = 30;
    axis.budget_s = 0.1;
    axis.cases = [make](double value, const CaseSize& size) {
        return std::vector<Case>{case_of(make(), value, size)};
    };
    axis.allowed = [own = light.skip](double value) { return allowed_at(value, own); };
    return axis;
}

}  // namespace

std::vector<Axis> skip_axes(int levels) {
    constexpr int kLight = 2;
    std::vector<Axis> axes;
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        axes.push_back(axis_of([skip = info.skip, levels] { return skip_scene(skip, levels); },
                               skip_scene(info.skip, kLight)));
    }
    const std::vector<SkipScene> views = skip_views(kLight);
    for (std::size_t i = 0; i < views.size(); ++i) {
        axes.push_back(axis_of([i, levels] { return std::move(skip_views(levels)[i]); }, views[i]));
    }
    return axes;
}

}  // namespace ink::studies
