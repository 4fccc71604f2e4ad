#include "methods/presets.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"

namespace ink::methods {
namespace {

constexpr std::size_t kSweepSettings = 8;
/// How far the sweep steps from a tuned number to either side.
constexpr std::array kSweepSteps = {0.75, 1.25};

std::string place_of(const toml::node& node, const std::string& where) {
    return fmt::format("{}:{}", where, node.source().begin.line);
}

const method::MethodInfo* find_base(const std::vector<method::MethodInfo>& bases,
                                    const std::string& name) {
    const auto found =
        std::find_if(bases.begin(), bases.end(), [&](const method::MethodInfo& info) {
            return info.name == name;
        });
    return found == bases.end() ? nullptr : &*found;
}

std::vector<std::string> names_of(const std::vector<method::MethodInfo>& bases) {
    std::vector<std::string> names;
    for (const method::MethodInfo& info : bases)
        names.push_back(info.name);
    return names;
}

/// The text behind `key`, which must be there.
std::string text_of(const toml::table& table, const char* key, const std::string& where) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        throw core::Error(where, fmt::format("there is no '{}'", key), "name, method, [settings]");
    }
    const toml::value<std::string>* text = node->as_string();
    if (text == nullptr) {
        throw core::Error(
            place_of(*node, where), fmt::format("'{}' is no text", key), "text in quotes");
    }
    return text->get();
}

/// The table behind `key`; nothing if there is none.
const toml::table* table_of(const toml::table& file, const char* key, const std::string& where) {
    const toml::node* node = file.get(key);
    if (node != nullptr && !node->is_table()) {
        throw core::Error(place_of(*node, where),
                          fmt::format("'{}' is no table", key),
                          fmt::format("[{}] and a line per key", key));
    }
    return node == nullptr ? nullptr : node->as_table();
}

void refuse_unknown_keys(const toml::table& file, const std::string& where) {
    const std::vector<std::string> known = {"name", "method", "settings", "provenance"};
    for (const auto& [key, node] : file) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
        throw core::Error(place_of(node, where),
                          fmt::format("a preset has no '{}'", key.str()),
                          core::known_names(known, key.str()));
    }
}

void check_name(const toml::table& file, const std::string& name, const std::string& where) {
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789_";
    const bool is_name = !name.empty() && name.find_first_not_of(kLetters) == std::string::npos;
    if (is_name) return;
    throw core::Error(place_of(*file.get("name"), where),
                      fmt::format("'{}' cannot be the name of a method", name),
                      "small letters, digits and underscores");
}

/// A TOML value as settings are spelt on the command line; "" for what is none.
std::string spelling(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
    if (const auto* real = node.as_floating_point())
        return fmt::format("{}", real->get() + 0.0);  // -0 is 0
    return "";
}

core::ParamValues read_settings(const toml::table& settings,
                                const method::MethodInfo& base,
                                const std::string& where) {
    core::ParamValues values;
    for (const auto& [key, node] : settings) {
        const std::string place = place_of(node, where);
        const std::string name(key.str());
        const std::string text = spelling(node);
        core::check_known_params(base.params, {{name, text}}, place);
        const auto param = std::find_if(
            base.params.begin(), base.params.end(), [&](auto& each) { return each.name == name; });
        const double value = core::parse_param(*param, text, place);
        values[name] = core::format_param(*param, value);
    }
    return values;
}

toml::table parse_toml(std::string_view text, const std::string& where) {
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw core::Error(fmt::format("{}:{}", where, error.source().begin.line),
                          std::string(error.description()),
                          "a preset as TOML");
    }
}

/// The tuned settings with `values` over them. Throws core::Error (where = the preset's name) for
/// what its method does not know or accept.
core::ParamValues over_tuned(const Preset& preset,
                             const std::vector<core::Param>& params,
                             const core::ParamValues& values) {
    core::check_known_params(params, values, preset.name);
    for (const core::Param& param : params) {
        const auto found = values.find(param.name);
        if (found != values.end()) (void)core::parse_param(param, found->second, preset.name);
    }
    core::ParamValues all = values;
    all.insert(preset.settings.begin(), preset.settings.end());
    return all;
}

bool touches(const core::ParamValues& line, const core::ParamValues& tuned) {
    return std::any_of(
        line.begin(), line.end(), [&](const auto& each) { return tuned.count(each.first) > 0; });
}

std::vector<core::ParamValues> sweep_of(const method::MethodInfo& tuned,
                                        const method::MethodInfo& base) {
    std::vector<core::ParamValues> lines = {{}};
    std::vector<core::ParamValues> seen = {tuned.complete({})};
    const auto add = [&](const core::ParamValues& line) {
        if (lines.size() >= kSweepSettings) return;
        const core::ParamValues all = tuned.complete(line);
        if (std::find(seen.begin(), seen.end(), all) != seen.end()) return;
        seen.push_back(all);
        lines.push_back(line);
    };
    core::ParamValues changed;
    for (const core::Param& param : tuned.params) {
        const auto own = std::find_if(base.params.begin(), base.params.end(), [&](auto& each) {
            return each.name == param.name;
        });
        if (own->default_value != param.default_value) changed[param.name] = "";
    }
    // A threshold in a line belongs to the line's other settings.
    changed["threshold"] = "";
    for (const core::ParamValues& line : base.sweep) {
        if (!touches(line, changed)) add(line);
    }
    for (const core::Param& param : tuned.params) {
        const bool is_number =
            param.kind == core::ParamKind::real || param.kind == core::ParamKind::integer;
        if (!is_number || changed.count(param.name) == 0) continue;
        for (const double step : kSweepSteps) {
            double value = std::clamp(param.default_value * step, param.min, param.max);
            if (param.kind == core::ParamKind::integer) value = std::round(value);
            add({{param.name, core::format_param(param, value)}});
        }
    }
    return lines;
}

}  // namespace

Preset parse_preset(std::string_view text,
                    const std::string& where,
                    const std::vector<method::MethodInfo>& bases) {
    const toml::table file = parse_toml(text, where);
    refuse_unknown_keys(file, where);
    Preset preset;
    preset.name = text_of(file, "name", where);
    check_name(file, preset.name, where);
    preset.method = text_of(file, "method", where);
    const method::MethodInfo* base = find_base(bases, preset.method);
    if (base == nullptr) {
        throw core::Error(place_of(*file.get("method"), where),
                          fmt::format("there is no method '{}'", preset.method),
                          core::known_names(names_of(bases), preset.method));
    }
    const toml::table* settings = table_of(file, "settings", where);
    if (settings == nullptr) {
        throw core::Error(where, "there is no [settings]", "name, method, [settings]");
    }
    preset.settings = read_settings(*settings, *base, where);
    const toml::table* provenance = table_of(file, "provenance", where);
    if (provenance != nullptr && provenance->contains("command")) {
        preset.command = text_of(*provenance, "command", where);
    }
    return preset;
}

method::MethodInfo preset_method(const Preset& preset,
                                 const std::vector<method::MethodInfo>& bases) {
    const method::MethodInfo& base = *find_base(bases, preset.method);
    method::MethodInfo info = base;
    info.name = preset.name;
    info.preset_of = base.name;
    info.source = fmt::format("{}; settings found by inkbench tune", base.source);
    info.summary = fmt::format("{}: {}", base.name, base.summary);
    for (core::Param& param : info.params) {
        const auto tuned = preset.settings.find(param.name);
        if (tuned == preset.settings.end()) continue;
        param.default_value = core::parse_param(param, tuned->second, preset.name);
    }
    info.make = [preset, params = base.params, make = base.make](const core::ParamValues& values) {
        return make(over_tuned(preset, params, values));
    };
    info.complete =
        [preset, params = base.params, complete = base.complete](const core::ParamValues& values) {
            return complete(over_tuned(preset, params, values));
        };
    info.sweep = sweep_of(info, base);
    return info;
}

}  // namespace ink::methods
