#include "experiment/asked.h"

#include <fmt/format.h>

#include <filesystem>
#include <glm/trigonometric.hpp>
#include <sstream>

#include "core/named.h"
#include "core/toml_document.h"
#include "experiment/options/option_table.h"

namespace ink::experiment {
namespace {

toml::array point(const glm::dvec3& p) {
    return toml::array{p.x, p.y, p.z};
}

toml::array cameras_of(const harness::ViewRequest& request) {
    toml::array cameras;
    for (const harness::CameraRequest& camera : request.cameras) {
        toml::table table{{"eye", point(camera.eye_world)}, {"up", point(camera.up_world)}};
        if (camera.target_world) table.insert("target", point(*camera.target_world));
        if (camera.fov_y_rad) table.insert("fov_deg", glm::degrees(*camera.fov_y_rad));
        cameras.push_back(std::move(table));
    }
    return cameras;
}

/// What no file can ask for: cameras, and what they are fitted to.
toml::table views_of(const harness::ViewRequest& request) {
    toml::table views;
    if (request.orbit_count) views.insert("orbit", *request.orbit_count);
    if (!request.directions.empty())
        views.insert("directions", core::array_of(core::names_of(request.directions)));
    if (request.up) views.insert("up", name(*request.up));
    if (request.fit) views.insert("fit", *request.fit == harness::Fit::box ? "box" : "sphere");
    if (request.height_world) views.insert("parallel_height", *request.height_world);
    if (request.margin) views.insert("margin", *request.margin);
    if (!request.objects.empty()) views.insert("objects", core::array_of(request.objects));
    if (request.file_cameras) views.insert("file_cameras", true);
    if (!request.cameras.empty()) views.insert("cameras", cameras_of(request));
    if (request.time_s) views.insert("time_s", *request.time_s);
    if (request.frame) views.insert("frame", *request.frame);
    if (!request.model.animation.empty()) views.insert("animation", request.model.animation);
    return views;
}

toml::table methods_of(const Experiment& experiment) {
    toml::table methods;
    for (const method::MethodConfig& config : configs_of(experiment)) {
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
            axes.insert(key, core::array_of(values));
        grids.push_back(toml::table{{"method", grid.method}, {"parameters", std::move(axes)}});
    }
    return grids;
}

/// Adds the value of an option; one that is out of its range, such as no limit, is not asked for.
void add_option(const Experiment& experiment, std::size_t row, toml::table& asked) {
    const core::Param& param = option_table().param(row);
    const std::vector<std::string> texts = option_table().texts(experiment, row);
    const auto [of, key] = place_of(param);
    toml::table* table =
        of.empty() ? &asked : asked.emplace<toml::table>(of).first->second.as_table();
    if (param.kind == core::ParamKind::list) {
        table->insert(key, core::array_of(texts));
        return;
    }
    if (texts.empty()) return;
    switch (param.kind) {
        case core::ParamKind::integer:
            table->insert(key, static_cast<std::int64_t>(std::stod(texts.front())));
            break;
        case core::ParamKind::real:
            table->insert(key, std::stod(texts.front()));
            break;
        case core::ParamKind::flag:
            table->insert(key, texts.front() == "true");
            break;
        default:
            table->insert(key, texts.front());
    }
}

}  // namespace

std::string asked_text(const Experiment& experiment) {
    toml::table asked;
    for (std::size_t row = 0; row < option_table().options.size(); ++row)
        if (option_table().has_kind(row, experiment.kind)) add_option(experiment, row, asked);
    asked.insert("views", views_of(experiment.view_request));
    asked.insert("methods", methods_of(experiment));
    if (experiment.kind == ExperimentKind::compare)
        asked["sweep"].as_table()->insert("grids", grids_of(experiment));
    std::ostringstream text;
    text << asked;
    return text.str();
}

}  // namespace ink::experiment
