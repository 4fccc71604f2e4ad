#include "raster/mesh/lane_depth_bias.h"

#include <limits>

#include "raster/mesh/lane_triangles.h"
#include "raster/pass/screen_vertex.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/mesh/lane_depth_bias.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DI = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<DI>;
using DF = hn::Rebind<float, DI>;
using VF = hn::Vec<DF>;

#include "raster/mesh/lane_planes.inl"
#include "raster/mesh/lane_tables.inl"

float MostDepthBias(const LaneDepthBias& depth_bias,
                    const LaneRecords& records,
                    const std::uint32_t* corners,
                    std::size_t count) {
    const DI d;
    const DF df;
    const VertexTable x(records.x());
    const VertexTable y(records.y());
    const VertexTable q(reinterpret_cast<const std::int32_t*>(records.q()));
    auto most = hn::Zero(df);
    for (std::size_t at = 0; at < count; at += hn::Lanes(d)) {
        const auto three = hn::Load(d, reinterpret_cast<const std::int32_t*>(corners) + at);
        VI cx[3], cy[3];
        VF cq[3];
        for (int k = 0; k < 3; ++k) {
            const auto corner = CornerOf(three, k);
            cx[k] = x.At(corner);
            cy[k] = y.At(corner);
            cq[k] = hn::BitCast(df, q.At(corner));
        }
        const PlaneLanes planes = MakePlanes(cx, cy);
        const auto nearest = hn::Max(hn::Max(cq[0], cq[1]), cq[2]);
        const auto moved = DepthBiasOf(depth_bias, planes.Gradient(cq[0], cq[1], cq[2]), nearest);
        const auto is_real = hn::RebindMask(df, hn::FirstN(d, count - at));
        most = hn::Max(most, hn::IfThenElseZero(is_real, moved));
    }
    return hn::GetLane(hn::MaxOfLanes(df, most));
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(MostDepthBias);

LaneDepthBias::LaneDepthBias(const PolygonOffset& offset,
                             const QuantisedDepth& depth,
                             DepthFormat format)
    : is_any(offset.is_any()),
      is_in_floats(format == DepthFormat::q32),
      factor(static_cast<float>(offset.factor)),
      units(static_cast<float>(offset.units)),
      first(is_in_floats ? std::numeric_limits<float>::lowest() : 1),
      last(is_in_floats ? std::numeric_limits<float>::max() : static_cast<float>(depth.steps())) {}

float most_depth_bias(const LaneDepthBias& depth_bias,
                      const LaneRecords& records,
                      const std::uint32_t* corners,
                      std::size_t count) {
    return HWY_DYNAMIC_DISPATCH(MostDepthBias)(depth_bias, records, corners, count);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
