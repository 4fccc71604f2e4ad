#include "experiment/asked.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <filesystem>
#include <numbers>
#include <sstream>

namespace ink::experiment {
namespace {

constexpr double kDegPerRad = 180 / std::numbers::pi;

toml::array array_of(const std::vector<std::string>& texts) {
    toml::array array;
    for (const std::string& text : texts)
        array.push_back(text);
    return array;
}

toml::array point(const glm::dvec3& p) {
    return toml::array{p.x, p.y, p.z};
}

toml::array cameras_of(const harness::ViewRequest& request) {
    toml::array cameras;
    for (const harness::CameraRequest& camera : request.cameras) {
        toml::table table{{"eye", point(camera.eye_world)}, {"up", point(camera.up_world)}};
        if (camera.target_world) table.insert("target", point(*camera.target_world));
        if (camera.fov_y_rad) table.insert("fov_deg", *camera.fov_y_rad * kDegPerRad);
        cameras.push_back(std::move(table));
    }
    return cameras;
}

toml::table views_of(const Experiment& experiment) {
    const harness::ViewRequest& request = experiment.view_request;
    toml::table views;
    toml::array sizes;
    for (const ImageSize& size : experiment.sizes)
        sizes.push_back(fmt::format("{}x{}", size.width_px, size.height_px));
    views.insert("sizes", std::move(sizes));
    if (experiment.views > 0) views.insert("first", experiment.views);
    if (request.orbit_count) views.insert("orbit", *request.orbit_count);
    if (request.fit) views.insert("fit", *request.fit == harness::Fit::box ? "box" : "sphere");
    if (request.margin) views.insert("margin", *request.margin);
    if (!request.objects.empty()) views.insert("objects", array_of(request.objects));
    if (request.file_cameras) views.insert("file_cameras", true);
    if (!request.cameras.empty()) views.insert("cameras", cameras_of(request));
    if (request.time_s) views.insert("time_s", *request.time_s);
    if (request.frame) views.insert("frame", *request.frame);
    if (!request.model.animation.empty()) views.insert("animation", request.model.animation);
    views.insert("seams", request.model.material_seams ? "materials" : "objects");
    return views;
}

toml::table methods_of(const Experiment& experiment) {
    toml::table methods;
    for (const harness::MethodConfig& config : configs_of(experiment)) {
        toml::table parameters;
        for (const auto& [name, value] : config.info->complete(config.settings))
            parameters.insert(name, value);
        methods.insert(config.info->name, std::move(parameters));
    }
    return methods;
}

toml::array grids_of(const Experiment& experiment) {
    toml::array grids;
    for (const SettingGrid& grid : experiment.grids) {
        toml::table axes;
        for (const auto& [key, values] : grid.axes)
            axes.insert(key, array_of(values));
        grids.push_back(toml::table{{"method", grid.method}, {"parameters", std::move(axes)}});
    }
    return grids;
}

toml::table measure_of(const Experiment& experiment) {
    toml::array threads;
    for (const int count : experiment.threads)
        threads.push_back(count);
    static constexpr const char* kImages[] = {"none", "first", "all"};
    return toml::table{{"threads", std::move(threads)},
                       {"repetitions", experiment.repetitions},
                       {"budget_ms", experiment.budget_s * 1e3},
                       {"full_scores", experiment.full_scores},
                       {"crosscheck", experiment.crosscheck},
                       {"times", experiment.times},
                       {"crease_deg", experiment.crease_deg},
                       {"weld_epsilon", experiment.weld_epsilon},
                       {"intersections", score::name(experiment.intersections)},
                       {"skips_off", array_of(experiment.skips_off)},
                       {"images", kImages[static_cast<int>(experiment.images)]}};
}

}  // namespace

std::string asked_text(const Experiment& experiment) {
    toml::table asked{{"seed", static_cast<std::int64_t>(experiment.seed)},
                      {"views", views_of(experiment)},
                      {"methods", methods_of(experiment)},
                      {"measure", measure_of(experiment)}};
    if (experiment.kind != ExperimentKind::stress)
        asked.insert("scenes", array_of(experiment.scenes));
    if (experiment.kind == ExperimentKind::stress) {
        asked.insert("axes", array_of(experiment.axes));
        asked.insert("points", experiment.points);
    }
    if (experiment.kind == ExperimentKind::animation || experiment.study_motion) {
        asked.insert("motion",
                     toml::table{{"frames", experiment.frames}, {"roll", experiment.roll}});
    }
    if (experiment.kind == ExperimentKind::compare) {
        asked.insert("sweep",
                     toml::table{{"own_views", experiment.own_sweep_views},
                                 {"grids", grids_of(experiment)}});
        asked.insert("scaling", experiment.study_scaling);
        asked.insert("skips", experiment.study_skips);
    }
    if (experiment.kind == ExperimentKind::bound) {
        const BoundRequest& bound = experiment.bound;
        asked.insert("bound",
                     toml::table{{"signed", bound.is_signed},
                                 {"least_threshold", bound.least_threshold},
                                 {"gap", bound.gap},
                                 {"boxes", bound.boxes}});
    }
    std::ostringstream text;
    text << asked;
    return text.str();
}

}  // namespace ink::experiment
