// Where lines leave cells, and whether they are seen there.

#include "methods/strokes/cell_line.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace ink::methods {
namespace {

constexpr double kAtCorner_px = 0.008;  ///< two snappings: a line this near may leave either way
constexpr double kSameQ = 1e-5;         ///< relative: of a line and the surface it lies on
/// Lines where no sample has one must be so far in front: surfaces lie on each other.
constexpr double kInFront_px = 0.1;

std::array<double, 4> away_from_sides(const Cell& cell, const glm::dvec2& at) {
    const glm::dvec2 in = at - glm::dvec2(cell.at);
    return {std::abs(in.y), std::abs(in.x - 1), std::abs(in.y - 1), std::abs(in.x)};
}

bool has_line(std::span<const NamedCrossing> lines, LineName name) {
    return std::any_of(
        lines.begin(), lines.end(), [&](const NamedCrossing& line) { return line.name == name; });
}

/// Whether one face is on the patch of the other, or beside it.
bool is_own(const StrokeFrame& frame, std::uint32_t seen, std::uint32_t of) {
    if (seen == kNoNeighbour || of == kNoNeighbour) return false;
    const std::uint32_t patch = frame.face(seen).patch;
    if (frame.face(of).patch == patch) return true;
    const auto& twins = frame.face(of).twins;
    return std::any_of(twins.begin(), twins.end(), [&](Twin twin) {
        return !twin.is_nothing() && !twin.is_many() && frame.face(twin.face()).patch == patch;
    });
}

/// What is seen at a place of a side: 1/w of the surface, 0 of the sky; or nothing, between lines.
std::optional<double> surface_q(const StrokeFrame& frame,
                                const CellSide& side,
                                std::span<const NamedCrossing> lines,
                                const glm::dvec2& at) {
    const auto q = [&](std::uint32_t face, const glm::dvec2& where) {
        return face == kNoNeighbour ? 0 : plane_q(frame.screen, face, where);
    };
    const std::uint32_t first = frame.faces.at(side.from.x, side.from.y);
    const std::uint32_t second = frame.faces.at(side.to().x, side.to().y);
    const glm::dvec2 along = at - glm::dvec2(side.from);
    const double s = std::clamp(side.is_down ? along.y : along.x, 0.0, 1.0);
    if (lines.empty()) return (1 - s) * q(first, side.at(0)) + s * q(second, side.at(1));
    const auto [low, high] =
        std::minmax_element(lines.begin(), lines.end(), [](const auto& a, const auto& b) {
            return a.crossing.s < b.crossing.s;
        });
    if (s <= low->crossing.s) return q(first, at);
    if (s >= high->crossing.s) return q(second, at);
    return std::nullopt;
}

constexpr double kFarOff_px = 0.75;  ///< from where walks found it to the line of two planes

/// Sample (x, y) is the centre of pixel (x, y) of the view.
glm::dvec2 place(const glm::dvec3& p_clip) {
    return glm::dvec2(p_clip.x, p_clip.y) / p_clip.z - 0.5;
}

/// 1/w over the image.
struct DepthPlane {
    double constant, per_x, per_y;

    [[nodiscard]] double at(const glm::dvec2& p) const {
        return constant + per_x * p.x + per_y * p.y;
    }
};

/// By the plane in clip space, where n p = d: 1/w = n (x, y, 1) / d.
std::optional<DepthPlane> depth_plane(const ScreenMesh& screen, std::uint32_t face) {
    const auto& v = screen.mesh().faces[face].vertices;
    const glm::dvec3 a = screen.p_clip(v[0]), b = screen.p_clip(v[1]), c = screen.p_clip(v[2]);
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double d = glm::dot(n, a);
    if (!(std::abs(d) > 1e-300)) return std::nullopt;
    return DepthPlane{(n.z + 0.5 * (n.x + n.y)) / d, n.x / d, n.y / d};
}

}  // namespace

unsigned near_sides(const Cell& cell, const glm::dvec2& at) {
    const std::array<double, 4> away = away_from_sides(cell, at);
    unsigned near = 0;
    for (std::size_t side = 0; side < 4; ++side)
        near |= away[side] < kAtCorner_px ? 1U << side : 0;
    return near;
}

LineEnd end_in_cell(const Line& line, const Cell& cell, double t) {
    LineEnd end{.at = line.segment.at(t), .q = line.segment.q_at(t)};
    if (t <= 0 || t >= 1) return end;
    const std::array<double, 4> away = away_from_sides(cell, end.at);
    end.side = static_cast<int>(std::min_element(away.begin(), away.end()) - away.begin());
    const unsigned near = near_sides(cell, end.at);
    end.is_at_corner = std::popcount(near) >= 2;
    for (unsigned rest = near | 1U << end.side; rest != 0 && !end.is_confirmed; rest &= rest - 1)
        end.is_confirmed =
            has_line(cell.crossings[static_cast<std::size_t>(std::countr_zero(rest))], line.name);
    return end;
}

bool is_seen(const StrokeFrame& frame, const Cell& cell, const LineEnd& end, const Line& line) {
    const CellSide side(cell.at, end.side);
    const auto lines = cell.crossings[static_cast<std::size_t>(end.side)];
    const auto surface = surface_q(frame, side, lines, end.at);
    if (!surface || *surface == 0) return true;
    const auto owns = [&](const glm::ivec2& sample) {
        return is_own(frame, frame.faces.at(sample.x, sample.y), line.face);
    };
    if (!lines.empty() || (owns(side.from) && owns(side.to())))
        return *surface <= end.q * (1 + kSameQ);
    const scene::DepthSlope least = kInFront_px * frame.screen.projection().q_per_px();
    return *surface <= end.q * (1 - kSameQ - least.of_q) - least.constant;
}

std::optional<Segment> edge_segment(const ScreenMesh& screen, std::uint32_t a, std::uint32_t b) {
    glm::dvec3 from = screen.p_clip(a), to = screen.p_clip(b);
    const double near = screen.near();
    if (from.z < near && to.z < near) return std::nullopt;
    if (from.z < near) from += (to - from) * ((near - from.z) / (to.z - from.z));
    if (to.z < near) to += (from - to) * ((near - to.z) / (from.z - to.z));
    return Segment{place(from), place(to), 1 / from.z, 1 / to.z};
}

std::optional<Segment> intersection_segment(const ScreenMesh& screen,
                                            std::uint32_t face,
                                            std::uint32_t other,
                                            const glm::dvec2& at) {
    if (face == kNoNeighbour || other == kNoNeighbour) return std::nullopt;
    const auto f = depth_plane(screen, face), g = depth_plane(screen, other);
    if (!f || !g) return std::nullopt;
    const glm::dvec2 across{f->per_x - g->per_x, f->per_y - g->per_y};
    const double length = glm::length(across);
    if (!(length > 0)) return std::nullopt;
    const double off = (f->at(at) - g->at(at)) / length;
    if (!(std::abs(off) <= kFarOff_px)) return std::nullopt;
    const glm::dvec2 n = across / length, on = at - off * n, along{-n.y, n.x};
    const glm::dvec2 a = on - 2.0 * along, b = on + 2.0 * along;
    return Segment{a, b, f->at(a), f->at(b)};
}

double plane_q(const ScreenMesh& screen, std::uint32_t face, const glm::dvec2& at) {
    const auto plane = depth_plane(screen, face);
    return plane ? plane->at(at) : 0;
}

std::optional<Clipped> clip_to_cell(const Segment& segment, const glm::ivec2& cell) {
    Clipped part;
    const glm::dvec2 way = segment.b - segment.a;
    for (int i = 0; i < 2; ++i) {
        const double low = cell[i] - segment.a[i], high = low + 1;
        if (std::abs(way[i]) < 1e-12) {
            if (low > 0 || high < 0) return std::nullopt;
            continue;
        }
        const double to_low = low / way[i], to_high = high / way[i];
        part.from = std::max(part.from, std::min(to_low, to_high));
        part.to = std::min(part.to, std::max(to_low, to_high));
    }
    if (!(part.from <= part.to)) return std::nullopt;
    return part;
}

}  // namespace ink::methods
