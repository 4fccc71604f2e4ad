#include "linear_code/cancellation_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "edge/laplacian.h"

namespace ink::linear_code {
namespace {

constexpr int kLargestLaplacian = 4 * 65535;

/// The least |L| of which either sign reaches the threshold; 0 if none does.
int least_firing(const edge::LaplacianResponse& response, int threshold) {
    for (int l = 1; l <= kLargestLaplacian; ++l) {
        if (edge::respond(l, response) >= threshold) return l;
        if (edge::respond(-l, response) >= threshold) return l;
    }
    return 0;
}

}  // namespace

double silent_deviation_rad(const method::LinearCode& code, int threshold) {
    double square = 0;
    for (const double weight : code.normal_weight)
        square += weight * weight;
    const int least = least_firing(code.response, threshold);
    const double seen_twice = 2 * std::sqrt(square);
    if (least == 0 || least >= seen_twice) return std::numbers::pi;
    return 2 * std::asin(least / seen_twice);
}

}  // namespace ink::linear_code
