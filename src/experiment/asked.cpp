#include "experiment/asked.h"

#include <fmt/format.h>

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
        toml::table table{{"eye", point(camera.eye_world)},
                          {"up", point(camera.up_world)},
                          {"fov_deg", camera.fov_deg}};
        if (camera.target_world) table.insert("target", point(*camera.target_world));
        if (camera.height_world) table.insert("parallel_height", *camera.height_world);
        cameras.push_back(std::move(table));
    }
    return cameras;
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
    for (const SettingGrid& grid : experiment.compare.grids) {
        toml::table axes;
        toml::array order;  // of which a table keeps nothing
        for (const auto& [key, values] : grid.axes) {
            axes.insert(key, core::array_of(values));
            order.push_back(key);
        }
        grids.push_back(toml::table{
            {"method", grid.method}, {"parameters", std::move(axes)}, {"order", std::move(order)}});
    }
    return grids;
}

/// Adds the value of an option; one that is out of its range, such as no limit, is not asked for,
/// and of views only what is asked for.
void add_option(const Experiment& experiment, std::size_t row, toml::table& asked) {
    const core::Param& param = option_table().param(row);
    const std::vector<std::string> texts = option_table().texts(experiment, row);
    const auto [of, key] = place_of(param);
    toml::table* table =
        of.empty() ? &asked : asked.emplace<toml::table>(of).first->second.as_table();
    if (of == "views" && texts == option_table().texts(Experiment{}, row)) return;
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
    toml::table& views = *asked.emplace<toml::table>("views").first->second.as_table();
    if (!experiment.view_request.cameras.empty())
        views.insert("cameras", cameras_of(experiment.view_request));
    if (!experiment.settings.empty()) asked.insert("settings", core::array_of(experiment.settings));
    asked.insert("methods", methods_of(experiment));
    if (experiment.kind == ExperimentKind::compare)
        asked["sweep"].as_table()->insert("grids", grids_of(experiment));
    std::ostringstream text;
    text << asked;
    return text.str();
}

}  // namespace ink::experiment
