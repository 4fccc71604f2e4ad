#include "methods/settings_toml.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace ink::methods {
namespace {

/// A TOML value as settings are spelt on the command line; "" for what is none.
std::string spelling(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
    if (const auto* real = node.as_floating_point())
        return fmt::format("{}", real->get() + 0.0);  // -0 is 0
    return "";
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& where, const std::string& what) {
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw core::Error(fmt::format("{}:{}", where, error.source().begin.line),
                          std::string(error.description()),
                          what + " as TOML");
    }
}

std::string place_of(const toml::node& node, const std::string& where) {
    return fmt::format("{}:{}", where, node.source().begin.line);
}

void refuse_unknown_keys(const toml::table& file,
                         const std::vector<std::string>& known,
                         const std::string& what,
                         const std::string& where) {
    for (const auto& [key, node] : file) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
        throw core::Error(place_of(node, where),
                          fmt::format("{} has no '{}'", what, key.str()),
                          core::known_names(known, key.str()));
    }
}

std::string text_of(const toml::table& table,
                    const char* key,
                    const std::string& where,
                    const char* needed) {
    const toml::node* node = table.get(key);
    if (node == nullptr) throw core::Error(where, fmt::format("there is no '{}'", key), needed);
    const toml::value<std::string>* text = node->as_string();
    if (text == nullptr) {
        throw core::Error(
            place_of(*node, where), fmt::format("'{}' is no text", key), "text in quotes");
    }
    return text->get();
}

const core::Param& param_of(const std::vector<core::Param>& params,
                            const std::string& name,
                            const std::string& place) {
    core::check_known_params(params, {{name, ""}}, place);
    return *std::find_if(
        params.begin(), params.end(), [&](const auto& each) { return each.name == name; });
}

core::ParamValues read_settings(const toml::table& settings,
                                const std::vector<core::Param>& params,
                                const std::string& where) {
    core::ParamValues values;
    for (const auto& [key, node] : settings) {
        const std::string place = place_of(node, where);
        const std::string name(key.str());
        const core::Param& param = param_of(params, name, place);
        values[name] = core::format_param(param, core::parse_param(param, spelling(node), place));
    }
    return values;
}

}  // namespace ink::methods
