#include "methods/method_configs.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "core/error.h"
#include "core/named.h"
#include "core/split_list.h"
#include "core/whole_file.h"
#include "methods/presets.h"
#include "methods/registry.h"

namespace ink::methods {
namespace {

constexpr double kUsualCrease_deg = 40;  ///< of the truth, and of methods that mean the same

void apply_setting(const method::Setting& setting, std::vector<method::MethodConfig>& configs) {
    std::set<std::string> known;
    bool is_used = false;
    for (method::MethodConfig& config : configs) {
        if (!setting.method.empty() && setting.method != config.info->name) continue;
        for (const core::Param& param : config.info->params)
            known.insert(param.name);
        if (method::param_of(setting, config) == nullptr) continue;
        config.settings[setting.key] = setting.value;
        is_used = true;
    }
    if (is_used) return;
    if (!setting.method.empty() && known.empty()) {
        std::vector<std::string> names;
        for (const method::MethodConfig& config : configs)
            names.push_back(config.info->name);
        throw core::Error("--set " + setting.text,
                          fmt::format("method '{}' does not take part", setting.method),
                          core::known_names(names, setting.method));
    }
    throw core::Error("--set " + setting.text,
                      fmt::format("there is no parameter '{}'", setting.key),
                      core::known_names({known.begin(), known.end()}, setting.key));
}

}  // namespace

void apply_settings(const std::vector<std::string>& settings,
                    std::vector<method::MethodConfig>& configs) {
    for (const std::string& text : settings)
        apply_setting(method::parse_setting(text), configs);
    // Read once here, so that a bad value ends the program before a scene is loaded.
    for (const method::MethodConfig& config : configs)
        (void)config.info->complete(config.settings);
}

void follow_crease(double crease_deg, std::vector<method::MethodConfig>& configs) {
    for (method::MethodConfig& config : configs) {
        for (const core::Param& param : config.info->params) {
            if (param.name != "crease_deg" || param.default_value != kUsualCrease_deg) continue;
            if (crease_deg == param.default_value) continue;
            config.settings.try_emplace(param.name, core::format_param(param, crease_deg));
        }
    }
}

method::MethodConfig preset_config(const std::filesystem::path& file) {
    const auto text = core::read_whole_file(file);
    if (!text) throw core::Error(file.string(), "cannot be read", "a preset as TOML");
    const std::vector<method::MethodInfo>& bases = registry();
    const Preset preset = parse_preset(*text, file.string(), bases);
    // A registered method may itself be a preset: `inkbench tune` gives that name, too.
    const auto shipped = shipped_presets();
    if (core::find_named(bases, preset.name) && !core::find_named(shipped, preset.name)) {
        throw core::Error(file.string(),
                          fmt::format("there is a method '{}' already", preset.name),
                          "a name of its own");
    }
    auto info = std::make_shared<const method::MethodInfo>(preset_method(preset, bases));
    return {info.get(), {}, info};
}

std::vector<method::MethodConfig> make_configs(const std::string& methods,
                                               const std::vector<std::string>& settings,
                                               const std::vector<std::string>& presets) {
    std::vector<method::MethodConfig> configs;
    std::set<std::string> names;
    for (const std::string& name : core::split_list(methods)) {
        if (!names.insert(name).second) {
            throw core::Error("--methods", fmt::format("'{}' is named twice", name), "each once");
        }
        configs.push_back({&find_method(name), {}});
    }
    if (configs.empty()) {
        for (const method::MethodInfo& info : registry())
            configs.push_back({&info, {}});
    }
    for (const std::string& file : presets) {
        method::MethodConfig config = preset_config(file);
        const auto is_namesake = [&](const method::MethodConfig& other) {
            return !other.owned && other.info->name == config.info->name;
        };
        if (methods.empty()) std::erase_if(configs, is_namesake);
        if (!names.insert(config.info->name).second) {
            throw core::Error(file,
                              fmt::format("'{}' is there twice", config.info->name),
                              "presets with names of their own (inkbench tune --name)");
        }
        configs.push_back(std::move(config));
    }
    apply_settings(settings, configs);
    return configs;
}

}  // namespace ink::methods
