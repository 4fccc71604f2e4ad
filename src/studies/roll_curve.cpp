#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/csv.h"
#include "studies/roll_study.h"

namespace ink::studies {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;

/// From one angle to another the short way, -pi..pi.
double turn_between(double from_rad, double to_rad) {
    return std::remainder(to_rad - from_rad, kTurn_rad);
}

double degrees(double angle_rad) {
    return angle_rad * 180 / std::numbers::pi;
}

std::string curve_key(const RollCurve& curve) {
    return fmt::format("{},{},{}",
                       harness::csv_field(curve.method),
                       harness::csv_field(curve.params),
                       curve.crease);
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

std::string roll_csv(const std::vector<RollCurve>& curves) {
    std::string text =
        "method,params,crease,roll_deg,length_px,covered_px,predicted_step,predicted_blind\n";
    for (const RollCurve& curve : curves) {
        const std::string key = curve_key(curve);
        for (const RollSample& sample : curve.samples) {
            text += fmt::format("{},{:.6g},{:.6g},{:.6g},",
                                key,
                                degrees(sample.roll_rad),
                                sample.length_px,
                                sample.covered_px);
            text += curve.is_predicted
                        ? fmt::format("{:.6g},{}\n", sample.step, sample.is_blind ? 1 : 0)
                        : ",\n";
        }
    }
    return text;
}

std::string vanishing_csv(const std::vector<RollCurve>& curves) {
    std::string text = "method,params,crease,predicted_deg,measured_deg,error_deg,recall_there\n";
    for (const RollCurve& curve : curves) {
        for (const Vanishing& at : curve.vanishing) {
            text += fmt::format("{},{:.6g},", curve_key(curve), degrees(at.predicted_rad));
            if (at.measured_rad) {
                text += fmt::format("{:.6g},{:.3g}",
                                    degrees(*at.measured_rad),
                                    degrees(turn_between(at.predicted_rad, *at.measured_rad)));
            } else {
                text += ',';
            }
            text += at.recall_there ? fmt::format(",{:.4g}\n", *at.recall_there) : ",\n";
        }
    }
    return text;
}

}  // namespace ink::studies
