// Where lines leave cells, and whether they are seen there.

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "methods/strokes/cell_line.h"

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

}  // namespace ink::methods
