#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "methods/mesh_lookup/lookup_mesh.h"
#include "raster/pass/pass.h"

namespace ink::methods {

/// A word a sample: a face, and above it, where lines are told by codes too, a flag and a code.
struct LookupWord {
    static constexpr std::uint32_t kFaceOfCoded = 0x7fffff;
    static constexpr std::uint32_t kFlag = 0x800000;
    static constexpr int kCodeShift = 24;

    /// Throws core::Error if so many faces have no numbers.
    static void require_room(std::string_view method, std::size_t faces);
};

/// What codes and depths decide without the mesh, of words that hold codes.
struct CodeRule {
    /// A bend of q = 1/w: of_q q + constant.
    struct Bend {
        float of_q = 0;
        float constant = 0;
    };
    Bend jump;      ///< least at both samples that is looked up
    Bend flat;      ///< least at either where codes are trusted
    int trust = 4;  ///< codes this far apart are a line, unless one is flagged
};

/// The pixels of a tile that are lines, a bit each. Rows -1 and kTileSize_px are there to be
/// written to.
class LineBits {
  public:
    void clear() { rows_.fill(0); }
    [[nodiscard]] std::uint64_t row(int y) const { return rows_[static_cast<std::size_t>(y + 1)]; }
    [[nodiscard]] bool is_set(int x, int y) const { return (row(y) >> x & 1) != 0; }
    /// Whether a pixel is set, or lies beyond the tile, where nobody reads it.
    [[nodiscard]] bool is_done(int x, int y) const { return !is_inside(x, y) || is_set(x, y); }
    void set(int x, int y) {
        if (is_inside(x, y)) at(y) |= std::uint64_t{1} << x;
    }
    /// The pixels on either side of sides to the right of samples (x + i, y), one per bit.
    void set_right(int x, int y, std::uint64_t bits) {
        if (x >= raster::kTileSize_px) return;
        at(y) |= bits << x;
        at(y - 1) |= bits << x;
    }
    /// The same of sides to the samples below.
    void set_down(int x, int y, std::uint64_t bits) {
        if (x < raster::kTileSize_px) at(y) |= bits << x;
        at(y) |= x > 0 ? bits << (x - 1) : bits >> 1;
    }

  private:
    static_assert(raster::kTileSize_px == 64);
    [[nodiscard]] static bool is_inside(int x, int y) {
        return x >= 0 && x < raster::kTileSize_px && y >= 0 && y < raster::kTileSize_px;
    }
    std::uint64_t& at(int y) { return rows_[static_cast<std::size_t>(y + 1)]; }

    std::array<std::uint64_t, raster::kTileSize_px + 2> rows_;
};

/// Sides between neighbouring samples of a tile: 2^8 (y + 1) + 2 (x + 1), and 1 for the side down.
struct SideList {
    static constexpr std::size_t kSpan = raster::kTileSize_px + 2;

    std::array<std::uint32_t, 2 * kSpan * kSpan + 16> places;  // a vector more than there may be
    std::size_t count = 0;
};

/// A tile of words and the mesh whose faces they name.
struct WordTile {
    const raster::Tile& tile;
    bool has_corners = true;                 ///< samples are pixel corners, not centres
    std::uint32_t face_bits = kNoNeighbour;  ///< of a word
    std::span<const LookupFace> faces;
    std::span<const std::int8_t> facing;     ///< as ScreenMesh has it
    std::span<const std::uint8_t> is_cut{};  ///< likewise
};

/// Lists the sides of a tile whose samples differ in their faces, but for those over an edge that
/// is no line from here. With a `rule`, which is for corners, what codes and depths call none is
/// left out, too. What they call a line, and all sides to the sky, are not listed but set their
/// pixels in `lines`, unless that is null; but not at a face that the near plane cuts: the cut is
/// no line, which the mesh alone knows. Row by row. The same on every SIMD target.
void list_sides(const WordTile& words, const CodeRule* rule, LineBits* lines, SideList& list);

/// Writes 255 for each bit and 0 for the others, `width_px` of them.
void write_bits(std::uint64_t bits, int width_px, std::uint8_t* out);

}  // namespace ink::methods
