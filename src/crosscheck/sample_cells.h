#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "crosscheck/mesh_walk.h"
#include "crosscheck/sight_rays.h"

namespace ink::crosscheck {

enum class CellState : std::uint8_t {
    plain,   ///< its corners and the known lines say all
    marked,  ///< to be looked at closely
    done     ///< was looked at closely
};

/// A way between two corners of the lattice that are not joined, and the cells on both sides of it.
struct LatticeWay : Way {
    std::array<glm::ivec2, 2> cells;
};

/// One sample per pixel over the image and a pixel beyond its left and upper frame, and which of
/// the cells between them deserve more.
class SampleCells {
  public:
    /// Borrows the mesh.
    explicit SampleCells(const ClipMesh& mesh);

    /// Looks once at every corner of the cells, to within what Embree's rounding leaves.
    void look(const EmbreeRays& rays, int threads);
    /// Finds the ways between neighbouring corners that are not joined, and how deep the surface
    /// lies in cells without one.
    void compare(int threads);
    /// Those ways, by rows.
    [[nodiscard]] const std::vector<LatticeWay>& open_ways() const { return open_ways_; }
    void mark_all();
    /// True if the cell was plain.
    bool mark(const glm::ivec2& cell);

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] std::size_t sample_count() const {
        return static_cast<std::size_t>(columns_ + 1) * (rows_ + 1);
    }
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
    /// The cell that holds a point, or the one nearest to it.
    [[nodiscard]] glm::ivec2 cell_of(const glm::dvec2& p_px) const;
    /// Whether a surface that goes on unbroken round the cell of `p_px` hides what lies at 1/w = q.
    [[nodiscard]] bool is_hidden(const glm::dvec2& p_px, double q) const {
        return 1 > hidden_behind_[index(cell_of(p_px))] * q;
    }
    /// The marked cells, by rows.
    [[nodiscard]] std::vector<glm::ivec2> marked() const;
    /// What is marked is done.
    void finish_marked();

  private:
    [[nodiscard]] bool contains(const glm::ivec2& cell) const {
        return cell.x >= 0 && cell.y >= 0 && cell.x < columns_ && cell.y < rows_;
    }
    [[nodiscard]] Sample corner(int x, int y) const;
    void compare_row(int y, std::vector<LatticeWay>& open, std::vector<std::uint8_t>& is_open);

    const ClipMesh& mesh_;
    int columns_;
    int rows_;
    // The large ones are written first by the threads that look and compare.
    std::unique_ptr<Sight[]> sights_;  ///< sample_count(), by rows
    std::vector<CellState> states_;
    std::unique_ptr<double[]> hidden_behind_;  ///< per cell: what lies farther away is not seen
    std::vector<LatticeWay> open_ways_;
};

}  // namespace ink::crosscheck
