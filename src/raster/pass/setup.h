#pragma once

#include <array>
#include <cstdint>

#include "raster/pass/screen_vertex.h"

namespace ink::raster {

/// Pixels [x0, x1) x [y0, y1).
struct PixelRect {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    [[nodiscard]] bool is_empty() const { return x0 >= x1 || y0 >= y1; }
};

/// Which pixel centres lie on the inner side of an edge: those with at(x, y) >= 0, exactly.
///
/// The value at a centre is twice the area, in 1/256 px squared, that edge and centre span, less 1
/// if the edge is neither top nor left: a centre on the border between two triangles is then inside
/// exactly one of them (the rule of OpenGL's and Direct3D's hardware: top and left edges are half
/// open inwards). Top: level, the triangle below. Left: the triangle to its right.
struct EdgeFunction {
    std::int64_t at_origin = 0;  ///< at pixel (0, 0)
    std::int64_t dx = 0;         ///< from a pixel to the next on its right; below 2^38
    std::int64_t dy = 0;         ///< to the next below

    [[nodiscard]] std::int64_t at(int x, int y) const { return at_origin + dx * x + dy * y; }
};

/// An affine function on the screen, its origin at the centre of pixel (SetupTriangle::ref_x,
/// ref_y).
struct Plane {
    double at_ref = 0;
    double dx = 0;
    double dy = 0;
};

/// Three numbers, one per corner.
using PerCorner = std::array<double, 3>;

/// A triangle ready to fill: coverage from snapped corners, planes from unsnapped ones.
struct SetupTriangle {
    PixelRect bounds;  ///< of the pixel centres that may be inside, within the image
    std::array<EdgeFunction, 3> edges;
    int ref_x = 0;  ///< planes start at this pixel, in the middle of `bounds`, so that they
    int ref_y = 0;  ///< do not lose digits on their way from a corner far outside
    Plane q;
    double q_min = 0;  ///< of the corners; q is limited to them, so that a sliver, whose gradients
    double q_max = 0;  ///< are noise, never stands out of its own surface
    /// Too thin to hold a pixel and its four neighbours: other planes are limited to their corners'
    /// range as well, which no Laplacian inside one triangle can notice.
    bool is_thin = false;
    std::uint32_t triangle = 0;  ///< index into PassInput::triangles

    [[nodiscard]] bool covers(int x, int y) const {
        return (edges[0].at(x, y) | edges[1].at(x, y) | edges[2].at(x, y)) >= 0;
    }
};

/// What became of a triangle.
enum class SetupResult {
    drawn,
    outside,    ///< beyond the image
    no_sample,  ///< in it, but without a pixel centre (or without area)
};

/// Sets a triangle up for a width_px x height_px image; either turn will do. On anything but
/// `drawn` `out` is unspecified.
[[nodiscard]] SetupResult set_up(const std::array<ScreenVertex, 3>& corners,
                                 int width_px,
                                 int height_px,
                                 SetupTriangle& out);

/// Twice the signed area of three snapped corners, in 1/256 px squared; exact.
[[nodiscard]] std::int64_t area2(const ScreenVertex& a,
                                 const ScreenVertex& b,
                                 const ScreenVertex& c);

/// Makes planes over one triangle.
class PlaneMaker {
  public:
    /// `corners` as given to set_up for `triangle`.
    PlaneMaker(const std::array<ScreenVertex, 3>& corners, const SetupTriangle& triangle);

    /// The plane through `values` at the unsnapped corners. Level where that triangle has no area
    /// or a gradient that no double holds.
    [[nodiscard]] Plane through(const PerCorner& values) const;

  private:
    double x1_, y1_, x2_, y2_;  // of corners 1 and 2 from corner 0
    double ref_x_, ref_y_;      // of the reference centre from corner 0
    double one_over_area_;      // 0: no area
};

}  // namespace ink::raster
