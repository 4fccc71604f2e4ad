#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "lab/csv.h"
#include "lab/roll_study.h"

namespace ink::lab {
namespace {

double degrees(double angle_rad) {
    return angle_rad * 180 / std::numbers::pi;
}

std::string curve_key(const RollCurve& curve) {
    return fmt::format("{},{},{}", csv_field(curve.method), csv_field(curve.params), curve.crease);
}

}  // namespace

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
    std::string text = "method,params,crease,predicted_deg,measured_deg,error_deg\n";
    for (const RollCurve& curve : curves) {
        for (const Vanishing& at : curve.vanishing) {
            text += fmt::format("{},{:.6g},", curve_key(curve), degrees(at.predicted_rad));
            if (at.measured_rad) {
                const double error = *at.measured_rad - at.predicted_rad;
                text += fmt::format("{:.6g},{:.3g}",
                                    degrees(*at.measured_rad),
                                    degrees(std::remainder(error, 2 * std::numbers::pi)));
            } else {
                text += ',';
            }
            text += '\n';
        }
    }
    return text;
}

}  // namespace ink::lab
