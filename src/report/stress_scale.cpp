#include "report/stress_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiment/summary/summary.h"

namespace ink::report {
namespace {

constexpr double kPad = 12;  // inside the plot, left and right
constexpr std::size_t kMostTicks = 10;

/// "1e-7", "0.1", "20": short enough to stand beside others.
std::string tick_text(double value) {
    if (value != 0 && (value < 1e-2 || value >= 1e4)) {
        const int exponent = static_cast<int>(std::floor(std::log10(value) + 1e-9));
        const double lead = value / std::pow(10, exponent);
        return std::abs(lead - 1) < 0.005 ? fmt::format("1e{}", exponent)
                                          : fmt::format("{:.2g}e{}", lead, exponent);
    }
    return fmt::format("{:.4g}", value);
}

}  // namespace

StressScale::StressScale(const studies::StressAxis& axis,
                         const std::vector<experiment::StressCurve>& curves,
                         const Box& plot)
    : axis_(axis), plot_(plot) {
    double most = 0;
    for (const experiment::StressCurve& curve : curves) {
        for (const experiment::StressPointSummary& point : curve.points) {
            if (std::find(values_.begin(), values_.end(), point.value) == values_.end())
                values_.push_back(point.value);
            if (harness::is_baseline(curve.method) || !point.f) continue;
            most = std::max(most, point.f_range ? 1 - point.f_range->low : *point.error());
        }
    }
    std::sort(values_.begin(), values_.end());
    error_max_ = std::clamp(std::ceil(most * 10 + 0.01) / 10, 0.1, 1.0);
}

double StressScale::x(double value) const {
    if (values_.size() < 2) return plot_.x + plot_.width / 2;
    const bool is_log = axis_.scale == studies::AxisScale::log;
    const auto place = [&](double v) { return is_log ? std::log10(v) : v; };
    const double share =
        (place(value) - place(values_.front())) / (place(values_.back()) - place(values_.front()));
    return plot_.x + kPad + (plot_.width - 2 * kPad) * share;
}

double StressScale::y(double error) const {
    return plot_.y + plot_.height * (1 - std::clamp(error / error_max_, 0.0, 1.0));
}

std::vector<StressTick> StressScale::ticks() const {
    std::vector<StressTick> ticks;
    double last_x = -1e9;
    const bool is_named = axis_.scale == studies::AxisScale::named;
    const std::size_t stride = is_named ? 1 : (values_.size() + kMostTicks - 1) / kMostTicks;
    for (std::size_t i = 0; i < values_.size(); i += stride) {
        const std::string text =
            is_named ? experiment::format_stress_value(axis_, values_[i]) : tick_text(values_[i]);
        const double needed = is_named ? 0 : text_width(text, 12) + 6;
        if (x(values_[i]) - last_x < needed) continue;
        last_x = x(values_[i]);
        ticks.push_back({values_[i], text});
    }
    return ticks;
}

std::vector<double> StressScale::error_ticks() const {
    const double step = error_max_ > 0.65 ? 0.2 : error_max_ > 0.25 ? 0.1 : 0.05;
    std::vector<double> ticks;
    for (int i = 0; i * step <= error_max_ + 1e-9; ++i)
        ticks.push_back(i * step);
    return ticks;
}

}  // namespace ink::report
