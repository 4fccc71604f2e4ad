#pragma once

#include <span>
#include <vector>

#include "methods/grey_lines/ink.h"
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

/// Makes pieces of the lines that cross the sides of cells.
class CellStrokes {
  public:
    CellStrokes(const StrokeFrame& frame, std::vector<Piece>& pieces)
        : frame_(frame), pieces_(pieces), follower_(frame, pieces) {}

    /// Appends the pieces that begin in a cell, which is named by its upper left sample.
    void draw(const glm::ivec2& at);

  private:
    static constexpr std::size_t kMost = 32;
    /// An end that dangles: of which line, and which.
    struct Dangling {
        std::size_t line, end;
        bool is_done;
    };

    /// An edge that was met in this tile, and the part of it that was drawn last.
    struct KnownEdge {
        Line line;
        Clipped part;
        std::size_t piece = 0;
    };

    [[nodiscard]] bool draw_plain();
    void draw_part(KnownEdge& edge, const Clipped& part, const Piece& piece);
    [[nodiscard]] KnownEdge* known_edge(const NamedCrossing& crossing);
    void gather();
    void add(const NamedCrossing& crossing, const glm::dvec2& at);
    [[nodiscard]] std::optional<Line> line_of(const NamedCrossing& crossing, const glm::dvec2& at);
    void settle(CellLine& line, std::size_t end);
    void cut(CellLine& line, std::size_t end) const;
    void join_dangling();
    void join_nearest(std::span<Dangling> dangling);
    void join_unknown();
    [[nodiscard]] std::span<CellLine> lines() { return {lines_.data(), line_count_}; }
    [[nodiscard]] const LineEnd& end_of(const Dangling& at) const {
        return lines_[at.line].ends[at.end];
    }

    const StrokeFrame& frame_;
    std::vector<Piece>& pieces_;
    LineFollower follower_;
    std::array<KnownEdge, 64> edges_;  ///< by what is left of their names
    Cell cell_;
    std::array<CellLine, kMost> lines_;
    std::size_t line_count_ = 0;
    std::array<glm::dvec2, kMost> unknown_;  ///< where there is a line, and no more is known
    std::size_t unknown_count_ = 0;
};

}  // namespace ink::methods
