#pragma once

#include <cstdint>

#include "raster/corner_values.h"
#include "raster/lane_mesh.h"
#include "raster/pass.h"
#include "raster/setup.h"
#include "raster/view_transform.h"

namespace ink::raster {

/// Triangles at most this wide and high go through lanes: every product of two extents in 1/256 px,
/// and their difference, then fits 32 bits.
inline constexpr int kLaneExtent_px = 90;

/// And so do the clusters they lie in: a vertex fits 16 bits each way from their box's corner.
inline constexpr int kLaneCluster_px = 255;

/// A cluster's vertices on the screen, and what a method made of them; scratch of one thread.
struct ClusterLanes {
    static constexpr std::size_t kCount = scene::kMaxClusterVertices;
    alignas(64) double w[kCount];
    alignas(64) double inv_w[kCount];
    alignas(64) float q[kCount];
    alignas(64) std::int32_t x[kCount];  ///< 1/65536 px
    alignas(64) std::int32_t y[kCount];
    alignas(64) float values[2][kMaxPlanes][kCount];  ///< front, back
    alignas(64) std::int32_t packed[kCount];  ///< snapped, from the box's corner: x << 16 | y
    float q_least = 0;
    float q_most = 0;
    std::int32_t x0 = 0;  ///< snapped box, 1/256 px
    std::int32_t y0 = 0;
    std::int32_t x1 = 0;
    std::int32_t y1 = 0;

    /// How a method reads them.
    [[nodiscard]] CornerBatch batch(const LaneMesh& mesh, std::size_t cluster) const;
    [[nodiscard]] CornerPlanes planes(bool wants_back);
};

/// Puts a cluster's vertices on the screen. False if it must be drawn triangle by triangle: it
/// crosses the near plane, lies far outside the picture, is too large for lanes, or its 1/w are
/// beyond what floats can multiply; the lanes then hold nothing of use.
[[nodiscard]] bool project_cluster(const LaneMesh& mesh,
                                   std::size_t cluster,
                                   const ViewTransform& transform,
                                   double near,
                                   ClusterLanes& lanes);

/// What is asked of a cluster's triangles.
struct TriageJob {
    PixelRect picture;
    int halo_px = 0;
    int columns = 1;  ///< of tiles
    int rows = 1;
    bool drops_backs = false;      ///< triangles seen from their back are of no use
    bool drops_no_sample = false;  ///< so are those that cover no pixel centre
};

/// The triangles that are left, in order.
struct TriageResult {
    /// Up to a whole vector more is written.
    static constexpr std::size_t kCapacity = 128 + kLanePad;
    alignas(64) std::uint32_t triangle[kCapacity];  ///< within the cluster
    alignas(64) std::int32_t x0[kCapacity];         ///< pixel centres that may be inside
    alignas(64) std::int32_t y0[kCapacity];
    alignas(64) std::int32_t x1[kCapacity];
    alignas(64) std::int32_t y1[kCapacity];
    /// The one tile that all its centres and their halos lie in, or -1: several.
    alignas(64) std::int32_t tile[kCapacity];
    /// Twice the snapped area where its sign is sure to be that of the true one, else 0.
    alignas(64) std::int32_t area[kCapacity];
    std::size_t count = 0;
    bool has_large = false;     ///< some triangle exceeds kLaneExtent_px: nothing here is of use
    std::size_t no_sample = 0;  ///< dropped or not, triangles found to cover no centre
    std::size_t outside = 0;    ///< without a centre in the picture
};

/// Sorts out the triangles of a projected cluster: those outside the picture, without area, or
/// (where the job says so) turned away or without a sample are dropped. A triangle seen so nearly
/// edge-on that its facing is not sure is never dropped for it.
void triage_cluster(const LaneMesh& mesh,
                    std::size_t cluster,
                    const ClusterLanes& lanes,
                    const TriageJob& job,
                    TriageResult& result);

/// The least and the greatest of `count` values; memory is read up to kLanePad.
struct ValueRange {
    float least;
    float greatest;
};
[[nodiscard]] ValueRange range_of(const float* values, std::size_t count);

/// Writes `count` vertices as records (see lane_triangles.h), a vector's worth more than they are.
/// `values` null: none. What is silent lies at infinity, behind everything.
void write_records(const ClusterLanes& lanes,
                   std::size_t count,
                   const float* values,
                   bool is_silent,
                   std::int32_t* records);

}  // namespace ink::raster
