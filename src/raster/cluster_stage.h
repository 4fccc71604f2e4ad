#pragma once

#include <cstdint>

#include "raster/corner_values.h"
#include "raster/lane_mesh.h"
#include "raster/pass.h"
#include "raster/setup.h"
#include "raster/view_transform.h"

namespace ink::raster {

/// In clusters at most this wide and high a vertex fits 16 bits each way from their box's corner.
inline constexpr int kPackedCluster_px = 255;

/// A cluster's vertices on the screen, and what a method made of them; scratch of one thread.
struct ClusterLanes {
    static constexpr std::size_t kCount = scene::kMaxClusterVertices;
    alignas(64) double w[kCount];
    alignas(64) double inv_w[kCount];
    alignas(64) float q[kCount];
    alignas(64) std::int32_t x[kCount];  ///< 1/65536 px
    alignas(64) std::int32_t y[kCount];
    alignas(64) float values[2][kMaxPlanes][kCount];  ///< front, back
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
    [[nodiscard]] CornerPlanes planes(bool wants_back);
};

/// Puts a cluster's vertices on the screen. False if it must be drawn triangle by triangle: it
/// crosses the near plane, lies far outside the picture, or its 1/w are beyond what floats can
/// multiply; the lanes then hold nothing of use.
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

/// Writes `count` vertices as records (see lane_triangles.h), a vector's worth more than they are.
/// `values` null: none. What is silent lies at infinity, behind everything.
void write_records(const ClusterLanes& lanes,
                   std::size_t count,
                   const float* values,
                   bool is_silent,
                   std::int32_t* records);

}  // namespace ink::raster
