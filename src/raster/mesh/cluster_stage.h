#pragma once

#include <cstdint>

#include "raster/mesh/lane_mesh.h"
#include "raster/mesh/lane_triangles.h"
#include "raster/pass/corner_values.h"
#include "raster/pass/view_transform.h"

namespace ink::raster {

/// In clusters at most this wide and high a vertex fits 16 bits each way from their box's corner.
inline constexpr int kPackedCluster_px = 255;

/// A cluster's vertices on the screen; scratch of one thread, but for what is kept as records.
struct ClusterLanes {
    static constexpr std::size_t kCount = scene::kMaxClusterVertices;
    LaneRecords records;  ///< where they are written
    alignas(64) double w[kCount];
    alignas(64) double inv_w[kCount];
    /// Snapped, from the box's corner, 1/256 px: x << 16 | y, or apart where they do not fit.
    bool is_packed = false;
    alignas(64) std::int32_t packed[kCount];
    alignas(64) std::int32_t x_snapped[kCount];
    alignas(64) std::int32_t y_snapped[kCount];
    float q_least = 0;
    float q_most = 0;
    std::int32_t x0 = 0;  ///< snapped box, 1/256 px
    std::int32_t y0 = 0;
    std::int32_t x1 = 0;
    std::int32_t y1 = 0;

    /// How a method reads them.
    [[nodiscard]] CornerBatch batch(const LaneMesh& mesh, std::size_t cluster) const;
};

/// Puts a cluster's vertices on the screen: x, y and q of its records. False if it must be drawn
/// triangle by triangle: it crosses the near plane, lies far outside the image, or its 1/w are
/// beyond what floats can multiply; the lanes then hold nothing of use.
[[nodiscard]] bool project_cluster(const LaneMesh& mesh,
                                   std::size_t cluster,
                                   const ViewTransform& transform,
                                   double near,
                                   ClusterLanes& lanes);

/// The least and the greatest of `count` values; memory is read up to kLanePad.
struct ValueRange {
    float least;
    float greatest;
};
[[nodiscard]] ValueRange range_of(const float* values, std::size_t count);

}  // namespace ink::raster
