#include "scene/near_points.h"

#include <algorithm>
#include <array>
#include <compare>
#include <glm/geometric.hpp>
#include <tuple>

namespace ink::scene {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellPoint {
    Cell cell{};
    std::uint32_t point = 0;
    friend auto operator<=>(const CellPoint&, const CellPoint&) = default;
};

// Cells are a little wider than the distance, so that two points within it lie in neighbouring
// cells whatever the division rounds.
constexpr double kCellWidth = 1.01;  ///< distances

std::vector<CellPoint> sorted_by_cell(std::span<const glm::dvec3> points,
                                      std::span<const std::uint32_t> part,
                                      double distance) {
    glm::dvec3 low = points[part.front()];
    for (const std::uint32_t i : part)
        low = glm::min(low, points[i]);
    std::vector<CellPoint> cells;
    cells.reserve(part.size());
    for (const std::uint32_t i : part) {
        const glm::dvec3 at = (points[i] - low) / (kCellWidth * distance);
        cells.push_back({{static_cast<std::int64_t>(at.x),
                          static_cast<std::int64_t>(at.y),
                          static_cast<std::int64_t>(at.z)},
                         i});
    }
    std::ranges::sort(cells);
    return cells;
}

/// Where neighbours of a cell stand in the sorted list: three cells in a row along z. These five
/// rows hold the cell itself and each pair of neighbours once.
constexpr std::array<std::array<std::int64_t, 2>, 5> kRows = {
    {{0, 0}, {0, 1}, {1, -1}, {1, 0}, {1, 1}}};

bool is_before(const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

}  // namespace

NearPoints::NearPoints(std::span<const glm::dvec3> points)
    : points_(points), sets_(points.size()) {}

void NearPoints::add(std::span<const std::uint32_t> part, double distance) {
    if (part.empty() || !(distance > 0)) return;
    const std::vector<CellPoint> cells = sorted_by_cell(points_, part, distance);
    for (const auto& [dx, dy] : kRows) {
        // As the cells ascend so do the rows beside them: one pointer follows.
        std::size_t first = 0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto& [cell, point] = cells[i];
            const Cell low{cell[0] + dx, cell[1] + dy, cell[2] - 1};
            const Cell high{cell[0] + dx, cell[1] + dy, cell[2] + 1};
            while (first < cells.size() && cells[first].cell < low)
                ++first;
            for (std::size_t j = first; j < cells.size() && !(high < cells[j].cell); ++j) {
                const std::uint32_t other = cells[j].point;
                if (other == point) continue;
                if (glm::length(points_[point] - points_[other]) <= distance)
                    sets_.join(point, other);
            }
        }
    }
}

std::vector<glm::dvec3> NearPoints::representatives() {
    std::vector<glm::dvec3> first(points_.begin(), points_.end());
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
        glm::dvec3& best = first[sets_.root(i)];
        if (is_before(points_[i], best)) best = points_[i];
    }
    for (std::uint32_t i = 0; i < points_.size(); ++i)
        first[i] = first[sets_.root(i)];
    return first;
}

}  // namespace ink::scene
