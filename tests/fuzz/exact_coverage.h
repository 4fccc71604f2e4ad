#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>

namespace ink::fuzz {

/// The corners of a triangle in clip space, (x, y, w).
using ClipCorners = std::array<glm::dvec3, 3>;

/// Whether a triangle that neither near nor the guard band cuts covers the centre of pixel (x, y):
/// corners on the grid of 1/256 px, whole numbers of 128 bits, and the top-left rule.
[[nodiscard]] bool covers_exactly(const ClipCorners& corners, int x, int y);

/// On which side of a line a box round a pixel centre lies.
enum class Side {
    inside,
    outside,
    unknown,  ///< neither all of it on one, nor all on the other, or rounding decides
};

/// The lines that bound what is seen of a triangle, cut or not: its edges, then near.
struct Outline {
    static constexpr std::size_t kLines = 4;

    struct Line {
        long double x = 0, y = 0, c = 0;  ///< x * x_px + y * y_px + c is positive inside
        long double slack = 0;            ///< what rounding may have made of that
    };
    /// Edge i runs from corner i to the next.
    std::array<Line, kLines> lines{};
    /// Half the side of the boxes: as far as the corners may have been moved.
    double margin_px = 0;
    /// The sign of the volume of eye and corners: of two triangles that run along a shared edge in
    /// turn, those of one sign lie on different sides of it.
    int turn = 0;

    [[nodiscard]] Side side(std::size_t line, int x, int y) const;
    /// Whether the box round the centre of pixel (x, y) lies inside of all lines, but for `but`.
    [[nodiscard]] bool has_inside(int x, int y, std::size_t but = kLines) const;
    /// Whether it lies outside of one line.
    [[nodiscard]] bool has_outside(int x, int y) const;
};

/// The outline of a triangle whose corners are finite; nothing if it is seen edge-on, or too nearly
/// so.
///
/// A ray through (x_px, y_px, 1) meets the triangle where the volumes that it spans with the ends
/// of each edge have one sign, that of the three corners' (Olano and Greer 1997, "Triangle scan
/// conversion using 2D homogeneous coordinates").
[[nodiscard]] std::optional<Outline> outline_of(const ClipCorners& corners, double near);

}  // namespace ink::fuzz
