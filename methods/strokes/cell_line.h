#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "methods/grey_lines/ink_method.h"
#include "methods/grey_lines/lined_sides.h"
#include "methods/mesh_lookup/screen_mesh.h"
#include "methods/mesh_lookup/side_lists.h"

namespace ink::methods {

/// The faces seen at the samples of a frame.
class SampleFaces {
  public:
    void reset(const raster::TileGrid& grid) { tiles_.reset(grid); }
    void take(const raster::Tile& tile) {
        Tile& to = tiles_.of(tile.x0_px, tile.y0_px);
        to.is_sky = false;
        for (int y = 0; y < tile.height_px; ++y)
            std::copy_n(
                tile.row<std::uint32_t>(0, y), tile.width_px, to.words.data() + Tiles::place(0, y));
    }
    /// At a sample of the frame; kNoNeighbour is sky.
    [[nodiscard]] std::uint32_t at(int x, int y) const {
        const Tile& tile = tiles_.of(x, y);
        if (tile.is_sky) return kNoNeighbour;
        const std::uint32_t word = tile.words[Tiles::place(x, y)];
        return word == kNoNeighbour ? word : word & LookupWord::kFaceOfCoded;
    }

  private:
    struct Tile;
    using Tiles = SampleTiles<Tile>;
    struct Tile {
        bool is_sky = true;
        std::array<std::uint32_t, Tiles::kCount> words;

        void clear() { is_sky = true; }
    };

    Tiles tiles_;
};

/// What is straight on the image, in samples, with 1/w at its ends, between which that is linear.
struct Segment {
    glm::dvec2 a{0}, b{0};
    double qa = 0, qb = 0;

    [[nodiscard]] glm::dvec2 at(double t) const { return a + t * (b - a); }
    [[nodiscard]] double q_at(double t) const { return qa + t * (qb - qa); }
};

/// What is left of a segment in a cell, as parts of its length.
struct Clipped {
    double from = 0, to = 1;
};

/// An edge between two vertices, not snapped; of one that reaches before the near plane what lies
/// beyond.
[[nodiscard]] std::optional<Segment> edge_segment(const ScreenMesh& screen,
                                                  std::uint32_t a,
                                                  std::uint32_t b);

/// Where two faces are equally far, about as long as two cells, near `at`; nothing if that is
/// nowhere near.
[[nodiscard]] std::optional<Segment> intersection_segment(const ScreenMesh& screen,
                                                          std::uint32_t face,
                                                          std::uint32_t other,
                                                          const glm::dvec2& at);

/// 1/w of a face's plane at a place; 0 of one that is seen edge-on.
[[nodiscard]] double plane_q(const ScreenMesh& screen, std::uint32_t face, const glm::dvec2& at);

/// Nothing if it misses the cell, which is named by its upper left sample.
[[nodiscard]] std::optional<Clipped> clip_to_cell(const Segment& segment, const glm::ivec2& cell);

/// Names an edge by its vertices, or an intersection by its faces; 0 is none.
using LineName = std::uint64_t;

[[nodiscard]] inline LineName edge_name(std::uint32_t a, std::uint32_t b) {
    return LineName{std::min(a, b)} << 32 | std::max(a, b);
}
[[nodiscard]] inline LineName intersection_name(std::uint32_t face, std::uint32_t other) {
    return LineName{1} << 63 | LineName{std::min(face, other)} << 31 | std::max(face, other);
}
[[nodiscard]] inline LineName name_of(const Crossing& crossing, const ScreenMesh& screen) {
    if (crossing.face == kNoNeighbour || crossing.edge > Crossing::kIntersection) return 0;
    if (crossing.edge == Crossing::kIntersection)
        return intersection_name(crossing.face, crossing.other);
    const auto& v = screen.mesh().faces[crossing.face].vertices;
    return edge_name(v[crossing.edge], v[(crossing.edge + 1U) % 3]);
}

/// A line between two samples by its name.
struct NamedCrossing {
    LineName name = 0;
    Crossing crossing;
};

/// A cell, by its upper left sample, and what crosses its sides: 0 above, 1 right, 2 below, 3 left.
struct Cell {
    glm::ivec2 at{0};
    std::array<std::span<const NamedCrossing>, 4> crossings;
};

/// What is known of a frame once all of its tiles were walked.
struct StrokeFrame {
    const ScreenMesh& screen;
    const LinedSides<NamedCrossing>& sides;
    const SampleFaces& faces;
    LineWidths widths;

    [[nodiscard]] const LookupFace& face(std::uint32_t i) const { return screen.mesh().faces[i]; }
    [[nodiscard]] Cell cell(const glm::ivec2& at) const {
        return {at,
                {sides.at(at.x, at.y, false),
                 sides.at(at.x + 1, at.y, true),
                 sides.at(at.x, at.y + 1, false),
                 sides.at(at.x, at.y, true)}};
    }
};

/// A whole line on the image.
struct Line {
    LineName name = 0;
    LineKind kind = LineKind::none;
    Segment segment = {};
    std::uint32_t face = kNoNeighbour;                                  ///< one of its faces
    std::array<std::uint32_t, 2> vertices{kNoNeighbour, kNoNeighbour};  ///< of an edge, as segment

    [[nodiscard]] bool is_edge() const { return vertices[0] != kNoNeighbour; }
};

/// An end of what a cell has of a line.
struct LineEnd {
    glm::dvec2 at{0};
    double q = 0;
    int side = -1;              ///< of the cell; -1 a vertex
    bool is_confirmed = false;  ///< samples say that the line goes on there
    bool is_at_corner = false;

    [[nodiscard]] bool is_vertex() const { return side < 0; }
};

/// A side of a cell: its first sample, and whether the other lies below it.
struct CellSide {
    glm::ivec2 from;
    bool is_down;

    CellSide(const glm::ivec2& cell, int side)
        : from(cell.x + (side == 1 ? 1 : 0), cell.y + (side == 2 ? 1 : 0)),
          is_down(side == 1 || side == 3) {}
    [[nodiscard]] glm::ivec2 to() const {
        return from + glm::ivec2(is_down ? 0 : 1, is_down ? 1 : 0);
    }
    [[nodiscard]] glm::dvec2 at(double s) const {
        return glm::dvec2(from) + s * glm::dvec2(to() - from);
    }
};

/// The sides of a cell, a bit each, on which a place is, or as good as.
[[nodiscard]] unsigned near_sides(const Cell& cell, const glm::dvec2& at);

/// The end of a line in a cell at `t` of its length, at a vertex or where it leaves.
[[nodiscard]] LineEnd end_in_cell(const Line& line, const Cell& cell, double t);

/// Whether a line that leaves a cell where no sample has it is seen there: in front of what samples
/// see, or between two lines of that side, of which nothing is known.
[[nodiscard]] bool is_seen(const StrokeFrame& frame,
                           const Cell& cell,
                           const LineEnd& end,
                           const Line& line);

}  // namespace ink::methods
