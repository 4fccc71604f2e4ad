#include "methods/presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/named.h"
#include "core/toml_reader.h"

namespace ink::methods {
namespace {

constexpr const char* kNeeded = "name, method, [settings]";
constexpr std::size_t kSweepSettings = 8;
/// How far the sweep steps from a tuned number to either side.
constexpr std::array kSweepSteps = {0.75, 1.25};

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
        const core::Param& own = *core::find_named(base.params, param.name);
        if (own.default_value != param.default_value) changed[param.name] = "";
    }
    // A threshold in a line belongs to the line's other settings.
    changed["threshold"] = "";
    for (const core::ParamValues& line : base.sweep) {
        if (!touches(line, changed)) add(line);
    }
    for (const core::Param& param : tuned.params) {
        if (!param.is_number() || changed.count(param.name) == 0) continue;
        for (const double step : kSweepSteps) {
            double value = std::clamp(param.default_value * step, param.min, param.max);
            if (param.kind == core::ParamKind::integer) value = std::round(value);
            add({{param.name, core::format_param(param, value)}});
        }
    }
    return lines;
}

}  // namespace

void check_name(const std::string& name, const std::string& where) {
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789_";
    const bool is_name = !name.empty() && name.find_first_not_of(kLetters) == std::string::npos;
    if (is_name) return;
    throw core::Error(where,
                      fmt::format("'{}' cannot be the name of a method", name),
                      "small letters, digits and underscores");
}

std::string toml_text(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

std::string preset_toml(const PresetFile& preset) {
    std::string text = fmt::format("name = {}\nmethod = {}\n\n[settings]\n",
                                   toml_text(preset.name),
                                   toml_text(preset.method->name));
    for (const core::Param& param : preset.method->params) {
        const auto found = preset.settings.find(param.name);
        if (found == preset.settings.end()) continue;
        const bool is_choice = param.kind == core::ParamKind::choice;
        text += fmt::format(
            "{} = {}\n", param.name, is_choice ? toml_text(found->second) : found->second);
    }
    text += "\n[provenance]\n";
    for (const auto& [key, value] : preset.provenance)
        text += fmt::format("{} = {}\n", key, value);
    return text;
}

Preset parse_preset(std::string_view text,
                    const std::string& where,
                    const std::vector<method::MethodInfo>& bases) {
    core::TomlReader file(text, where);
    file.refuse_unknown({"name", "method", "settings", "provenance"});
    Preset preset;
    preset.name = file.needed_text("name", kNeeded);
    check_name(preset.name, file.where("name"));
    preset.method = file.needed_text("method", kNeeded);
    const method::MethodInfo* base = core::find_named(bases, preset.method);
    if (base == nullptr) {
        throw core::Error(file.where("method"),
                          fmt::format("there is no method '{}'", preset.method),
                          core::known_names(core::names_of(bases), preset.method));
    }
    auto settings = file.table("settings");
    if (!settings) throw core::Error(where, "there is no [settings]", kNeeded);
    preset.settings = settings->settings(base->params);
    if (auto provenance = file.table("provenance"))
        preset.command = provenance->text("command").value_or("");
    return preset;
}

method::MethodInfo preset_method(const Preset& preset,
                                 const std::vector<method::MethodInfo>& bases) {
    const method::MethodInfo& base = *core::find_named(bases, preset.method);
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
