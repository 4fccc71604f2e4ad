#pragma once

#include <span>
#include <vector>

#include "methods/grey_lines/piece.h"
#include "methods/strokes/cell_line.h"

namespace ink::methods {

/// What a cell has of a line.
struct CellLine {
    Line line;
    std::array<LineEnd, 2> ends;
    std::array<bool, 2> dangles{false, false};  ///< an end at a vertex, from which nothing is known
};

/// Goes on along lines where no sample tells of them.
class LineFollower {
  public:
    LineFollower(const StrokeFrame& frame, std::vector<Piece>& pieces)
        : frame_(frame), pieces_(pieces) {}

    /// From where a line leaves a cell and is seen: on through the cells that it enters, as long as
    /// nothing hides it, to where samples have it again.
    void go_on(const Line& line, glm::ivec2 cell, LineEnd end, int most_cells = kMostCells);

    /// From an end of a line at a vertex: along the one other line there, and so on, until that
    /// comes to a line of the cell, or leaves the cell where it is seen. Draws nothing and returns
    /// false if it does not.
    bool follow(const CellLine& line,
                std::size_t end,
                const Cell& cell,
                std::span<const CellLine> known) {
        return follow_from(
            {.vertex = line.line.vertices[end], .face = line.line.face, .came_by = line.line.name},
            cell,
            known,
            kMostCells);
    }

    void draw(LineKind kind, const glm::dvec2& a, double qa, const glm::dvec2& b, double qb);

  private:
    static constexpr int kMostCells = 64;
    static constexpr int kMostEdges = 16;  ///< of a chain within a cell
    static constexpr int kMostFaces = 16;  ///< round a vertex, either way

    /// A vertex, a face at it, and the line that was followed to there.
    struct Stand {
        std::uint32_t vertex = kNoNeighbour;
        std::uint32_t face = kNoNeighbour;
        LineName came_by = 0;
    };
    /// A line that leaves a vertex.
    struct Way {
        std::uint32_t to = kNoNeighbour;
        std::uint32_t face = kNoNeighbour;
        LineKind kind = LineKind::none;
    };

    bool follow_from(Stand at, const Cell& cell, std::span<const CellLine> known, int most_cells);
    [[nodiscard]] std::optional<Way> only_way(const Stand& at) const;
    template <class Visit>
    void each_face_round(const Stand& at, const Visit& visit) const;
    [[nodiscard]] LineKind kind_of(std::uint32_t face, std::size_t edge) const;
    [[nodiscard]] LineKind kind_of_many(std::uint32_t face, std::size_t edge) const;

    const StrokeFrame& frame_;
    std::vector<Piece>& pieces_;
};

}  // namespace ink::methods
