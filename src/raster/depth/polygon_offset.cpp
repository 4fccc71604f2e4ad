#include "raster/depth/polygon_offset.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ink::raster {

OffsetRule::OffsetRule(const PolygonOffset& offset, DepthFormat format, double near, double far)
    : offset_(offset),
      step_(format == DepthFormat::q32 ? 0 : 1 / QuantisedDepth(format, near, far).scale()) {}

double OffsetRule::depth_bias(double slope, double q_most) const {
    double step = step_;
    if (step == 0) {
        int exponent = 0;
        std::frexp(q_most, &exponent);  // q_most = 0.1... * 2^exponent
        step = std::ldexp(1.0, exponent - std::numeric_limits<float>::digits);
    }
    return -(offset_.factor * slope + offset_.units * step);
}

void OffsetRule::apply(SetupTriangle& triangle) const {
    const double slope = std::max(std::abs(triangle.q.dx), std::abs(triangle.q.dy));
    const double moved = depth_bias(slope, triangle.q_max);
    triangle.q.at_ref += moved;
    triangle.q_min += moved;
    triangle.q_max += moved;
}

}  // namespace ink::raster
