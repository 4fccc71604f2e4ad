#pragma once

#include <array>
#include <bit>
#include <vector>

#include "buffers/surface_method.h"
#include "core/param.h"
#include "methods/grey_lines/ink.h"
#include "methods/mesh_lookup/lookup_mesh.h"
#include "methods/mesh_lookup/lookup_method.h"
#include "raster/depth/depth.h"
#include "raster/pass/bin.h"

namespace ink::methods {

/// How wide lines are: the widest, and shares of that by class and by distance.
struct WidthParams {
    double width_px = 1;
    double contours = 1;
    double creases = 1;
    double intersections = 1;
    double seams = 1;
    double far_width = 1;
    double near_at = 0;
    double far_at = 1;
};

inline constexpr double kMostWidth_px = 4;

/// Appends the rows of WidthParams to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_width_params(core::ParamTable<P>& table) {
    return table
        .number(&P::width_px, "width_px", {1, kMostWidth_px}, "px", "Width of the widest lines.")
        .number(&P::contours,
                "contours",
                {0, 1},
                "",
                "Width of contours and boundaries, as a share of width_px; 0: none.")
        .number(&P::creases, "creases", {0, 1}, "", "The same of creases.")
        .number(&P::intersections, "intersections", {0, 1}, "", "The same of intersections.")
        .number(&P::seams, "seams", {0, 1}, "", "The same of seams.")
        .number(&P::far_width,
                "far_width",
                {0, 1},
                "",
                "Width at far_at and beyond, as a share of that at near_at and before.")
        .number(&P::near_at,
                "near_at",
                {0, 1},
                "",
                "A distance: 0 the near end of the ball round the scene, 1 its far end.")
        .number(&P::far_at, "far_at", {0, 1}, "", "The same, beyond near_at.");
}

/// WidthParams as one view sees them, `range` being how far its scene reaches.
class LineWidths {
  public:
    LineWidths() = default;
    LineWidths(const WidthParams& params, const raster::DepthRange& range);

    /// Half the width of a line of a kind, where it is as far as 1/w says; 0 is not known, and
    /// near.
    [[nodiscard]] float half_px(LineKind kind, double q) const {
        const float half = half_px_[static_cast<std::size_t>(kind)];
        return far_width_ == 1 || !(q > 0) ? half : half * share_at(q);
    }

  private:
    [[nodiscard]] float share_at(double q) const;

    std::array<float, 6> half_px_{};  ///< by kind
    double far_width_ = 1, near_at_ = 0, far_at_ = 1;
    raster::DepthRange range_;
};

struct InkParams : LookupParams, WidthParams {
    double jump_px = 0.1;  // that of surface_lookup

    /// A little below half, so that a line which covers half of two pixels is lost in neither. From
    /// the catalogue, whose F is level from 104 to 118; also of true ink more is right than at 128.
    InkParams() { threshold = 118; }
};

/// Appends the rows of InkParams to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_ink_params(core::ParamTable<P>& table) {
    return add_jump_param(add_lookup_params(add_width_params(table)))
        .number(&P::threshold, "threshold", {1, 255}, "of 255", "Least share of a line pixel.");
}

/// A method that draws the lines behind the samples of surface_lookup as ink.
///
/// Its samples are pixel corners, as many more round the frame as a line just outside needs to
/// reach in. Each finished tile is walked between its samples; then every cell between four samples
/// makes pieces of lines of what was found on its sides; then these are drawn.
class InkMethod : public buffers::SurfaceMethod<LookupPass> {
  public:
    static constexpr bool kDrawsInk = true;

  protected:
    InkMethod(std::string_view name, const InkParams& params);

    /// Called first, for a frame of samples.
    virtual void begin(const raster::TileGrid& samples) = 0;
    /// Finds the lines of a tile that is not empty. From several threads, each with its own tile.
    virtual void look(const raster::Tile& tile) = 0;
    /// Appends the pieces of all cells of tile `tile`, once all tiles were looked at. Likewise.
    virtual void join(std::size_t tile, std::vector<Piece>& pieces) = 0;
    /// Called last. Cell (x, y) is the pixel that lies `margin_px` further left and up.
    virtual void touch_up(int /*margin_px*/, int /*threads*/, edge::EdgeImage& /*out*/) {}

    /// The widths in the frame that is drawn.
    [[nodiscard]] LineWidths widths() const { return {params_, pass().inputs().range()}; }
    /// Calls found(x, y, is_down, lines) for each side of a tile between whose samples lines are,
    /// row by row; (x, y) is of the frame.
    template <class Found>
    void each_lined_side(const raster::Tile& tile, const Found& found) const;

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) final;
    [[nodiscard]] method::PixelBytes filter_bytes() const override { return {8, 1}; }

    WidthParams params_;
    std::vector<std::vector<Piece>> pieces_;  ///< by tiles; kept, for they are as many again
};

/// The sides of a tile that are walked, a bit each.
struct AskedSides {
    std::array<std::uint64_t, raster::kTileSize_px> right{}, down{};

    AskedSides(const LookupPass& pass, const raster::Tile& tile);
};

template <class Found>
void InkMethod::each_lined_side(const raster::Tile& tile, const Found& found) const {
    const AskedSides asked(pass(), tile);
    const auto face = [](std::uint32_t word) {
        return word == kNoNeighbour ? word : word & LookupWord::kFaceOfCoded;
    };
    SideLines lines;
    for (int y = 0; y < tile.height_px; ++y) {
        const auto* const words = tile.row<std::uint32_t>(0, y);
        for (const bool is_down : {false, true}) {
            std::uint64_t bits = (is_down ? asked.down : asked.right)[static_cast<std::size_t>(y)];
            for (; bits != 0; bits &= bits - 1) {
                const int x = std::countr_zero(bits);
                const SampleSide side{tile.x0_px + x,
                                      tile.y0_px + y,
                                      is_down,
                                      face(words[x]),
                                      face(words[is_down ? x + tile.stride : x + 1])};
                pass().screen().lines_between(side, lines);
                if (lines.count > 0) found(side.x, side.y, is_down, lines);
            }
        }
    }
}

}  // namespace ink::methods
