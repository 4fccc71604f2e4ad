#include "method/method_config.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/named.h"

namespace ink::method {

Setting parse_setting(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw core::Error(
            "--set",
            fmt::format("'{}' is no setting", text),
            "key=value or method.key=value; a scene stands before --set, or behind --scenes");
    }
    Setting setting{"", text.substr(0, equals), text.substr(equals + 1), text};
    const auto dot = setting.key.find('.');
    if (dot != std::string::npos) {
        setting.method = setting.key.substr(0, dot);
        setting.key = setting.key.substr(dot + 1);
    }
    return setting;
}

const core::Param* param_of(const Setting& setting, const MethodConfig& config) {
    if (!setting.method.empty() && setting.method != config.info->name) return nullptr;
    return core::find_named(config.info->params, setting.key);
}

MethodConfig with(MethodConfig config, const core::ParamValues& settings) {
    for (const auto& [name, value] : settings)
        config.settings[name] = value;
    return config;
}

int threshold_of(const MethodConfig& config) {
    return std::stoi(config.info->complete(config.settings).at("threshold"));
}

core::ParamValues drawn_settings(const MethodConfig& config) {
    core::ParamValues settings = config.info->complete(config.settings);
    if (!config.info->draws_by_threshold) settings.erase("threshold");
    return settings;
}

}  // namespace ink::method
