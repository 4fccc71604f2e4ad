// A pixel is cut in four until the distance from every stroke that matters in a square is as good
// as linear. The stroke covers a half-plane of the square then, and what none of them covers is a
// convex polygon, whose area is known. Distances from segments are convex: they lie above their
// tangents, and nowhere further than at the corners.
#include "score/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "core/parallel.h"

namespace ink::score {
namespace {

using glm::dvec2;

constexpr double kLinear_px =
    1.0 / 2048;               ///< nearer to its tangent than this, a distance is linear
constexpr int kMostCuts = 5;  ///< of a pixel: squares of 1/32 px
constexpr double kHalfDiagonal = 0.70710678118654752440;  ///< of a square, over its side

/// The segment that a pen follows.
struct Stroke {
    dvec2 begin{0};
    dvec2 along{1, 0};  ///< unit
    double length = 0;
};

Stroke stroke_of(const truth::Curve& curve) {
    const dvec2 begin{curve.begin.x_px, curve.begin.y_px};
    const dvec2 way = dvec2{curve.end.x_px, curve.end.y_px} - begin;
    const double length = std::sqrt(glm::dot(way, way));
    if (!(length > 0)) return {begin};
    return {begin, way / length, length};
}

/// The nearest point of a stroke, seen from somewhere.
dvec2 to_point(const Stroke& stroke, const dvec2& from) {
    const dvec2 d = from - stroke.begin;
    const double s = std::clamp(glm::dot(d, stroke.along), 0.0, stroke.length);
    return d - s * stroke.along;
}

double distance(const Stroke& stroke, const dvec2& from) {
    const dvec2 way = to_point(stroke, from);
    return std::sqrt(glm::dot(way, way));
}

/// A stroke's distance from about the centre of a square: value and gradient there.
struct Tangent {
    std::uint32_t stroke = 0;
    double distance = 0;
    dvec2 gradient{0};
};

struct Square {
    dvec2 centre{0};
    double half = 0.5;

    [[nodiscard]] std::array<dvec2, 4> corners() const {
        return {centre + dvec2{-half, -half},
                centre + dvec2{half, -half},
                centre + dvec2{half, half},
                centre + dvec2{-half, half}};
    }
};

using Polygon = std::vector<dvec2>;

/// Keeps of a convex polygon what lies at least `radius` away by a tangent at `centre`.
void cut(
    Polygon& polygon, Polygon& kept, const Tangent& tangent, const dvec2& centre, double radius) {
    const auto beyond = [&](const dvec2& p) {
        return tangent.distance - radius + glm::dot(tangent.gradient, p - centre);
    };
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec2& a = polygon[i];
        const dvec2& b = polygon[(i + 1) % polygon.size()];
        const double at_a = beyond(a);
        const double at_b = beyond(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a >= 0) != (at_b >= 0)) kept.push_back(a + (at_a / (at_a - at_b)) * (b - a));
    }
    std::swap(polygon, kept);
}

double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec2& a = polygon[i];
        const dvec2& b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

/// Finds what strokes leave of a square.
class Blank {
  public:
    Blank(std::span<const Stroke> strokes, double radius) : strokes_(strokes), radius_(radius) {}

    /// The area of the pixel that none of `near`, indices of strokes, covers.
    double of_pixel(int x, int y, std::span<const std::uint32_t> near) {
        levels_[0].assign(near.begin(), near.end());
        return of({{x + 0.5, y + 0.5}, 0.5}, levels_[0], 0);
    }

  private:
    double of(const Square& square,
              const std::vector<std::uint32_t>& candidates,
              std::size_t cuts) {
        const double reach = 2 * square.half * kHalfDiagonal;
        const double whole = 4 * square.half * square.half;
        std::vector<Tangent>& tangents = tangents_[cuts];
        const double nearest = look(square, candidates, tangents);
        if (nearest + reach <= radius_) return 0;
        if (nearest - reach >= radius_) return whole;
        // A stroke counts if it reaches in and some point of the square may be nearest to it.
        std::erase_if(tangents, [&](const Tangent& tangent) {
            return tangent.distance >= std::min(radius_ + reach, nearest + 2 * reach);
        });
        if (cuts == kMostCuts || are_linear(square, tangents)) return cut_by(square, tangents);
        std::vector<std::uint32_t>& inner = levels_[cuts + 1];
        inner.clear();
        for (const Tangent& tangent : tangents)
            inner.push_back(tangent.stroke);
        const double half = square.half / 2;
        double left = 0;
        for (const dvec2& way : {dvec2{-half, -half}, {half, -half}, {-half, half}, {half, half}})
            left += of({square.centre + way, half}, inner, cuts + 1);
        return left;
    }

    /// Fills in the tangents of all candidates at the centre; returns the least distance.
    double look(const Square& square,
                const std::vector<std::uint32_t>& candidates,
                std::vector<Tangent>& tangents) const {
        tangents.clear();
        double nearest = 1e300;
        for (const std::uint32_t i : candidates) {
            const Stroke& stroke = strokes_[i];
            const dvec2 way = to_point(stroke, square.centre);
            const double length = std::sqrt(glm::dot(way, way));
            const dvec2 across{-stroke.along.y, stroke.along.x};
            tangents.push_back({i, length, length > 0 ? way / length : across});
            nearest = std::min(nearest, length);
        }
        return nearest;
    }

    [[nodiscard]] bool are_linear(const Square& square,
                                  const std::vector<Tangent>& tangents) const {
        const std::array<dvec2, 4> corners = square.corners();
        return std::all_of(tangents.begin(), tangents.end(), [&](const Tangent& tangent) {
            return std::all_of(corners.begin(), corners.end(), [&](const dvec2& p) {
                const double linear =
                    tangent.distance + glm::dot(tangent.gradient, p - square.centre);
                return distance(strokes_[tangent.stroke], p) - linear <= kLinear_px;
            });
        });
    }

    /// The square without the half-planes of the tangents.
    double cut_by(const Square& square, const std::vector<Tangent>& tangents) {
        const std::array<dvec2, 4> corners = square.corners();
        polygon_.assign(corners.begin(), corners.end());
        for (const Tangent& tangent : tangents)
            cut(polygon_, kept_, tangent, square.centre, radius_);
        return area(polygon_);
    }

    std::span<const Stroke> strokes_;
    double radius_;
    // Of every depth of cutting, for they are used again and again.
    std::array<std::vector<std::uint32_t>, kMostCuts + 1> levels_;
    std::array<std::vector<Tangent>, kMostCuts + 1> tangents_;
    Polygon polygon_, kept_;
};

/// The columns first..last that a stroke may touch in row `y`; none if last < first.
struct Columns {
    int first = 0;
    int last = -1;
};

Columns columns_in_row(const Stroke& stroke, int y, double radius, int width_px) {
    double from = 0;
    double to = stroke.length;
    const double slope = stroke.along.y;
    if (slope != 0) {
        const double a = (y - radius - stroke.begin.y) / slope;
        const double b = (y + 1 + radius - stroke.begin.y) / slope;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    if (to < from) return {};
    const double x0 = stroke.begin.x + from * stroke.along.x;
    const double x1 = stroke.begin.x + to * stroke.along.x;
    const auto column = [&](double x) {
        return static_cast<int>(std::clamp(std::floor(x), -1.0, static_cast<double>(width_px)));
    };
    return {std::max(column(std::min(x0, x1) - radius), 0),
            std::min(column(std::max(x0, x1) + radius), width_px - 1)};
}

/// For each row the strokes that may touch it.
std::vector<std::vector<std::uint32_t>> strokes_of_rows(std::span<const Stroke> strokes,
                                                        double radius,
                                                        int height_px) {
    std::vector<std::vector<std::uint32_t>> rows(static_cast<std::size_t>(height_px));
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const double y0 = strokes[i].begin.y;
        const double y1 = y0 + strokes[i].length * strokes[i].along.y;
        const double first = std::max(std::floor(std::min(y0, y1) - radius), 0.0);
        const double last = std::min(std::floor(std::max(y0, y1) + radius), height_px - 1.0);
        for (double y = first; y <= last; ++y)
            rows[static_cast<std::size_t>(y)].push_back(static_cast<std::uint32_t>(i));
    }
    return rows;
}

/// One row of pixels.
void draw_row(std::span<const Stroke> strokes,
              const std::vector<std::uint32_t>& in_row,
              double radius,
              int y,
              core::Image<float>& coverage) {
    const int width = coverage.width_px();
    std::vector<std::vector<std::uint32_t>> in_column(static_cast<std::size_t>(width));
    for (const std::uint32_t i : in_row) {
        const Columns columns = columns_in_row(strokes[i], y, radius, width);
        for (int x = columns.first; x <= columns.last; ++x)
            in_column[static_cast<std::size_t>(x)].push_back(i);
    }
    Blank blank(strokes, radius);
    for (int x = 0; x < width; ++x) {
        const auto& near = in_column[static_cast<std::size_t>(x)];
        if (near.empty()) continue;
        const double left = blank.of_pixel(x, y, near);
        coverage.at(x, y) = static_cast<float>(std::clamp(1 - left, 0.0, 1.0));
    }
}

}  // namespace

core::Image<float> draw_coverage(std::span<const truth::Curve> curves,
                                 int width_px,
                                 int height_px,
                                 double line_width_px) {
    core::Image<float> coverage(width_px, height_px);
    if (coverage.is_empty()) return coverage;
    const double radius = line_width_px / 2;
    std::vector<Stroke> strokes(curves.size());
    std::transform(curves.begin(), curves.end(), strokes.begin(), stroke_of);
    const auto rows = strokes_of_rows(strokes, radius, height_px);
    core::parallel_for(rows.size(), core::hardware_threads(), [&](std::size_t y) {
        if (!rows[y].empty()) draw_row(strokes, rows[y], radius, static_cast<int>(y), coverage);
    });
    return coverage;
}

}  // namespace ink::score
