#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/depth/coarse_depth.h"
#include "raster/mesh/front_depth.h"
#include "raster/mesh/lane_triangles.h"
#include "raster/mesh/mesh_stage.h"
#include "raster/pass/tile_buffer.h"
#include "raster/pass/tile_fill.h"

namespace ink::raster {

/// One thread's share of filling tiles: its buffers, used for tile after tile, and what it skipped.
class MeshTileWorker {
  public:
    /// All are borrowed. `fronts`: how many of the runs are of the nearest clusters and drawn
    /// first, into `front`; 0 where all are drawn in one go.
    MeshTileWorker(const MeshJob& job,
                   const std::vector<MeshRun>& runs,
                   std::size_t fronts,
                   FrontDepth& front);

    /// Draws the lists of the nearest clusters and puts the tile aside. Leaves it to draw() if
    /// there are none, or only triangles of the scalar path, of which the tile might be a flat one.
    void draw_front(int tile);

    /// Draws the tile's lists in the order of the runs, or finds that it need not, and hands it
    /// over.
    void draw(int tile, TileSink& sink);

    [[nodiscard]] const SkipCounts& skips() const { return skips_; }

  private:
    void finish(TileSink& sink);
    [[nodiscard]] bool list_scalar(int tile);
    [[nodiscard]] bool is_flat() const;
    void draw_list(const MeshRun& run, std::span<const std::uint32_t> list);
    void prefetch(const LaneSource& source, std::uint32_t entry) const;
    void look_again(const LaneSource& source, bool is_late);
    [[nodiscard]] bool is_hidden(const PixelRect& bounds, float q_most) const {
        return tests_hidden_ && coarse_.hides(bounds, q_most);
    }
    void add_lanes(const LaneSource& source, std::span<const std::uint32_t> entries);
    void draw_lanes(const LaneSource& source);
    void draw_fragments(const LaneSource& source, const LaneSlot& slot);
    std::size_t draw_stretch(const LaneSource& source, std::span<const std::uint32_t> list);
    void draw_scalar(const std::vector<Batch>& batches, std::uint32_t index);

    const MeshJob& job_;
    const std::vector<MeshRun>& runs_;
    std::size_t fronts_;
    FrontDepth& front_;
    bool is_late_ = false;  ///< all of the tile that faces the eye is drawn
    PassInput near_far_;
    TileBuffer buffer_;
    LaneTriangles triangles_;
    std::array<std::uint32_t, LaneTriangles::kCount> lane_entries_{};
    std::size_t lane_count_ = 0;
    FlatProof proof_;
    bool tests_hidden_;
    CoarseDepth coarse_;
    SkipCounts skips_{};
};

}  // namespace ink::raster
