#include "crosscheck/sample_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"

namespace ink::crosscheck {
namespace {

/// Where samples lie within 1/8 px: no edge of an axis-aligned scene runs through them.
constexpr glm::dvec2 kOffset_px{0.0773, 0.0477};
/// Of a depth: what two ways to it differ by where surfaces touch.
constexpr double kSlack = 1e-6;

}  // namespace

SampleCells::SampleCells(const ClipMesh& mesh)
    : mesh_(mesh),
      columns_(mesh.view().width_px + 1),
      rows_(mesh.view().height_px + 1),
      sights_(std::make_unique_for_overwrite<Sight[]>(sample_count())),
      states_(static_cast<std::size_t>(columns_) * rows_, CellState::plain),
      hidden_behind_(std::make_unique_for_overwrite<double[]>(states_.size())) {}

glm::dvec2 SampleCells::corner_px(const glm::ivec2& cell) const {
    return glm::dvec2(cell) - 1.0 + kOffset_px;
}

glm::ivec2 SampleCells::cell_of(const glm::dvec2& p_px) const {
    const glm::dvec2 at = p_px + 1.0 - kOffset_px;
    return {std::clamp(static_cast<int>(std::floor(at.x)), 0, columns_ - 1),
            std::clamp(static_cast<int>(std::floor(at.y)), 0, rows_ - 1)};
}

Sample SampleCells::corner(int x, int y) const {
    return {corner_px({x, y}), sights_[static_cast<std::size_t>(y) * (columns_ + 1) + x]};
}

void SampleCells::look(const EmbreeRays& rays, int threads) {
    core::parallel_for(static_cast<std::size_t>(rows_) + 1, threads, [&](std::size_t y) {
        for (int x = 0; x <= columns_; x += EmbreeRays::kPacket) {
            const int count = std::min(EmbreeRays::kPacket, columns_ + 1 - x);
            rays.look_along(corner_px({x, static_cast<int>(y)}),
                            {&sights_[y * (columns_ + 1) + x], static_cast<std::size_t>(count)});
        }
    });
}

void SampleCells::compare(int threads) {
    // Of a corner: 1 if the way to the right of it is open, 2 if that down is.
    std::vector<std::uint8_t> is_open(sample_count(), 0);
    std::vector<std::vector<LatticeWay>> open(static_cast<std::size_t>(rows_) + 1);
    core::parallel_for(open.size(), threads, [&](std::size_t y) {
        compare_row(static_cast<int>(y), open[y], is_open);
    });
    for (const auto& row : open)
        open_ways_.insert(open_ways_.end(), row.begin(), row.end());
    core::parallel_for(static_cast<std::size_t>(rows_), threads, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        const std::size_t pitch = static_cast<std::size_t>(columns_) + 1;
        for (int x = 0; x < columns_; ++x) {
            const std::size_t i = row * pitch + x;
            double& hidden_behind = hidden_behind_[index({x, y})];
            hidden_behind = std::numeric_limits<double>::infinity();
            const bool is_whole =
                is_open[i] == 0 && (is_open[i + 1] & 2) == 0 && (is_open[i + pitch] & 1) == 0;
            if (!is_whole || sights_[i].face == kNothing) continue;
            const auto [low, high] = std::minmax(
                {sights_[i].w, sights_[i + 1].w, sights_[i + pitch].w, sights_[i + pitch + 1].w});
            // As much again as the surface falls across the cell, for what it may do inside.
            hidden_behind = (high + (high - low)) * (1 + kSlack);
        }
    });
}

void SampleCells::compare_row(int y,
                              std::vector<LatticeWay>& open,
                              std::vector<std::uint8_t>& is_open) {
    const auto test = [&](int x, int to_x, int to_y, std::uint8_t bit, const glm::ivec2& other) {
        const Sample a = corner(x, y), b = corner(to_x, to_y);
        if (is_joined(mesh_, a, b)) return;
        is_open[static_cast<std::size_t>(y) * (columns_ + 1) + x] |= bit;
        open.push_back({{a, b}, {glm::ivec2(x, y), other}});
    };
    for (int x = 0; x <= columns_; ++x) {
        if (x < columns_) test(x, x + 1, y, 1, {x, y - 1});
        if (y < rows_) test(x, x, y + 1, 2, {x - 1, y});
    }
}

void SampleCells::mark_all() {
    std::ranges::fill(states_, CellState::marked);
}

bool SampleCells::mark(const glm::ivec2& cell) {
    if (!is_unseen(cell)) return false;
    states_[index(cell)] = CellState::marked;
    return true;
}

std::vector<glm::ivec2> SampleCells::marked() const {
    std::vector<glm::ivec2> found;
    for (auto at = states_.begin();
         (at = std::find(at, states_.end(), CellState::marked)) != states_.end();
         ++at) {
        const auto i = static_cast<int>(at - states_.begin());
        found.emplace_back(i % columns_, i / columns_);
    }
    return found;
}

void SampleCells::finish_marked() {
    for (CellState& state : states_) {
        if (state == CellState::marked) state = CellState::done;
    }
}

}  // namespace ink::crosscheck
