#include "method/depth_code.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

namespace ink::method {

raster::DepthRange depth_range(RangeSource source,
                               const scene::Camera& camera,
                               const scene::Sphere& bounds) {
    raster::DepthRange range{camera.near, camera.far};
    if (source == RangeSource::fit) {
        const glm::dvec3 center_view =
            camera.view_from_world * (bounds.center_world - camera.eye_world);
        const double far = -center_view.z + bounds.radius;
        const double near = std::max(-center_view.z - bounds.radius, camera.near);
        const auto w_of = [&](double depth) { return scene::w_of_depth(camera, depth); };
        if (far > camera.near) range = {w_of(near), w_of(far)};
    }
    range.is_parallel = camera.is_parallel();
    // A flat scene seen face-on has no extent; 1/w needs some.
    range.far = std::max(range.far, range.near * (1 + 1e-6));
    return range;
}

double encode_limited(raster::DepthEncoding encoding, double w, const raster::DepthRange& range) {
    return std::clamp(raster::encode_depth(encoding, w, range), -kDepthLimit, kDepthLimit);
}

DepthCarrier::DepthCarrier(raster::DepthEncoding encoding,
                           raster::Interpolation interpolation,
                           const raster::DepthRange& range)
    : encoding_(encoding), interpolation_(interpolation), range_(range) {
    if (!range.is_parallel) return;
    interpolation_ = raster::Interpolation::affine;
    if (encoding == raster::DepthEncoding::linear || encoding == raster::DepthEncoding::log)
        encoding_ = raster::DepthEncoding::inverse;
}

bool DepthCarrier::is_encoded() const {
    using raster::DepthEncoding;
    return interpolation_ == raster::Interpolation::affine ? encoding_ == DepthEncoding::inverse
                                                           : encoding_ == DepthEncoding::linear;
}

float DepthCarrier::at_vertex(double w) const {
    assert(w > 0);
    using raster::DepthEncoding;
    const bool affine = interpolation_ == raster::Interpolation::affine;
    return static_cast<float>(
        encode_limited(affine ? DepthEncoding::inverse : DepthEncoding::linear, w, range_));
}

void DepthCarrier::encode_row(const float* carried, float sky, float* encoded, int count) const {
    const bool affine = interpolation_ == raster::Interpolation::affine;
    const double q_far = 1 / range_.far;
    const double q_span = 1 / range_.near - q_far;
    const double w_span = range_.far - range_.near;
    for (int x = 0; x < count; ++x) {
        if (carried[x] == kNothingDrawn) {
            encoded[x] = sky;
            continue;
        }
        const double w = affine ? 1 / std::max(carried[x] * q_span + q_far, 1e-30)
                                : range_.far - carried[x] * w_span;
        const double d = encode_limited(encoding_, std::max(w, 1e-30), range_);
        encoded[x] = static_cast<float>(d);
    }
}

}  // namespace ink::method
