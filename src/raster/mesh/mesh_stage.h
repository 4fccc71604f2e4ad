#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/fragments/cluster_fragments.h"
#include "raster/mesh/cluster_stage.h"
#include "raster/mesh/cull_and_bin.h"
#include "raster/mesh/front_depth.h"
#include "raster/mesh/lane_triangles.h"
#include "raster/mesh/mesh_pass.h"
#include "raster/mesh/mesh_view.h"
#include "raster/pass/bin.h"
#include "raster/pass/clip.h"
#include "raster/pass/tile_lists.h"
#include "raster/pass/triangle_stage.h"
#include "raster/pass/view_transform.h"

namespace ink::raster {

/// What all runs of clusters share in one frame; borrowed.
struct MeshJob {
    const PassFormat& format;
    const MeshInput& input;
    const TileGrid& grid;
    ViewTransform transform;
    std::vector<SolidView> solids;
    ClusterOrder order;  ///< roughly from front to back
    bool uses_lanes = false;
    LaneDepthBias depth_bias;

    [[nodiscard]] PixelRect image() const { return {0, 0, grid.width_px, grid.height_px}; }
    /// The bit of its object in MeshRun::objects.
    [[nodiscard]] std::uint64_t object_bit(const scene::Cluster& cluster) const {
        return std::uint64_t{1} << (input.mesh->clusters().solids[cluster.solid].object % 64);
    }
    /// Whether no triangle of the cluster that is seen from its back shows.
    [[nodiscard]] bool hides_backs(std::size_t cluster) const {
        return order.hides_backs[cluster] != 0;
    }
    /// Whether triangles seen from their back are to be left out, for whichever reason.
    [[nodiscard]] bool drops_backs(bool hides_backs) const {
        return input.cull == Cull::back ||
               (hides_backs && input.skips.has(Skip::back_face_culling));
    }
};

/// Into how many runs a frame divides so many clusters: one on one thread, more on more, so that a
/// slow one does not hold up all.
[[nodiscard]] std::size_t run_count(std::size_t clusters, int threads);

/// A run of clusters and what becomes of it: vertices that lanes draw, fragments, triangles set up
/// by themselves, and per tile a list of them in the order of the clusters. Kept between frames, so
/// that no frame allocates what an earlier one had.
class MeshRun {
  public:
    /// Does clusters [first, last) of the order. Those that `front` hides are passed over; null:
    /// none is.
    void process(const MeshJob& job,
                 std::size_t first,
                 std::size_t last,
                 const FrontDepth* front = nullptr);

    [[nodiscard]] std::span<const std::uint32_t> of(int tile) const {
        const EntryList& list = lists_[static_cast<std::size_t>(tile)];
        return {list.data(), list.size()};
    }
    [[nodiscard]] LaneSource source() const { return {slots_.data(), records_.data()}; }
    /// The triangles set up by themselves: one batch.
    [[nodiscard]] const std::vector<Batch>* scalar_batches() const { return &scalar_batches_; }
    [[nodiscard]] const SkipCounts& skips() const { return skips_; }
    /// Objects that touch a tile, one bit each (object modulo 64).
    [[nodiscard]] std::uint64_t objects(int tile) const {
        return objects_[static_cast<std::size_t>(tile)];
    }

  private:
    [[nodiscard]] Batch& scalar() { return scalar_batches_.front(); }
    void start(const MeshJob& job);
    [[nodiscard]] bool may_show(const MeshJob& job, std::size_t cluster, const FrontDepth* front);
    void add_cluster(const MeshJob& job, std::size_t cluster);
    /// Asks for a part of the next cluster: all at once, it would be waited for.
    HWY_INLINE void prefetch_ahead(const MeshJob& job, std::size_t part) const {
        if (ahead_ != kNone) job.input.mesh->prefetch(ahead_, part);
    }
    [[nodiscard]] bool add_in_lanes(const MeshJob& job, std::size_t cluster, bool hides_backs);
    void add_scalar(const MeshJob& job, std::size_t cluster, bool hides_backs);
    void settle_sides(const MeshJob& job, std::size_t cluster, const CullJob& cull);
    [[nodiscard]] bool compute_values(const MeshJob& job,
                                      std::size_t cluster,
                                      const LaneSlot& slot);
    [[nodiscard]] float biased(const MeshJob& job, float q_most) const;
    std::size_t keep_corners(const MeshJob& job, std::size_t cluster, std::size_t byte);
    void list_constants(const MeshJob& job, std::size_t index, std::uint32_t* constants) const;
    [[nodiscard]] bool makes_fragments(const MeshJob& job, const LaneSlot& slot) const;
    void add_fragments(const MeshJob& job, std::size_t index, LaneSlot slot);
    void mark(std::size_t tile, std::uint64_t object) {
        if (!objects_.empty()) objects_[tile] |= object;
    }
    void compute_scalar_values(const MeshJob& job);
    void bias_scalar(const MeshJob& job, std::size_t from);
    void silence_backs(const PassInput& input, std::size_t from);
    void bin_lanes(const MeshJob& job, std::size_t slot, std::uint64_t object);
    void bin_scalar(const MeshJob& job, std::size_t from, std::uint64_t object);

    static constexpr std::size_t kNone = ~std::size_t{0};

    ImageSides sides_;
    std::vector<std::uint32_t> shown_;  ///< clusters that are not passed over
    std::size_t ahead_ = kNone;         ///< the cluster after the one that is done now
    ClusterLanes lanes_;
    CullResult culled_;
    ClusterFragments fragments_;
    std::vector<LaneSlot> slots_;
    AlignedArray<std::byte> records_;  ///< per slot
    std::vector<Batch> scalar_batches_ = std::vector<Batch>(1);
    std::vector<EntryList> lists_;
    std::vector<std::uint64_t> objects_;
    SkipCounts skips_{};
    CutVertices cut_vertices_;
    CutTriangles cut_triangles_;
    std::vector<scene::Triangle> corners_;
    std::vector<std::int8_t> facing_;
    std::vector<std::uint32_t> triangle_ids_;  ///< of corners_, in the surface
    std::vector<std::uint32_t> constants_;     ///< of what is set up
    std::vector<double> scalar_w_;             ///< w, then 1/w
    std::vector<float> scalar_n_;              ///< x, y, z
    std::vector<float> scalar_planes_;         ///< front planes, then back ones
    std::vector<float> values_[2];             ///< front, back; vertex by vertex
};

}  // namespace ink::raster
