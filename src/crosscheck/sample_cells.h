#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "crosscheck/sight_rays.h"

namespace ink::crosscheck {

enum class CellState : std::uint8_t {
    plain,   ///< its corners say all
    marked,  ///< to be looked at closely
    done,    ///< was looked at closely
    thin,    ///< was, and deserves more still
};

/// The part of an edge in a cell.
struct EdgePiece {
    std::uint32_t edge = 0;
    glm::ivec2 cell{0};
    glm::dvec2 begin_px{0};
    glm::dvec2 end_px{0};
};

/// One sample per pixel over the image and a pixel beyond its left and upper frame, and which of
/// the cells between them deserve more.
class SampleCells {
  public:
    /// Borrows the mesh.
    explicit SampleCells(const ClipMesh& mesh);

    /// Looks once at every corner of the cells.
    void look(const SightRays& rays, int threads);
    /// Marks the cells of whose four sides one is not joined.
    void mark_crossed(int threads);
    /// Marks the cells through which a feature edge runs, except behind a surface that goes on
    /// unbroken round the cell.
    void mark_edges(int threads);
    void mark_all();
    /// Adds the pieces of an edge, one in each cell that it runs through, but those hidden behind a
    /// surface that goes on unbroken round the cell.
    void add_pieces(std::uint32_t edge, std::vector<EdgePiece>& pieces) const;
    /// True if the cell was plain.
    bool mark(const glm::ivec2& cell);
    void mark(const glm::ivec2& cell, CellState state) { states_[index(cell)] = state; }

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] std::size_t sample_count() const { return sights_.size(); }
    [[nodiscard]] std::size_t index(const glm::ivec2& cell) const {
        return static_cast<std::size_t>(cell.y) * columns_ + cell.x;
    }
    [[nodiscard]] CellState state(const glm::ivec2& cell) const { return states_[index(cell)]; }
    /// Whether the cell is there and plain, so that nobody looks at its own ways.
    [[nodiscard]] bool is_unseen(const glm::ivec2& cell) const {
        return contains(cell) && states_[index(cell)] == CellState::plain;
    }
    /// Its upper left corner.
    [[nodiscard]] glm::dvec2 corner_px(const glm::ivec2& cell) const;
    /// Left to right, top to bottom.
    [[nodiscard]] std::array<Sight, 4> corners(const glm::ivec2& cell) const;
    /// What is marked is done.
    void finish_marked();

  private:
    [[nodiscard]] bool contains(const glm::ivec2& cell) const {
        return cell.x >= 0 && cell.y >= 0 && cell.x < columns_ && cell.y < rows_;
    }
    const ClipMesh& mesh_;
    int columns_;
    int rows_;
    std::vector<Sight> sights_;  ///< (columns + 1) x (rows + 1)
    std::vector<CellState> states_;
    std::vector<double> hidden_behind_;  ///< per cell: what lies farther away is not seen
};

}  // namespace ink::crosscheck
