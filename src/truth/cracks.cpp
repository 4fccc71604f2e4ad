#include "truth/cracks.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <utility>

#include "scene/predicates.h"

namespace ink::truth {
namespace {

/// The sign of the area of the triangle (a, b, c), exact.
int orient2d(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    // Below this point each row of the 3x3 determinant is (x, y, 1).
    constexpr glm::dvec3 kBelow{0, 0, -1};
    return scene::orient3d({a, 0}, {b, 0}, {c, 0}, kBelow);
}

/// A curve as a directed segment that tells on which side of it a pixel's centre is.
///
/// Centres are moved by (e, e * e) with an infinitely small e (simulation of simplicity,
/// Edelsbrunner and Muecke 1990), so no centre is on a line.
class Segment {
  public:
    explicit Segment(const Curve& curve)
        : begin_(curve.begin.x_px, curve.begin.y_px), end_(curve.end.x_px, curve.end.y_px) {}

    /// 1 or -1 for the centre of pixel (x, y); the segment has a length.
    [[nodiscard]] int side(int x, int y) const {
        const int sign = orient2d(begin_, end_, {x + 0.5, y + 0.5});
        if (sign != 0) return sign;
        if (begin_.y != end_.y) return begin_.y > end_.y ? 1 : -1;
        return end_.x > begin_.x ? 1 : -1;
    }

    /// The side of centres far to the left, and of those far above.
    [[nodiscard]] int side_left() const { return end_.y > begin_.y ? 1 : -1; }
    [[nodiscard]] int side_above() const { return begin_.x > end_.x ? 1 : -1; }

    /// The rows whose line of centres the segment crosses, from the first to before the last.
    [[nodiscard]] std::pair<int, int> rows(int height_px) const {
        return lines_between(begin_.y, end_.y, height_px);
    }
    [[nodiscard]] std::pair<int, int> columns(int width_px) const {
        return lines_between(begin_.x, end_.x, width_px);
    }

    /// About where it crosses the centres' line of row y.
    [[nodiscard]] double x_at(int y) const {
        const double s = (y + 0.5 - begin_.y) / (end_.y - begin_.y);
        return begin_.x + s * (end_.x - begin_.x);
    }
    [[nodiscard]] double y_at(int x) const {
        const double s = (x + 0.5 - begin_.x) / (end_.x - begin_.x);
        return begin_.y + s * (end_.y - begin_.y);
    }

  private:
    /// The whole i of 0..count-1 for which i + 0.5, moved up a little, lies between a and b.
    static std::pair<int, int> lines_between(double a, double b, int count) {
        const auto first_from = [count](double v) {
            return static_cast<int>(
                std::clamp(std::ceil(v - 0.5), 0.0, static_cast<double>(count)));
        };
        return {first_from(std::min(a, b)), first_from(std::max(a, b))};
    }

    glm::dvec2 begin_, end_;
};

/// The i for which centre i of a row or column lies on the side `before` and centre i + 1 on the
/// other; `guess_px` is about where the change is.
template <class Side>
int find_change(double guess_px, int before, Side side) {
    int i = static_cast<int>(std::floor(guess_px - 0.5));
    while (side(i) != before)
        --i;
    while (side(i + 1) == before)
        ++i;
    return i;
}

void mark(std::uint8_t& crack, std::uint8_t label) {
    if (crack == 0 || label < crack) crack = label;
}

void draw(const Curve& curve, Cracks& cracks) {
    const int width = cracks.right.width_px();
    const int height = cracks.right.height_px();
    const auto label = static_cast<std::uint8_t>(curve.line_class);
    const Segment segment(curve);
    const auto [first_row, last_row] = segment.rows(height);
    for (int y = first_row; y < last_row; ++y) {
        const double guess_px = segment.x_at(y);
        if (!(guess_px > -1 && guess_px < width + 1)) continue;
        const int x =
            find_change(guess_px, segment.side_left(), [&](int i) { return segment.side(i, y); });
        if (x >= 0 && x + 1 < width) mark(cracks.right.at(x, y), label);
    }
    const auto [first_column, last_column] = segment.columns(width);
    for (int x = first_column; x < last_column; ++x) {
        const double guess_px = segment.y_at(x);
        if (!(guess_px > -1 && guess_px < height + 1)) continue;
        const int y =
            find_change(guess_px, segment.side_above(), [&](int i) { return segment.side(x, i); });
        if (y >= 0 && y + 1 < height) mark(cracks.below.at(x, y), label);
    }
}

}  // namespace

Cracks draw_cracks(std::span<const Curve> curves, int width_px, int height_px) {
    Cracks cracks;
    cracks.right = core::Image<std::uint8_t>(width_px, height_px);
    cracks.below = core::Image<std::uint8_t>(width_px, height_px);
    for (const Curve& curve : curves)
        draw(curve, cracks);
    return cracks;
}

}  // namespace ink::truth
