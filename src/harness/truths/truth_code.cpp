#include "harness/truths/truth_code.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "method/depth_code.h"
#include "raster/pass/clip.h"

namespace ink::harness {

/// A triangle as it is drawn, and what each corner counts for at a pixel.
struct DrawnTriangle {
    std::array<glm::dvec3, 3> p_clip;
    std::array<glm::dvec3, 3> n_view;
    std::array<double, 3> share{};  ///< linear on the surface; they add up to 1
};

namespace {

/// Sets the shares of the corners at a point of the image, from (x, y, h), linear in the world.
///
/// Source: Olano and Greer, "Triangle scan conversion using 2D homogeneous coordinates", Graphics
/// Hardware 1997, section 3.
void share_out(const glm::dvec3& p_px, bool is_parallel, DrawnTriangle& corners) {
    double sum = 0;
    const auto at = [&](std::size_t i) {
        const glm::dvec3& p = corners.p_clip[i % 3];
        return is_parallel ? p / p.z : p;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        corners.share[i] = glm::dot(p_px, glm::cross(at(i + 1), at(i + 2)));
        sum += corners.share[i];
    }
    for (double& share : corners.share)
        share = sum == 0 ? 1.0 / 3 : share / sum;
}

/// The piece of a triangle that a method draws at a point of the image, if the near plane cuts
/// the triangle: what is computed at corners is computed at the corners of the cut.
DrawnTriangle cut_corners(const DrawnTriangle& whole,
                          const glm::dvec3& p_px,
                          const scene::Camera& camera) {
    raster::CutVertices vertices{{whole.p_clip.begin(), whole.p_clip.end()},
                                 {whole.n_view.begin(), whole.n_view.end()},
                                 camera.is_parallel()};
    raster::CutTriangles pieces;
    const scene::Triangle triangle{0, 1, 2};
    const std::int8_t facing = 1;
    raster::cut_triangles({&triangle, 1}, {&facing, 1}, camera.near, vertices, pieces);
    DrawnTriangle best = whole;
    double best_share = -std::numeric_limits<double>::infinity();
    for (const scene::Triangle& piece : pieces.triangles) {
        DrawnTriangle corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners.p_clip[i] = vertices.p_clip[piece[i]];
            corners.n_view[i] = vertices.n[piece[i]];
        }
        share_out(p_px, camera.is_parallel(), corners);
        // The point lies in the piece in which its least share is largest.
        const double least = *std::min_element(corners.share.begin(), corners.share.end());
        if (least > best_share) best = corners;
        best_share = std::max(best_share, least);
    }
    return best;
}

}  // namespace

/// Depth, encoded, and the view-space normal of the side that is seen.
struct TruthCode::Inputs {
    double depth = 0;
    glm::dvec3 n_view{0};
};

TruthCode::TruthCode(const scene::Surface& surface,
                     const scene::Sphere& bounds,
                     const scene::View& view,
                     const method::LinearCode& code)
    : surface_(surface),
      camera_(view.camera),
      projection_(view),
      range_(method::depth_range(code.inputs.depth_range, view.camera, bounds)),
      code_(code) {}

TruthCode::Inputs TruthCode::inputs_at(int x_px, int y_px, std::uint32_t triangle) const {
    const scene::Triangle& indices = surface_.triangles[triangle];
    // A triangle is seen from its back where the eye lies behind its plane.
    const glm::dvec3& a = surface_.p_world[indices[0]];
    const glm::dvec3 normal =
        glm::cross(surface_.p_world[indices[1]] - a, surface_.p_world[indices[2]] - a);
    const double side = glm::dot(normal, camera_.viewpoint().sight(a)) > 0 ? -1 : 1;

    const glm::dvec3 p_px(x_px + 0.5, y_px + 0.5, 1);
    DrawnTriangle corners;
    bool is_whole = true;
    for (std::size_t i = 0; i < 3; ++i) {
        corners.p_clip[i] = projection_.to_clip(surface_.p_world[indices[i]]);
        corners.n_view[i] =
            side * (camera_.view_from_world * glm::dvec3(surface_.n_world[indices[i]]));
        is_whole = is_whole && !raster::needs_cut(corners.p_clip[i], camera_.near);
    }
    share_out(p_px, camera_.is_parallel(), corners);
    if (!is_whole) corners = cut_corners(corners, p_px, camera_);
    return interpolated(corners);
}

TruthCode::Inputs TruthCode::interpolated(const DrawnTriangle& corners) const {
    const std::array<glm::dvec3, 3>& p_clip = corners.p_clip;
    std::array<double, 3> share = corners.share;
    const auto encoded = [&](double w) {
        return method::encode_limited(code_.encoding, std::max(w, camera_.near), range_);
    };
    double w = 0;
    for (std::size_t i = 0; i < 3; ++i)
        w += share[i] * (camera_.is_parallel() ? 1 / p_clip[i].z : p_clip[i].z);
    if (camera_.is_parallel()) {
        w = 1 / w;  // where all is affine on the screen
    } else if (code_.inputs.interpolation == raster::Interpolation::affine) {
        for (std::size_t i = 0; i < 3; ++i)
            share[i] *= p_clip[i].z / w;
    }
    Inputs inputs;
    for (std::size_t i = 0; i < 3; ++i) {
        inputs.depth += share[i] * encoded(p_clip[i].z);
        inputs.n_view += share[i] * corners.n_view[i];
    }
    if (code_.inputs.at_vertices) return inputs;
    inputs.depth = encoded(w);
    const double length = glm::length(inputs.n_view);
    if (code_.inputs.renormalise && length > 0) inputs.n_view /= length;
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

}  // namespace ink::harness
