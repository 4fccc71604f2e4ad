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

/// Sets a knob to `value`, or as near to it as the knob goes.
void set_nearest(const core::Param& param, double value, core::ParamValues& settings) {
    double near = std::clamp(value, param.min, param.max);
    if (param.kind == core::ParamKind::integer) near = std::round(near);
    settings[param.name] = core::format_param(param, near);
}

/// Of a packed code: those of its knobs that say how many codes a channel spans.
std::vector<const core::Param*> code_ranges(const method::MethodInfo& info) {
    std::vector<const core::Param*> ranges;
    if (find_param(info, "overflow") == nullptr && find_param(info, "scale_bits") == nullptr)
        return ranges;
    for (const core::Param& param : info.params) {
        if (param.name.starts_with("range_")) ranges.push_back(&param);
    }
    return ranges;
}

void apply_text(const std::string& text, harness::Entrant& entrant) {
    const auto equals = text.find('=');
    assert(equals != std::string::npos);
    std::string key = text.substr(0, equals);
    const std::string value = text.substr(equals + 1);
    if (const auto dot = key.find('.'); dot != std::string::npos) {
        if (key.substr(0, dot) != entrant.info->name) return;
        key = key.substr(dot + 1);
    }
    const core::Param* param = find_param(*entrant.info, key);
    if (param == nullptr) return;
    const bool is_choice = param->kind == core::ParamKind::choice;
    const auto& known = param->choices;
    if (is_choice && std::find(known.begin(), known.end(), value) == known.end()) return;
    entrant.settings[key] = value;
}

void apply_gain(double gain, harness::Entrant& entrant) {
    const std::vector<const core::Param*> ranges = code_ranges(*entrant.info);
    if (ranges.empty() || gain == 1) return;
    const core::ParamValues all = entrant.info->complete(entrant.settings);
    for (const core::Param* range : ranges)
        set_nearest(*range, value_of(*range, all) * gain, entrant.settings);
    const core::Param* threshold = find_param(*entrant.info, "threshold");
    set_nearest(*threshold, value_of(*threshold, all) * gain, entrant.settings);
}

/// Fewer bits: the same lines at the same strengths, from coarser codes.
void apply_bits(int bits, harness::Entrant& entrant) {
    const std::vector<const core::Param*> ranges = code_ranges(*entrant.info);
    const core::Param* scale = find_param(*entrant.info, "scale_bits");
    if (ranges.empty() || scale == nullptr) return;
    const core::ParamValues all = entrant.info->complete(entrant.settings);
    const double most = ranges.front()->max;  // of a code: 255 or 65535
    const int own_bits = static_cast<int>(std::lround(std::log2(most + 1)));
    const int fewer = std::max(0, own_bits - bits);
    for (const core::Param* range : ranges) {
        const double value = value_of(*range, all);
        set_nearest(*range, std::floor(std::ldexp(value, -fewer)), entrant.settings);
    }
    set_nearest(*scale, value_of(*scale, all) + fewer, entrant.settings);
    if (const core::Param* clip = find_param(*entrant.info, "clip_bits"))
        set_nearest(*clip, value_of(*clip, all) - fewer, entrant.settings);
}

}  // namespace

harness::Entrant under_stress(const harness::Entrant& entrant, const StressCase& stress) {
    harness::Entrant result = entrant;
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
