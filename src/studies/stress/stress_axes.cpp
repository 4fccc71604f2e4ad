#include "studies/stress/stress_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string_view>

#include "core/error.h"

namespace ink::studies {
namespace {

const core::Param* find_param(const method::MethodInfo& info, std::string_view name) {
    for (const core::Param& param : info.params) {
        if (param.name == name) return &param;
    }
    return nullptr;
}

double value_of(const core::Param& param, const core::ParamValues& all) {
    return core::parse_param(param, all.at(param.name), "stress");
}

/// Sets a parameter to `value`, or as near to it as the parameter goes.
void set_nearest(const core::Param& param, double value, core::ParamValues& settings) {
    double near = std::clamp(value, param.min, param.max);
    if (param.kind == core::ParamKind::integer) near = std::round(near);
    settings[param.name] = core::format_param(param, near);
}

/// Of a packed code: those of its parameters that say how many codes a channel spans.
std::vector<const core::Param*> code_ranges(const method::MethodInfo& info) {
    std::vector<const core::Param*> ranges;
    if (find_param(info, "overflow") == nullptr && find_param(info, "scale_bits") == nullptr)
        return ranges;
    for (const core::Param& param : info.params) {
        if (param.name.starts_with("range_")) ranges.push_back(&param);
    }
    return ranges;
}

void apply_text(const std::string& text, harness::MethodConfig& config) {
    const auto equals = text.find('=');
    assert(equals != std::string::npos);
    std::string key = text.substr(0, equals);
    const std::string value = text.substr(equals + 1);
    if (const auto dot = key.find('.'); dot != std::string::npos) {
        if (key.substr(0, dot) != config.info->name) return;
        key = key.substr(dot + 1);
    }
    const core::Param* param = find_param(*config.info, key);
    if (param == nullptr) return;
    const bool is_choice = param->kind == core::ParamKind::choice;
    const auto& known = param->choices;
    if (is_choice && std::find(known.begin(), known.end(), value) == known.end()) return;
    config.settings[key] = value;
}

void apply_gain(double gain, harness::MethodConfig& config) {
    const std::vector<const core::Param*> ranges = code_ranges(*config.info);
    if (ranges.empty() || gain == 1) return;
    const core::ParamValues all = config.info->complete(config.settings);
    for (const core::Param* range : ranges)
        set_nearest(*range, value_of(*range, all) * gain, config.settings);
    const core::Param* threshold = find_param(*config.info, "threshold");
    set_nearest(*threshold, value_of(*threshold, all) * gain, config.settings);
}

/// Fewer bits: the same lines at the same edge responses, from coarser codes.
void apply_bits(int bits, harness::MethodConfig& config) {
    const std::vector<const core::Param*> ranges = code_ranges(*config.info);
    const core::Param* scale = find_param(*config.info, "scale_bits");
    if (ranges.empty() || scale == nullptr) return;
    const core::ParamValues all = config.info->complete(config.settings);
    const double most = ranges.front()->max;  // of a code: 255 or 65535
    const int own_bits = static_cast<int>(std::lround(std::log2(most + 1)));
    const int fewer = std::max(0, own_bits - bits);
    for (const core::Param* range : ranges) {
        const double value = value_of(*range, all);
        set_nearest(*range, std::floor(std::ldexp(value, -fewer)), config.settings);
    }
    set_nearest(*scale, value_of(*scale, all) + fewer, config.settings);
    if (const core::Param* clip = find_param(*config.info, "clip_bits"))
        set_nearest(*clip, value_of(*clip, all) - fewer, config.settings);
}

}  // namespace

harness::MethodConfig under_stress(const harness::MethodConfig& config, const StressCase& stress) {
    harness::MethodConfig result = config;
    for (const std::string& text : stress.settings)
        apply_text(text, result);
    apply_gain(stress.code_gain, result);
    if (stress.code_bits) apply_bits(*stress.code_bits, result);
    return result;
}

const StressAxis& find_stress_axis(const std::string& name) {
    std::vector<std::string> names;
    for (const StressAxis& axis : stress_axes()) {
        if (axis.name == name) return axis;
        names.push_back(axis.name);
    }
    throw core::Error(
        "--axes", fmt::format("there is no axis '{}'", name), core::known_names(names, name));
}

std::vector<double> stress_values(const StressAxis& axis, int count) {
    assert(count >= 2);
    const auto all = static_cast<int>(axis.values.size());
    if (count >= all) return axis.values;
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        const auto at = std::lround(static_cast<double>(i) * (all - 1) / (count - 1));
        values.push_back(axis.values[static_cast<std::size_t>(at)]);
    }
    return values;
}

}  // namespace ink::studies
