#include "crosscheck/sample_cells.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "core/parallel.h"
#include "crosscheck/mesh_walk.h"

namespace ink::crosscheck {
namespace {

/// Where samples lie within 1/8 px: no edge of an axis-aligned scene runs through them.
constexpr glm::dvec2 kOffset_px{0.0773, 0.0477};
constexpr double kMargin_px = 0.01;  ///< a line this close to a cell may show in it
constexpr std::size_t kChunk = 4096;

/// A line on the image with 1/w along it.
struct ScreenSegment {
    glm::dvec2 a, b;
    double q_a = 0, q_b = 0;
};

/// A stretch of it.
struct Range {
    double begin = 0, end = 1;
    [[nodiscard]] bool is_empty() const { return begin > end; }
};

/// Where a + s (b - a) lies between low and high, within `range`.
Range clip(Range range, double a, double b, double low, double high) {
    if (a == b) return a >= low && a <= high ? range : Range{1, 0};
    const auto [first, last] = std::minmax({(low - a) / (b - a), (high - a) / (b - a)});
    return {std::max(range.begin, first), std::min(range.end, last)};
}

/// The part of an edge beyond the near plane; false if there is none.
bool project(const ClipMesh& mesh, const scene::Edge& edge, ScreenSegment& segment) {
    glm::dvec3 a = mesh.p_clip()[edge.a], b = mesh.p_clip()[edge.b];
    const double near = mesh.view().camera.near;
    if (a.z < near && b.z < near) return false;
    const glm::dvec3 cut = a + (b - a) * ((near - a.z) / (b.z - a.z));
    if (a.z < near) a = cut;
    if (b.z < near) b = cut;
    segment = {glm::dvec2(a) / a.z, glm::dvec2(b) / b.z, 1 / a.z, 1 / b.z};
    return true;
}

}  // namespace

SampleCells::SampleCells(const ClipMesh& mesh)
    : mesh_(mesh),
      columns_(mesh.view().width_px + 1),
      rows_(mesh.view().height_px + 1),
      sights_(static_cast<std::size_t>(columns_ + 1) * (rows_ + 1)),
      states_(static_cast<std::size_t>(columns_) * rows_, CellState::plain),
      hidden_behind_(states_.size(), std::numeric_limits<double>::infinity()) {}

glm::dvec2 SampleCells::corner_px(const glm::ivec2& cell) const {
    return glm::dvec2(cell) - 1.0 + kOffset_px;
}

std::array<Sight, 4> SampleCells::corners(const glm::ivec2& cell) const {
    const std::size_t pitch = columns_ + 1;
    const std::size_t first = cell.y * pitch + cell.x;
    return {sights_[first], sights_[first + 1], sights_[first + pitch], sights_[first + pitch + 1]};
}

void SampleCells::look(const SightRays& rays, int threads) {
    core::parallel_for(static_cast<std::size_t>(rows_) + 1, threads, [&](std::size_t y) {
        for (int x = 0; x <= columns_; ++x) {
            sights_[y * (columns_ + 1) + x] = rays.look(corner_px({x, static_cast<int>(y)}));
        }
    });
}

void SampleCells::mark_crossed(int threads) {
    core::parallel_for(static_cast<std::size_t>(rows_), threads, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < columns_; ++x) {
            const auto sight = corners({x, y});
            const auto sample = [&](int i) {
                return Sample{corner_px({x + i % 2, y + i / 2}), sight[i]};
            };
            const std::array<Sample, 4> s{sample(0), sample(1), sample(2), sample(3)};
            const bool is_whole = is_joined(mesh_, s[0], s[1]) && is_joined(mesh_, s[0], s[2]) &&
                                  is_joined(mesh_, s[1], s[3]) && is_joined(mesh_, s[2], s[3]);
            if (!is_whole) {
                states_[index({x, y})] = CellState::marked;
            } else if (sight[0].face != kNothing) {
                const auto by_depth = [](const Sight& a, const Sight& b) { return a.w < b.w; };
                const auto [low, high] = std::minmax_element(sight.begin(), sight.end(), by_depth);
                // As much again as the surface falls across the cell, for what it may do inside.
                hidden_behind_[index({x, y})] = high->w + (high->w - low->w);
            }
        }
    });
}

void SampleCells::add_pieces(std::uint32_t edge, std::vector<EdgePiece>& pieces) const {
    ScreenSegment line;
    if (!project(mesh_, mesh_.topology().edges[edge], line)) return;
    const glm::dvec2 a = line.a + 1.0 - kOffset_px, b = line.b + 1.0 - kOffset_px;
    Range all = clip({}, a.x, b.x, -kMargin_px, columns_ + kMargin_px);
    all = clip(all, a.y, b.y, -kMargin_px, rows_ + kMargin_px);
    if (all.is_empty()) return;
    const auto at = [](double from, double to, double s) { return from + s * (to - from); };
    const auto first_cell = [](double low) {
        return static_cast<int>(std::floor(low - kMargin_px));
    };
    const auto last_cell = [](double high) {
        return static_cast<int>(std::floor(high + kMargin_px));
    };
    const auto [top, bottom] = std::minmax({at(a.y, b.y, all.begin), at(a.y, b.y, all.end)});
    for (int y = std::max(0, first_cell(top)); y <= std::min(rows_ - 1, last_cell(bottom)); ++y) {
        const Range row = clip(all, a.y, b.y, y - kMargin_px, y + 1 + kMargin_px);
        if (row.is_empty()) continue;
        const auto [left, right] = std::minmax({at(a.x, b.x, row.begin), at(a.x, b.x, row.end)});
        for (int x = std::max(0, first_cell(left)); x <= std::min(columns_ - 1, last_cell(right));
             ++x) {
            const Range part = clip(row, a.x, b.x, x - kMargin_px, x + 1 + kMargin_px);
            if (part.is_empty()) continue;
            const double q =
                std::max(at(line.q_a, line.q_b, part.begin), at(line.q_a, line.q_b, part.end));
            if (1 / q > hidden_behind_[index({x, y})]) continue;
            pieces.push_back({edge,
                              glm::ivec2(x, y),
                              glm::mix(line.a, line.b, part.begin),
                              glm::mix(line.a, line.b, part.end)});
        }
    }
}

void SampleCells::mark_edges(int threads) {
    const std::size_t count = mesh_.topology().edges.size();
    std::vector<std::vector<EdgePiece>> found((count + kChunk - 1) / kChunk);
    core::parallel_for(found.size(), threads, [&](std::size_t chunk) {
        const std::size_t end = std::min(count, (chunk + 1) * kChunk);
        for (std::size_t e = chunk * kChunk; e < end; ++e) {
            const auto edge = static_cast<std::uint32_t>(e);
            if (mesh_.is_feature(edge)) add_pieces(edge, found[chunk]);
        }
    });
    for (const auto& part : found) {
        for (const EdgePiece& piece : part)
            mark(piece.cell);
    }
}

void SampleCells::mark_all() {
    std::fill(states_.begin(), states_.end(), CellState::marked);
}

bool SampleCells::mark(const glm::ivec2& cell) {
    CellState& state = states_[index(cell)];
    if (state != CellState::plain) return false;
    state = CellState::marked;
    return true;
}

void SampleCells::finish_marked() {
    for (CellState& state : states_) {
        if (state == CellState::marked) state = CellState::done;
    }
}

}  // namespace ink::crosscheck
