#include "experiment/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "catalogue/catalogue.h"
#include "core/error.h"
#include "core/parse_number.h"
#include "entrants/entrant.h"
#include "experiment/options/option_table.h"
#include "harness/suite/suite.h"
#include "methods/registry.h"

namespace ink::experiment {
namespace {

/// Lets methods that draw ink draw lines as wide as the true ones, unless the user said how wide.
void follow_line_width(double line_width_px, std::vector<method::MethodConfig>& configs) {
    for (method::MethodConfig& config : configs) {
        if (!config.info->draws_ink) continue;
        for (const core::Param& param : config.info->params) {
            if (param.name != "width_px" || line_width_px == param.default_value) continue;
            const double width_px = std::clamp(line_width_px, param.min, param.max);
            config.settings.try_emplace(param.name, core::format_param(param, width_px));
        }
    }
}

}  // namespace

std::string_view name(ExperimentKind kind) {
    constexpr std::array<std::string_view, 3> kNames = {"compare", "stress", "animation"};
    return kNames.at(static_cast<std::size_t>(kind));
}

std::optional<double> scored_width_px(const Experiment& experiment) {
    if (!experiment.coverage) return std::nullopt;
    return experiment.line_width_px;
}

harness::ViewRequest views_of(const Experiment& experiment, const ImageSize& size) {
    harness::ViewRequest request = experiment.view_request;
    request.width_px = size.width_px;
    request.height_px = size.height_px;
    return request;
}

harness::ViewRequest views_of(const Experiment& experiment) {
    return views_of(experiment, experiment.sizes.front());
}

ImageSize parse_image_size(const std::string& text, const std::string& where) {
    const auto x = text.find('x');
    const auto width_px = core::parse_number<int>(text.substr(0, x));
    const auto height_px = core::parse_number<int>(text.substr(x + 1));
    if (x == std::string::npos || !width_px || !height_px) {
        throw core::Error(where,
                          fmt::format("'{}' is no size", text),
                          "WIDTHxHEIGHT in pixels, such as 1280x720");
    }
    at_place(where, [&] { harness::check_size(*width_px, *height_px); });
    return {*width_px, *height_px};
}

std::vector<std::string> scenes_called(const std::string& name) {
    const bool is_all = name == "catalogue";
    if (!is_all && name != "train" && name != "heldout") return {name};
    std::vector<std::string> names;
    for (const catalogue::CatalogueEntry& entry : catalogue::catalogue()) {
        if (is_all || scene::split_name(entry.split) == name) names.push_back(entry.name);
    }
    return names;
}

void cover_named_ink(Experiment& experiment) {
    const std::vector<std::string>& names = experiment.methods;
    const bool is_all = names.size() == methods::registry().size();
    if (is_all || experiment.kind != ExperimentKind::compare) return;
    experiment.coverage |= std::any_of(names.begin(), names.end(), [](const auto& name) {
        return methods::find_method(name).draws_ink;
    });
}

std::vector<method::MethodConfig> configs_of(const Experiment& experiment) {
    std::vector<method::MethodConfig> configs;
    const bool is_all_own = experiment.methods.empty() && experiment.compare.presets.empty();
    if (experiment.compare.own_methods.empty() || !is_all_own) {
        configs = methods::make_configs(
            fmt::format("{}", fmt::join(experiment.methods, ",")), {}, experiment.compare.presets);
    }
    std::vector<method::MethodConfig> outside = experiment.compare.own_methods;
    for (const std::string& text : experiment.compare.entrants)
        outside.push_back(
            entrants::entrant_config(entrants::parse_entrant(text), experiment.compare.entrant_s));
    for (method::MethodConfig& config : outside) {
        configs.push_back(std::move(config));
        const auto is_namesake = [&](const method::MethodConfig& other) {
            return other.info->name == configs.back().info->name;
        };
        if (std::count_if(configs.begin(), configs.end(), is_namesake) > 1) {
            throw core::Error("--entrant",
                              fmt::format("'{}' is there twice", configs.back().info->name),
                              "names of their own");
        }
    }
    for (const std::string& text : experiment.settings) {
        const method::Setting setting = method::parse_setting(text);
        for (method::MethodConfig& config : configs) {
            if (method::param_of(setting, config) != nullptr)
                config.settings[setting.key] = setting.value;
        }
    }
    methods::follow_crease(experiment.crease_deg, configs);
    if (experiment.coverage) follow_line_width(experiment.line_width_px, configs);
    return methods::at_each_antialias(configs, experiment.antialias, experiment.line_width_px);
}

std::vector<method::MethodConfig> grid_configs(const method::MethodConfig& config,
                                               const SettingGrid& grid) {
    std::vector<method::MethodConfig> configs = {config};
    for (const auto& [key, values] : grid.axes) {
        std::vector<method::MethodConfig> longer;
        for (const method::MethodConfig& shorter : configs) {
            for (const std::string& value : values) {
                longer.push_back(shorter);
                longer.back().settings[key] = value;
            }
        }
        configs = std::move(longer);
    }
    return configs;
}

}  // namespace ink::experiment
