#include "raster/depth/depth.h"

#include <cassert>
#include <cmath>

namespace ink::raster {
namespace {

/// OpenGL's window depth turned over: 1 at near, 0 at far; hyperbolic in w, affine in q = 1/w.
double window_depth(double w, const DepthRange& range) {
    return range.near * (range.far / w - 1) / (range.far - range.near);
}

double in_steps(double value, double steps) {
    return std::floor(value * steps + 0.5) / steps;
}

}  // namespace

double encode_depth(DepthEncoding encoding, double w, const DepthRange& range) {
    assert(w > 0 && range.near > 0 && range.far > range.near);
    if (range.is_parallel && (encoding == DepthEncoding::linear || encoding == DepthEncoding::log))
        encoding = DepthEncoding::inverse;
    switch (encoding) {
        case DepthEncoding::inverse:
            return window_depth(w, range);  // the same affine map of 1/w, not rounded to steps
        case DepthEncoding::linear:
            return (range.far - w) / (range.far - range.near);
        case DepthEncoding::log:
            return std::log(range.far / w) / std::log(range.far / range.near);
        case DepthEncoding::zbuffer24:
            return in_steps(window_depth(w, range), (1 << 24) - 1);
        case DepthEncoding::zbuffer16:
            return in_steps(window_depth(w, range), (1 << 16) - 1);
        case DepthEncoding::reversed_float:
            return static_cast<float>(range.near / w);
    }
    assert(false && "a DepthEncoding that does not exist");
    return 0;
}

QuantisedDepth::QuantisedDepth(DepthFormat format, double near, double far)
    : steps_(format == DepthFormat::z16 ? (1 << 16) - 1 : (1 << 24) - 1) {
    if (format == DepthFormat::q32) return;
    assert(near > 0 && far > near);
    scale_ = steps_ * (near * far / (far - near));
    offset_ = 0.5 - steps_ * (near / (far - near));
}

}  // namespace ink::raster
