#include "tune/tune_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "harness/entrants.h"

namespace ink::tune {
namespace {

constexpr int kDigits = 4;
constexpr double kLogFactor = 50;
constexpr double kSymLogWidth = 1000;
/// Of a flag or choice, so that the last one has as much room as the others.
constexpr double kAlmostOne = 1 - 1e-9;

const core::Param& find_param(const method::MethodInfo& method, const std::string& name) {
    core::check_known_params(method.params, {{name, ""}}, "--params");
    return *std::find_if(method.params.begin(), method.params.end(), [&](const auto& param) {
        return param.name == name;
    });
}

std::optional<double> parse_number(std::string_view text) {
    double value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = status == std::errc{} && end == text.data() + text.size();
    return is_number && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool is_number(const core::Param& param) {
    return param.kind == core::ParamKind::real || param.kind == core::ParamKind::integer;
}

/// "low..high" into the knob.
void narrow(const std::string& range, TunedKnob& knob) {
    const auto dots = range.find("..");
    std::optional<double> low;
    std::optional<double> high;
    if (dots != std::string::npos) {
        low = parse_number(std::string_view(range).substr(0, dots));
        high = parse_number(std::string_view(range).substr(dots + 2));
    }
    const core::Param& param = knob.param;
    if (!is_number(param) || !low || !high || !(*low < *high) || *low < param.min ||
        *high > param.max) {
        throw core::Error("--params",
                          fmt::format("'{}' is no range of {}", range, param.name),
                          is_number(param)
                              ? fmt::format("low..high within {}..{}", param.min, param.max)
                              : "the name alone: every choice is tried");
    }
    knob.low = *low;
    knob.high = *high;
}

KnobScale scale_of(const TunedKnob& knob, bool is_limited) {
    if (!is_number(knob.param) || is_limited) return KnobScale::linear;
    if (knob.low > 0 && knob.high / knob.low >= kLogFactor) return KnobScale::log;
    const bool has_zero = knob.low <= 0 && knob.high >= 0;
    if (has_zero && knob.high - knob.low >= kSymLogWidth) return KnobScale::sym_log;
    return KnobScale::linear;
}

double bent(KnobScale scale, double value) {
    if (scale == KnobScale::log) return std::log(value);
    return scale == KnobScale::sym_log ? std::asinh(value) : value;
}

double straight(KnobScale scale, double value) {
    if (scale == KnobScale::log) return std::exp(value);
    return scale == KnobScale::sym_log ? std::sinh(value) : value;
}

/// `value` to kDigits decimal digits, towards 0 where `is_down`. Through text, so that it is the
/// same number on every machine.
double rounded(double value, bool is_down) {
    if (value == 0) return 0;
    std::string text = fmt::format("{:.{}e}", value, kDigits - 1);
    double result = *parse_number(text);
    if (is_down && std::abs(result) > std::abs(value)) {
        const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - kDigits + 1);
        text = fmt::format("{:.{}e}", value - std::copysign(step, value) / 2, kDigits - 1);
        result = *parse_number(text);
    }
    return result;
}

double value_at(const TunedKnob& knob, double at) {
    const double t = std::clamp(at, 0.0, 1.0);
    if (!is_number(knob.param)) {
        return std::floor(std::min(t, kAlmostOne) * (knob.param.max + 1));
    }
    const double low = bent(knob.scale, knob.low);
    const double high = bent(knob.scale, knob.high);
    const double value =
        std::clamp(straight(knob.scale, low + t * (high - low)), knob.low, knob.high);
    if (knob.param.kind == core::ParamKind::integer) return std::round(value);
    return std::clamp(rounded(value, false), knob.low, knob.high);
}

double point_at(const TunedKnob& knob, double value) {
    if (!is_number(knob.param)) return (value + 0.5) / (knob.param.max + 1);
    const double low = bent(knob.scale, knob.low);
    const double high = bent(knob.scale, knob.high);
    const double at = bent(knob.scale, std::clamp(value, knob.low, knob.high));
    return std::clamp((at - low) / (high - low), 0.0, 1.0);
}

}  // namespace

std::string default_knobs(const method::MethodInfo& method) {
    std::string knobs;
    for (const method::Tunable& tunable : method.tunables) {
        knobs += (knobs.empty() ? "" : ",") + tunable.param;
        if (tunable.range)
            knobs += fmt::format("={}..{}", tunable.range->first, tunable.range->second);
    }
    return knobs.empty() ? "threshold" : knobs;
}

TuneSpace::TuneSpace(const method::MethodInfo& method, const std::string& knobs)
    : limits_(method.sum_limits) {
    const auto is_limited = [&](const std::string& name) {
        return std::any_of(limits_.begin(), limits_.end(), [&](const method::SumLimit& limit) {
            return std::count(limit.params.begin(), limit.params.end(), name) > 0;
        });
    };
    for (const std::string& text :
         harness::split_list(knobs.empty() ? default_knobs(method) : knobs)) {
        const auto equals = text.find('=');
        const std::string name = text.substr(0, equals);
        if (has(name)) {
            throw core::Error("--params", fmt::format("'{}' is named twice", name), "each once");
        }
        const core::Param& param = find_param(method, name);
        TunedKnob knob{param, param.min, param.max, KnobScale::linear};
        if (equals != std::string::npos) narrow(text.substr(equals + 1), knob);
        knob.scale = scale_of(knob, is_limited(name));
        knobs_.push_back(std::move(knob));
    }
    if (knobs_.empty()) throw core::Error("--params", "it names no knob", "a,b or a=low..high");
}

bool TuneSpace::has(const std::string& name) const {
    return std::any_of(knobs_.begin(), knobs_.end(), [&](const TunedKnob& knob) {
        return knob.param.name == name;
    });
}

core::ParamValues TuneSpace::settings_at(const std::vector<double>& point) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < knobs_.size(); ++i)
        values.push_back(value_at(knobs_[i], point[i]));
    for (const method::SumLimit& limit : limits_) {
        const auto is_in = [&](std::size_t i) {
            return std::count(limit.params.begin(), limit.params.end(), knobs_[i].param.name) > 0;
        };
        double sum = 0;
        for (std::size_t i = 0; i < knobs_.size(); ++i)
            sum += is_in(i) ? values[i] : 0;
        if (sum <= limit.limit) continue;
        for (std::size_t i = 0; i < knobs_.size(); ++i) {
            if (is_in(i)) values[i] = rounded(values[i] * (limit.limit / sum), true);
        }
    }
    core::ParamValues settings;
    for (std::size_t i = 0; i < knobs_.size(); ++i)
        settings[knobs_[i].param.name] = core::format_param(knobs_[i].param, values[i]);
    return settings;
}

std::vector<double> TuneSpace::point_of(const core::ParamValues& settings) const {
    std::vector<double> point;
    for (const TunedKnob& knob : knobs_) {
        const double value =
            core::parse_param(knob.param, settings.at(knob.param.name), knob.param.name);
        point.push_back(point_at(knob, value));
    }
    return point;
}

}  // namespace ink::tune
