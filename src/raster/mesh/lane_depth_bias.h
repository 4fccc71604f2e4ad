#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/depth/polygon_offset.h"

namespace ink::raster {

struct LaneRecords;

/// Polygon offset as lanes do it: in steps of z24 or z16, which are what they interpolate there, or
/// in q.
struct LaneDepthBias {
    LaneDepthBias() = default;
    LaneDepthBias(const PolygonOffset& offset, const QuantisedDepth& depth, DepthFormat format);

    bool is_any = false;
    bool is_in_floats = true;  ///< a unit is a step of floats at the nearest corner, else 1
    float factor = 0;
    float units = 0;
    float first = 0;  ///< where moved corners are limited to: the ends of the format
    float last = 0;

    /// Whether it can move anything nearer than it is.
    [[nodiscard]] bool can_bias_nearer() const { return factor < 0 || units < 0; }
};

/// The largest depth bias among `count` triangles, exactly as set-up adds it; at least 0. `corners`
/// are as a LaneSlot has them, of vertices that have one depth for both sides, aligned for vectors,
/// and whole vectors of them can be read.
[[nodiscard]] float most_depth_bias(const LaneDepthBias& depth_bias,
                                    const LaneRecords& records,
                                    const std::uint32_t* corners,
                                    std::size_t count);

}  // namespace ink::raster
