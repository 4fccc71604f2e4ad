#pragma once

#include "methods/strokes/line_follower.h"

namespace ink::methods {

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
