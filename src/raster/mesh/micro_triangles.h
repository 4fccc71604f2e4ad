#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/mesh/lane_triangles.h"

namespace ink::raster {

/// Finds the micro-triangles among triangles that are set up: all four pixels of a vector of small
/// triangles at once. Where fewer than half of a vector are small, or depth is not q32, it leaves
/// them to the rows of fill_lanes.
void find_micro_triangles(const PassFormat& format, LaneTriangles& triangles);

/// Draws micro-triangles in their turn; what fill_lanes asks before each triangle.
class MicroTriangleRun {
  public:
    /// Both are borrowed.
    MicroTriangleRun(const PassFormat& format, const LaneTriangles& triangles, TileBuffer& to);

    /// Whether triangle i is drawn as a micro-triangle. Else all before it is drawn now.
    [[nodiscard]] bool takes(std::size_t i) {
        const std::int32_t count = micro_triangles_.counts[i];
        if (count < 0) {
            if (due_ > drawn_) finish();
            return false;
        }
        due_ += static_cast<std::size_t>(count);
        return true;
    }
    /// Draws what is left.
    void finish();

  private:
    template <class T, std::size_t kPlanes>
    void draw();

    const LaneTriangles::MicroTriangles& micro_triangles_;
    float* depth_;
    std::array<void*, kMaxPlanes> planes_{};
    int plane_count_;
    Store narrow_ = Store::u32;  ///< u8 or u16 where the plane is that narrow
    std::size_t drawn_ = 0;
    std::size_t due_ = 0;
};

}  // namespace ink::raster
