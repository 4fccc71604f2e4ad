#include "studies/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/named.h"

namespace ink::studies {
namespace {

double value_of(const core::Param& param, const core::ParamValues& all) {
    return core::parse_param(param, all.at(param.name), "a study");
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
    if (core::find_named(info.params, "overflow") == nullptr &&
        core::find_named(info.params, "scale_bits") == nullptr)
        return ranges;
    for (const core::Param& param : info.params) {
        if (param.name.starts_with("range_")) ranges.push_back(&param);
    }
    return ranges;
}

void apply_text(const std::string& text, method::MethodConfig& config) {
    const method::Setting setting = method::parse_setting(text);
    const core::Param* param = method::param_of(setting, config);
    if (param == nullptr) return;
    const auto& known = param->choices;
    const bool is_unknown = param->kind == core::ParamKind::choice &&
                            std::find(known.begin(), known.end(), setting.value) == known.end();
    if (!is_unknown) config.settings[setting.key] = setting.value;
}

void apply_gain(double gain, method::MethodConfig& config) {
    const std::vector<const core::Param*> ranges = code_ranges(*config.info);
    if (ranges.empty() || gain == 1) return;
    const core::ParamValues all = config.info->complete(config.settings);
    for (const core::Param* range : ranges)
        set_nearest(*range, value_of(*range, all) * gain, config.settings);
    const core::Param* threshold = core::find_named(config.info->params, "threshold");
    set_nearest(*threshold, value_of(*threshold, all) * gain, config.settings);
}

/// Fewer bits: the same lines at the same edge responses, from coarser codes.
void apply_bits(int bits, method::MethodConfig& config) {
    const std::vector<const core::Param*> ranges = code_ranges(*config.info);
    const core::Param* scale = core::find_named(config.info->params, "scale_bits");
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
    if (const core::Param* clip = core::find_named(config.info->params, "clip_bits"))
        set_nearest(*clip, value_of(*clip, all) - fewer, config.settings);
}

}  // namespace

method::MethodConfig under_case(const method::MethodConfig& config, const Case& one) {
    method::MethodConfig result = config;
    for (const std::string& text : one.settings)
        apply_text(text, result);
    apply_gain(one.code_gain, result);
    if (one.code_bits) apply_bits(*one.code_bits, result);
    return result;
}

std::vector<double> axis_values(const Axis& axis, int count) {
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

std::string format_value(const Axis& axis, double value) {
    for (std::size_t i = 0; i < axis.value_names.size(); ++i) {
        if (axis.values[i] == value) return axis.value_names[i];
    }
    const bool is_plain = value == 0 || (value >= 1e-3 && value < 1e5);
    const std::string text = is_plain ? fmt::format("{:.4g}", value) : fmt::format("{:.1e}", value);
    if (axis.unit.empty()) return text;
    if (axis.unit == "%") return text + " %";
    if (axis.unit == "deg") return text + "°";
    return text + " " + axis.unit;
}

void CaseFaults::add(const CaseFaults& more) {
    non_finite += more.non_finite;
    overflow += more.overflow;
    lost += more.lost;
    differing += more.differing;
}

}  // namespace ink::studies
