#include "tune/tune_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/parse_number.h"
#include "core/split_list.h"
#include "core/toml_reader.h"

namespace ink::tune {
namespace {

constexpr int kDigits = 4;
constexpr double kLogFactor = 50;
constexpr double kSymLogWidth = 1000;
/// Of a flag or choice, so that the last one has as much room as the others.
constexpr double kAlmostOne = 1 - 1e-9;

/// "low..high" into the parameter.
void narrow(const std::string& range, TunedParameter& parameter) {
    const auto dots = range.find("..");
    std::optional<double> low;
    std::optional<double> high;
    if (dots != std::string::npos) {
        low = core::parse_number<double>(std::string_view(range).substr(0, dots));
        high = core::parse_number<double>(std::string_view(range).substr(dots + 2));
    }
    const core::Param& param = parameter.param;
    if (!param.is_number() || !low || !high || !(*low < *high) || *low < param.min ||
        *high > param.max) {
        throw core::Error("--params",
                          fmt::format("'{}' is no range of {}", range, param.name),
                          param.is_number()
                              ? fmt::format("low..high within {}..{}", param.min, param.max)
                              : "the name alone: every choice is tried");
    }
    parameter.low = *low;
    parameter.high = *high;
}

ParameterScale scale_of(const TunedParameter& parameter, bool is_limited) {
    if (!parameter.param.is_number() || is_limited) return ParameterScale::linear;
    if (parameter.low > 0 && parameter.high / parameter.low >= kLogFactor)
        return ParameterScale::log;
    const bool has_zero = parameter.low <= 0 && parameter.high >= 0;
    if (has_zero && parameter.high - parameter.low >= kSymLogWidth) return ParameterScale::sym_log;
    return ParameterScale::linear;
}

double bent(ParameterScale scale, double value) {
    if (scale == ParameterScale::log) return std::log(value);
    return scale == ParameterScale::sym_log ? std::asinh(value) : value;
}

double straight(ParameterScale scale, double value) {
    if (scale == ParameterScale::log) return std::exp(value);
    return scale == ParameterScale::sym_log ? std::sinh(value) : value;
}

/// `value` to kDigits decimal digits, towards 0 where `is_down`. Through text, so that it is the
/// same number on every machine.
double rounded(double value, bool is_down) {
    if (value == 0) return 0;
    std::string text = fmt::format("{:.{}e}", value, kDigits - 1);
    double result = *core::parse_number<double>(text);
    if (is_down && std::abs(result) > std::abs(value)) {
        const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - kDigits + 1);
        text = fmt::format("{:.{}e}", value - std::copysign(step, value) / 2, kDigits - 1);
        result = *core::parse_number<double>(text);
    }
    return result;
}

double value_at(const TunedParameter& parameter, double at) {
    const double t = std::clamp(at, 0.0, 1.0);
    if (!parameter.param.is_number()) {
        return std::floor(std::min(t, kAlmostOne) * (parameter.param.max + 1));
    }
    const double low = bent(parameter.scale, parameter.low);
    const double high = bent(parameter.scale, parameter.high);
    const double value = std::clamp(
        straight(parameter.scale, low + t * (high - low)), parameter.low, parameter.high);
    if (parameter.param.kind == core::ParamKind::integer) return std::round(value);
    return std::clamp(rounded(value, false), parameter.low, parameter.high);
}

double point_at(const TunedParameter& parameter, double value) {
    if (!parameter.param.is_number()) return (value + 0.5) / (parameter.param.max + 1);
    const double low = bent(parameter.scale, parameter.low);
    const double high = bent(parameter.scale, parameter.high);
    const double at = bent(parameter.scale, std::clamp(value, parameter.low, parameter.high));
    return std::clamp((at - low) / (high - low), 0.0, 1.0);
}

}  // namespace

std::string default_parameters(const method::MethodInfo& method) {
    std::string parameters;
    for (const method::Tunable& tunable : method.tunables) {
        parameters += (parameters.empty() ? "" : ",") + tunable.param;
        if (tunable.range)
            parameters += fmt::format("={}..{}", tunable.range->first, tunable.range->second);
    }
    return parameters.empty() ? "threshold" : parameters;
}

TuneSpace::TuneSpace(const method::MethodInfo& method, const std::string& parameters)
    : limits_(method.sum_limits) {
    const auto is_limited = [&](const std::string& name) {
        return std::ranges::any_of(limits_, [&](const method::SumLimit& limit) {
            return std::ranges::count(limit.params, name) > 0;
        });
    };
    for (const std::string& text :
         core::split_list(parameters.empty() ? default_parameters(method) : parameters)) {
        const auto equals = text.find('=');
        const std::string name = text.substr(0, equals);
        if (has(name)) {
            throw core::Error("--params", fmt::format("'{}' is named twice", name), "each once");
        }
        const core::Param& param = core::param_of(method.params, name, "--params");
        TunedParameter parameter{param, param.min, param.max, ParameterScale::linear};
        if (equals != std::string::npos) narrow(text.substr(equals + 1), parameter);
        parameter.scale = scale_of(parameter, is_limited(name));
        parameters_.push_back(std::move(parameter));
    }
    if (parameters_.empty())
        throw core::Error("--params", "it names no parameter", "a,b or a=low..high");
}

bool TuneSpace::has(const std::string& name) const {
    return std::ranges::any_of(
        parameters_, [&](const TunedParameter& parameter) { return parameter.param.name == name; });
}

core::ParamValues TuneSpace::settings_at(const std::vector<double>& point) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < parameters_.size(); ++i)
        values.push_back(value_at(parameters_[i], point[i]));
    for (const method::SumLimit& limit : limits_) {
        const auto is_in = [&](std::size_t i) {
            return std::ranges::count(limit.params, parameters_[i].param.name) > 0;
        };
        double sum = 0;
        for (std::size_t i = 0; i < parameters_.size(); ++i)
            sum += is_in(i) ? values[i] : 0;
        if (sum <= limit.limit) continue;
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            if (is_in(i)) values[i] = rounded(values[i] * (limit.limit / sum), true);
        }
    }
    core::ParamValues settings;
    for (std::size_t i = 0; i < parameters_.size(); ++i)
        settings[parameters_[i].param.name] = core::format_param(parameters_[i].param, values[i]);
    return settings;
}

std::vector<double> TuneSpace::point_of(const core::ParamValues& settings) const {
    std::vector<double> point;
    for (const TunedParameter& parameter : parameters_) {
        const double value = core::parse_param(
            parameter.param, settings.at(parameter.param.name), parameter.param.name);
        point.push_back(point_at(parameter, value));
    }
    return point;
}

}  // namespace ink::tune
