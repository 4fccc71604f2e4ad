#include "draw/line_drawing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>
#include <optional>
#include <tuple>

namespace ink::draw {
namespace {

using truth::Curve;
using truth::CurvePoint;

/// Sine of the angle up to which pieces run the same way: finely faceted rims of one circle do.
constexpr double kSameWay = 0.1;
constexpr double kPoint_px = 1e-6;          ///< shorter than this is a point
constexpr double kBisected_px = 1 / 256.0;  ///< ends of visibility are known to 1/512 px

/// Of a piece, by the length from its begin, px.
struct Stretch {
    double from = 0;
    double to = 0;
};

glm::dvec2 place(const CurvePoint& p) {
    return {p.x_px, p.y_px};
}

double length_px(const Curve& curve) {
    return glm::distance(place(curve.begin), place(curve.end));
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Where `piece` lies on `other`.
std::optional<Stretch> shared(const Curve& piece, const Curve& other, double within_px) {
    const double length = length_px(piece);
    const glm::dvec2 origin = place(piece.begin);
    const glm::dvec2 along = (place(piece.end) - origin) / length;
    glm::dvec2 begin = place(other.begin) - origin, end = place(other.end) - origin;
    const double turn = cross(along, end - begin);
    if (std::abs(turn) > kSameWay * glm::length(end - begin)) return std::nullopt;
    if (glm::dot(along, end) < glm::dot(along, begin)) std::swap(begin, end);
    const double from = glm::dot(along, begin), to = glm::dot(along, end);
    Stretch on{std::max(from, 0.0), std::min(to, length)};
    const double aside = cross(along, begin), slope = (cross(along, end) - aside) / (to - from);
    if (slope != 0) {
        const double one = from + (within_px - aside) / slope;
        const double two = from + (-within_px - aside) / slope;
        on.from = std::max(on.from, std::min(one, two));
        on.to = std::min(on.to, std::max(one, two));
    } else if (std::abs(aside) > within_px) {
        return std::nullopt;
    }
    if (on.to - on.from <= kPoint_px) return std::nullopt;
    return on;
}

CurvePoint point_at(const Curve& curve, double share) {
    const auto mix = [&](double a, double b) { return a + share * (b - a); };
    return {mix(curve.begin.x_px, curve.end.x_px),
            mix(curve.begin.y_px, curve.end.y_px),
            1 / mix(1 / curve.begin.w, 1 / curve.end.w)};  // 1/w is affine on the image
}

/// What is left of a piece, in order; the piece itself where nothing is taken.
std::vector<Curve> rest_of(const Curve& piece, std::vector<Stretch> taken, double least_px) {
    if (taken.empty()) return {piece};
    std::ranges::sort(taken, {}, &Stretch::from);
    const double length = length_px(piece);
    taken.push_back({length, length});
    std::vector<Curve> rest;
    double from = 0;
    for (const Stretch& stretch : taken) {
        if (stretch.from - from > least_px) {
            rest.push_back(piece);
            if (from > 0) rest.back().begin = point_at(piece, from / length);
            if (stretch.from < length) rest.back().end = point_at(piece, stretch.from / length);
        }
        from = std::max(from, stretch.to);
    }
    return rest;
}

/// The pieces that stay, found by where they are.
class Cells {
  public:
    explicit Cells(const std::vector<Curve>& pieces) : all_(kSide * kSide) {
        glm::dvec2 high(-1e300);
        low_ = glm::dvec2(1e300);
        for (const Curve& piece : pieces) {
            for (const CurvePoint* p : {&piece.begin, &piece.end}) {
                low_ = glm::min(low_, place(*p));
                high = glm::max(high, place(*p));
            }
        }
        size_ = std::max({high.x - low_.x, high.y - low_.y, kPoint_px}) / kSide;
    }

    void add(const Curve& piece, std::uint32_t number) {
        visit(piece, 0, [&](std::vector<std::uint32_t>& cell) { cell.push_back(number); });
    }

    /// Those within that distance of the piece and some more, each once.
    [[nodiscard]] std::vector<std::uint32_t> near(const Curve& piece, double within_px) {
        std::vector<std::uint32_t> found;
        visit(piece, within_px, [&](const std::vector<std::uint32_t>& cell) {
            found.insert(found.end(), cell.begin(), cell.end());
        });
        std::ranges::sort(found);
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

  private:
    static constexpr int kSide = 128;

    static int number(double cell) {
        return static_cast<int>(std::clamp(std::floor(cell), 0.0, kSide - 1.0));
    }

    /// Row by row: the columns that the piece, made wider, takes of it.
    template <class Visit>
    void visit(const Curve& piece, double within_px, Visit&& visit_cell) {
        const glm::dvec2 a = (place(piece.begin) - low_) / size_;
        const glm::dvec2 b = (place(piece.end) - low_) / size_;
        const double wider = within_px / size_ + 1e-9;
        const int last = number(std::max(a.y, b.y) + wider);
        for (int row = number(std::min(a.y, b.y) - wider); row <= last; ++row) {
            double from = 0, to = 1;
            if (a.y != b.y) {
                const double one = (row - wider - a.y) / (b.y - a.y);
                const double two = (row + 1 + wider - a.y) / (b.y - a.y);
                from = std::clamp(std::min(one, two), 0.0, 1.0);
                to = std::clamp(std::max(one, two), 0.0, 1.0);
            }
            const double x0 = a.x + from * (b.x - a.x), x1 = a.x + to * (b.x - a.x);
            const int end = number(std::max(x0, x1) + wider);
            for (int column = number(std::min(x0, x1) - wider); column <= end; ++column)
                visit_cell(all_[static_cast<std::size_t>(row * kSide + column)]);
        }
    }

    glm::dvec2 low_;
    double size_ = 1;
    std::vector<std::vector<std::uint32_t>> all_;
};

/// The numbers of all pieces, visible ones first in `pieces`, the one that stays before the one
/// that is cut.
std::vector<std::uint32_t> by_precedence(const std::vector<Curve>& pieces, std::size_t visible) {
    const auto rank = [&](std::uint32_t i) {
        const Curve& piece = pieces[i];
        const double nearness = 1 / piece.begin.w + 1 / piece.end.w;
        return std::tuple(i >= visible, piece.line_class, -nearness, i);
    };
    std::vector<std::uint32_t> order(pieces.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, rank);
    return order;
}

}  // namespace

void remove_covered(truth::TracedLines& lines, double within_px) {
    const std::size_t visible = lines.curves.size();
    std::vector<Curve> pieces = std::move(lines.curves);
    pieces.insert(pieces.end(), lines.hidden.begin(), lines.hidden.end());
    Cells cells(pieces);
    const double least_px = std::max(kBisected_px, within_px / 10);
    std::vector<Curve> kept;
    std::vector<std::vector<Curve>> rest(pieces.size());
    for (const std::uint32_t i : by_precedence(pieces, visible)) {
        const Curve& piece = pieces[i];
        if (length_px(piece) <= kPoint_px) continue;
        std::vector<Stretch> taken;
        for (const std::uint32_t other : cells.near(piece, within_px)) {
            if (const auto stretch = shared(piece, kept[other], within_px))
                taken.push_back(*stretch);
        }
        rest[i] = rest_of(piece, std::move(taken), least_px);
        for (const Curve& part : rest[i]) {
            cells.add(part, static_cast<std::uint32_t>(kept.size()));
            kept.push_back(part);
        }
    }
    lines.curves.clear();
    lines.hidden.clear();
    for (std::size_t i = 0; i < rest.size(); ++i) {
        std::vector<Curve>& into = i < visible ? lines.curves : lines.hidden;
        into.insert(into.end(), rest[i].begin(), rest[i].end());
    }
}

}  // namespace ink::draw
