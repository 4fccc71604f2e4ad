#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/roll_study.h"

namespace ink::studies {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;

/// From one angle to another the short way, -pi..pi.
double turn_between(double from_rad, double to_rad) {
    return std::remainder(to_rad - from_rad, kTurn_rad);
}

}  // namespace

double RollCurve::least_recall() const {
    double least = 1;
    for (const RollSample& sample : samples)
        least = std::min(least, sample.recall());
    return least;
}

double RollCurve::mean_recall() const {
    if (samples.empty()) return 1;
    double sum = 0;
    for (const RollSample& sample : samples)
        sum += sample.recall();
    return sum / static_cast<double>(samples.size());
}

std::optional<double> measured_vanishing(const std::vector<RollSample>& samples,
                                         double predicted_rad) {
    constexpr double kNear_rad = 15 * std::numbers::pi / 180;
    const std::size_t n = samples.size();
    const auto is_lost = [&](std::size_t i) { return samples[i % n].recall() < 0.5; };
    std::optional<double> nearest;
    for (std::size_t first = 0; first < n; ++first) {
        if (!is_lost(first) || is_lost(first + n - 1)) continue;
        std::size_t last = first;
        while (is_lost(last + 1))
            ++last;
        const double width = static_cast<double>(last - first) * kTurn_rad / static_cast<double>(n);
        const double middle = samples[first].roll_rad + width / 2;
        const double off = std::abs(turn_between(predicted_rad, middle));
        if (off > kNear_rad + width / 2) continue;
        if (!nearest || off < std::abs(turn_between(predicted_rad, *nearest))) nearest = middle;
    }
    if (nearest) *nearest = std::fmod(*nearest, kTurn_rad);
    return nearest;
}

}  // namespace ink::studies
