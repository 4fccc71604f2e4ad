#include "studies/skip_axes.h"

#include <utility>

#include "harness/skip_switches.h"

namespace ink::studies {
namespace {

constexpr double kOn = 1;
constexpr double kOwnOff = 2;
constexpr double kAllOff = 3;

raster::SkipSet allowed_at(double value, std::optional<raster::Skip> own) {
    if (value == kAllOff) return raster::SkipSet::none();
    raster::SkipSet allowed = own == raster::Skip::temporal_reuse
                                  ? raster::SkipSet()
                                  : harness::skips_of_repeated_drawings();
    if (value == kOwnOff) allowed.set(*own, false);
    return allowed;
}

Axis axis_of(const SkipScene& of, int levels) {
    constexpr int kLight = 2;
    Axis axis;
    axis.name = "skips_off";
    axis.title = "work that methods may not leave out";
    axis.scale = AxisScale::named;
    axis.values = {kOn, kOwnOff, kAllOff};
    axis.value_names = {"none off", "its own off", "all off"};
    if (!of.skip) {
        axis.values.erase(axis.values.begin() + 1);
        axis.value_names.erase(axis.value_names.begin() + 1);
    }
    axis.sentence =
        "Scenes that were made to have much of one kind of work that an image does not need: with "
        "all of it left out, without that skip alone, and without any.";
    axis.study = harness::Study::skips;
    axis.scene = of.make(kLight).scene_views.scene.name;
    axis.cases_of_value = 1;
    axis.same_images = true;
    axis.is_scored = false;
    axis.repetitions = 30;
    axis.budget_s = 0.1;
    axis.cases = [make = of.make, levels](double value, const CaseSize& size) {
        Case one = make(levels);
        one.value = value;
        const scene::Camera& camera = one.scene_views.scene.cameras.front();
        one.scene_views.views.push_back({camera, size.width_px, size.height_px});
        return std::vector<Case>{std::move(one)};
    };
    axis.allowed = [own = of.skip](double value) { return allowed_at(value, own); };
    return axis;
}

}  // namespace

std::vector<Axis> skip_axes(int levels) {
    std::vector<Axis> axes;
    for (const SkipScene& of : skip_scenes())
        axes.push_back(axis_of(of, levels));
    return axes;
}

}  // namespace ink::studies
