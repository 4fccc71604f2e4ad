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

    // Lines of centres run along an axis: 0 for rows, 1 for columns.

    /// The side of centres far to the left, or far above.
    [[nodiscard]] int side_before(int along) const {
        return (end_[1 - along] > begin_[1 - along]) == (along == 0) ? 1 : -1;
    }
    /// The lines of centres that the segment crosses, from the first to before the last.
    [[nodiscard]] std::pair<int, int> lines(int along, int count) const {
        return lines_between(begin_[1 - along], end_[1 - along], count);
    }
    /// About where it crosses a line.
    [[nodiscard]] double place_on(int along, int line) const {
        const glm::dvec2 way = end_ - begin_;
        const double s = (line + 0.5 - begin_[1 - along]) / way[1 - along];
        return begin_[along] + s * way[along];
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
    const auto label = static_cast<std::uint8_t>(curve.line_class);
    const Segment segment(curve);
    for (const int along : {0, 1}) {
        core::Image<std::uint8_t>& marks = along == 0 ? cracks.right : cracks.below;
        const glm::ivec2 size(marks.width_px(), marks.height_px());
        const auto [first, last] = segment.lines(along, size[1 - along]);
        for (int line = first; line < last; ++line) {
            const double guess_px = segment.place_on(along, line);
            if (!(guess_px > -1 && guess_px < size[along] + 1)) continue;
            glm::ivec2 p(line);
            p[along] = find_change(guess_px, segment.side_before(along), [&](int i) {
                return along == 0 ? segment.side(i, line) : segment.side(line, i);
            });
            if (p[along] >= 0 && p[along] + 1 < size[along]) mark(marks.at(p.x, p.y), label);
        }
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
