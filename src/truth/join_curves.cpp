#include "truth/join_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <limits>
#include <tuple>

namespace ink::truth {
namespace {

constexpr std::uint32_t kNoNeighbour = std::numeric_limits<std::uint32_t>::max();

/// One end of a curve: `2 * curve` its begin, `2 * curve + 1` its end.
using End = std::uint32_t;

/// Where an end is, in cells far finer than any line but coarser than rounding.
using Place = std::array<std::int64_t, 3>;

Place place_of(const CurvePoint& point) {
    constexpr double kPerPixel = 65536, kPerFold = 1e6;
    return {std::llround(point.x_px * kPerPixel),
            std::llround(point.y_px * kPerPixel),
            std::llround(std::log(point.w) * kPerFold)};
}

struct PlacedEnd {
    Place place{};
    LineClass line_class = LineClass::none;
    ContourKind kind = ContourKind::none;
    End end = 0;

    [[nodiscard]] auto group() const { return std::tie(place, line_class, kind); }
    friend auto operator<=>(const PlacedEnd&, const PlacedEnd&) = default;
};

/// The empty side as one leaves the vertex along the curve.
int leaving_side(std::span<const Curve> curves, End end) {
    const int side = curves[end / 2].empty_side;
    return end % 2 == 0 ? side : -side;
}

/// Per end the end it is joined to.
std::vector<End> pair_ends(std::span<const Curve> curves) {
    std::vector<PlacedEnd> ends;
    ends.reserve(2 * curves.size());
    for (std::uint32_t i = 0; i < curves.size(); ++i) {
        const Curve& curve = curves[i];
        ends.push_back({place_of(curve.begin), curve.line_class, curve.kind, 2 * i});
        ends.push_back({place_of(curve.end), curve.line_class, curve.kind, 2 * i + 1});
    }
    std::ranges::sort(ends);
    std::vector<End> neighbour(2 * curves.size(), kNoNeighbour);
    for (std::size_t i = 0; i < ends.size();) {
        std::size_t last = i + 1;
        while (last < ends.size() && ends[last].group() == ends[i].group())
            ++last;
        if (last - i == 2) {
            const End a = ends[i].end, b = ends[i + 1].end;
            if (a / 2 != b / 2 && leaving_side(curves, a) == -leaving_side(curves, b)) {
                neighbour[a] = b;
                neighbour[b] = a;
            }
        }
        i = last;
    }
    return neighbour;
}

/// The end from which a walk meets the whole run that holds the curve: where it starts, or the
/// curve's own begin if the run is closed.
End first_end(const std::vector<End>& neighbour, std::uint32_t curve) {
    const End begin = 2 * curve;
    End at = begin;
    while (neighbour[at] != kNoNeighbour) {
        at = neighbour[at] ^ 1U;  // through the neighbour to its other end
        if (at == begin) break;
    }
    return at;
}

Polyline walk(std::span<const Curve> curves, const std::vector<End>& neighbour, End from) {
    const Curve& first = curves[from / 2];
    Polyline line;
    line.line_class = first.line_class;
    line.kind = first.kind;
    line.empty_side = static_cast<std::int8_t>(leaving_side(curves, from));
    const auto point_at = [&](End end) {
        const Curve& curve = curves[end / 2];
        return end % 2 == 0 ? curve.begin : curve.end;
    };
    line.points.push_back(point_at(from));
    End at = from;
    do {
        line.curves.push_back(at / 2);
        line.points.push_back(point_at(at ^ 1U));
        at = neighbour[at ^ 1U];
    } while (at != kNoNeighbour && at != from);
    return line;
}

}  // namespace

std::vector<Polyline> join_curves(std::span<const Curve> curves) {
    const std::vector<End> neighbour = pair_ends(curves);
    std::vector<bool> is_walked(curves.size(), false);
    std::vector<Polyline> lines;
    for (std::uint32_t i = 0; i < curves.size(); ++i) {
        if (is_walked[i]) continue;
        lines.push_back(walk(curves, neighbour, first_end(neighbour, i)));
        for (const std::uint32_t curve : lines.back().curves)
            is_walked[curve] = true;
    }
    return lines;
}

}  // namespace ink::truth
