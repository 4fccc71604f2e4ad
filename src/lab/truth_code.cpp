#include "lab/truth_code.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "methods/depth_code.h"

namespace ink::lab {

/// Depth, encoded, and the view-space normal of the side that is seen.
struct TruthCode::Inputs {
    double depth = 0;
    glm::dvec3 n_view{0};
};

TruthCode::TruthCode(const scene::Surface& surface,
                     const scene::Sphere& bounds,
                     const scene::View& view,
                     const methods::LinearCode& code)
    : surface_(surface),
      camera_(view.camera),
      projection_(view),
      range_(methods::depth_range(code.inputs.depth_range, view.camera, bounds)),
      code_(code) {}

/// Source of the shares: Olano and Greer, "Triangle scan conversion using 2D homogeneous
/// coordinates", Graphics Hardware 1997, section 3.
TruthCode::Inputs TruthCode::inputs_at(int x_px, int y_px, std::uint32_t triangle) const {
    const scene::Triangle& corners = surface_.triangles[triangle];
    glm::dvec3 p_clip[3];
    for (int i = 0; i < 3; ++i)
        p_clip[i] = projection_.to_clip(surface_.p_world[corners[i]]);
    const glm::dvec3 pixel(x_px + 0.5, y_px + 0.5, 1);
    double share[3];
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        share[i] = glm::dot(pixel, glm::cross(p_clip[(i + 1) % 3], p_clip[(i + 2) % 3]));
        sum += share[i];
    }
    double w = 0;
    for (int i = 0; i < 3; ++i) {
        share[i] = sum == 0 ? 1.0 / 3 : share[i] / sum;
        w += share[i] * p_clip[i].z;
    }
    w = std::max(w, camera_.near);
    const bool is_whole =
        std::all_of(p_clip, p_clip + 3, [&](const glm::dvec3& p) { return p.z >= camera_.near; });
    if (is_whole && code_.inputs.interpolation == raster::Interpolation::affine) {
        for (int i = 0; i < 3; ++i)
            share[i] *= p_clip[i].z / w;
    }
    Inputs inputs;
    const auto encoded = [&](double at_w) {
        return methods::encode_limited(code_.encoding, at_w, range_);
    };
    if (!is_whole || !code_.inputs.at_vertices) inputs.depth = encoded(w);
    for (int i = 0; i < 3; ++i) {
        if (is_whole && code_.inputs.at_vertices) inputs.depth += share[i] * encoded(p_clip[i].z);
        inputs.n_view +=
            share[i] * (camera_.view_from_world * glm::dvec3(surface_.n_world[corners[i]]));
    }
    // A triangle is seen from its back where the eye lies behind its plane.
    const glm::dvec3& a = surface_.p_world[corners[0]];
    const glm::dvec3 normal =
        glm::cross(surface_.p_world[corners[1]] - a, surface_.p_world[corners[2]] - a);
    if (glm::dot(normal, camera_.eye_world - a) < 0) inputs.n_view = -inputs.n_view;
    const double length = glm::length(inputs.n_view);
    if (code_.inputs.renormalise && !code_.inputs.at_vertices && length > 0)
        inputs.n_view /= length;
    return inputs;
}

int TruthCode::limited(double sum) const {
    const long rounded = static_cast<long>(std::floor(sum + 0.5));
    const long max = (1L << code_.bits) - 1;
    return static_cast<int>(code_.wraps ? rounded & max : std::clamp(rounded, 0L, max));
}

PixelCode TruthCode::at(int x_px, int y_px, std::uint32_t triangle) const {
    if (triangle == truth::kNoTriangle) return {.channels = {}, .code = code_.sky_code};
    const Inputs inputs = inputs_at(x_px, y_px, triangle);
    PixelCode pixel;
    pixel.channels[0] = code_.depth_weight * inputs.depth;
    double sum = code_.offset + pixel.channels[0];
    for (int k = 0; k < 3; ++k) {
        const auto channel = static_cast<std::size_t>(k + 1);
        pixel.channels[channel] = code_.normal_weight[k] * (inputs.n_view[k] + 1) / 2;
        sum += pixel.channels[channel];
    }
    pixel.code = limited(sum);
    return pixel;
}

}  // namespace ink::lab
