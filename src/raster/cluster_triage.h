#pragma once

#include <cstdint>

#include "raster/cluster_stage.h"
#include "raster/lane_mesh.h"
#include "raster/pass.h"
#include "raster/setup.h"

namespace ink::raster {

/// Triangles at most this wide and high go through lanes: every product of two extents in 1/256 px,
/// and their difference, then fits 32 bits.
inline constexpr int kLaneExtent_px = 127;

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

}  // namespace ink::raster
