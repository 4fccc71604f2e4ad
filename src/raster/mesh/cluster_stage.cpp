#include "raster/mesh/cluster_stage.h"

#include <algorithm>
#include <limits>

#include "raster/pass/screen_vertex.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/mesh/cluster_stage.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/pass/view_lanes.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DD = hn::CappedTag<double, 8>;
using DI = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<DI>;

/// What may not be exceeded for lanes, over all vertices.
struct Reach {
    double least_w;
    double most_w;
    double farthest_px;
};

template <class Load>
Reach Project(std::size_t count, const ViewTransform& t, ClusterLanes& lanes, const Load& load) {
    const DD d;
    const hn::Rebind<float, DD> df;
    const hn::Rebind<std::int32_t, DD> di;
    const LaneRecords& r = lanes.records;
    const std::size_t n = hn::Lanes(d);
    auto least_w = hn::Set(d, std::numeric_limits<double>::max());
    auto most_w = hn::Zero(d);
    auto farthest = hn::Zero(d);
    const auto limit = hn::Set(d, kLaneReach_px);
    const auto scale = hn::Set(d, 1 << kLaneBits);
    for (std::size_t i = 0; i < count; i += n) {
        const auto clip = clip_lanes(d, t, load(0, i), load(1, i), load(2, i));
        const auto w = clip.w;
        const auto inv = hn::Div(hn::Set(d, 1), w);
        const auto x_px = hn::Mul(clip.x, inv);
        const auto y_px = hn::Mul(clip.y, inv);
        least_w = hn::Min(least_w, w);
        most_w = hn::Max(most_w, w);
        farthest = hn::Max(farthest, hn::Max(hn::Abs(x_px), hn::Abs(y_px)));
        const auto x_safe = hn::Min(hn::Max(x_px, hn::Neg(limit)), limit);
        const auto y_safe = hn::Min(hn::Max(y_px, hn::Neg(limit)), limit);
        hn::Store(w, d, lanes.w + i);
        hn::Store(inv, d, lanes.inv_w + i);
        hn::Store(hn::DemoteTo(df, inv), df, r.q() + i);
        hn::Store(hn::DemoteTo(di, hn::Round(hn::Mul(x_safe, scale))), di, r.x() + i);
        hn::Store(hn::DemoteTo(di, hn::Round(hn::Mul(y_safe, scale))), di, r.y() + i);
    }
    return {hn::GetLane(hn::MinOfLanes(d, least_w)),
            hn::GetLane(hn::MaxOfLanes(d, most_w)),
            hn::GetLane(hn::MaxOfLanes(d, farthest))};
}

/// The box of the snapped vertices, and each packed from its corner.
void PackSnapped(std::size_t count, ClusterLanes& lanes) {
    const DI d;
    const std::size_t n = hn::Lanes(d);
    const auto half = hn::Set(d, 1 << (kLaneBits - kSubpixelBits - 1));
    const auto snap = [&](const std::int32_t* from) {
        return hn::ShiftRight<kLaneBits - kSubpixelBits>(hn::Add(hn::Load(d, from), half));
    };
    auto x0 = hn::Set(d, std::numeric_limits<std::int32_t>::max());
    auto y0 = x0;
    auto x1 = hn::Set(d, std::numeric_limits<std::int32_t>::min());
    auto y1 = x1;
    for (std::size_t i = 0; i < count; i += n) {
        const auto x = snap(lanes.records.x() + i);
        const auto y = snap(lanes.records.y() + i);
        x0 = hn::Min(x0, x);
        x1 = hn::Max(x1, x);
        y0 = hn::Min(y0, y);
        y1 = hn::Max(y1, y);
    }
    lanes.x0 = hn::GetLane(hn::MinOfLanes(d, x0));
    lanes.y0 = hn::GetLane(hn::MinOfLanes(d, y0));
    lanes.x1 = hn::GetLane(hn::MaxOfLanes(d, x1));
    lanes.y1 = hn::GetLane(hn::MaxOfLanes(d, y1));
    constexpr std::int32_t kExtent = kPackedCluster_px * kSubpixels;
    lanes.is_packed = lanes.x1 - lanes.x0 <= kExtent && lanes.y1 - lanes.y0 <= kExtent;
    const auto left = hn::Set(d, lanes.x0);
    const auto top = hn::Set(d, lanes.y0);
    for (std::size_t i = 0; i < count; i += n) {
        const auto x = hn::Sub(snap(lanes.records.x() + i), left);
        const auto y = hn::Sub(snap(lanes.records.y() + i), top);
        if (lanes.is_packed) {
            hn::Store(hn::Or(hn::ShiftLeft<16>(x), y), d, lanes.packed + i);
        } else {
            hn::Store(x, d, lanes.x_snapped + i);
            hn::Store(y, d, lanes.y_snapped + i);
        }
    }
}

bool ProjectCluster(const LaneMesh& mesh,
                    std::size_t cluster,
                    const ViewTransform& transform,
                    double near,
                    ClusterLanes& lanes) {
    const DD d;
    const hn::Rebind<float, DD> df;
    const std::size_t vertices = mesh.clusters().clusters[cluster].vertex_count;
    const std::size_t count = lane_padded(vertices);
    Reach reach{};
    if (mesh.has_float_positions()) {
        const float* p[3] = {mesh.float_positions(cluster, 0),
                             mesh.float_positions(cluster, 1),
                             mesh.float_positions(cluster, 2)};
        reach = Project(count, transform, lanes, [&](int axis, std::size_t i) {
            return hn::PromoteTo(d, hn::LoadU(df, p[axis] + i));
        });
    } else {
        const double* p[3] = {mesh.double_positions(cluster, 0),
                              mesh.double_positions(cluster, 1),
                              mesh.double_positions(cluster, 2)};
        reach = Project(count, transform, lanes, [&](int axis, std::size_t i) {
            return hn::LoadU(d, p[axis] + i);
        });
    }
    // Far from 1, products of 1/w and reciprocals of areas would leave the range of floats.
    constexpr double kExtreme = 1e18;
    if (!(reach.least_w >= near) || !(reach.least_w > 1 / kExtreme)) return false;
    if (!(reach.farthest_px <= kLaneReach_px)) return false;
    lanes.q_least = static_cast<float>(1 / reach.most_w);
    lanes.q_most = static_cast<float>(1 / reach.least_w);  // as the nearest vertex's q was rounded
    PackSnapped(count, lanes);
    return lanes.records.q()[0] > 1 / kExtreme;  // neighbours differ by far less than what is left
}

ValueRange RangeOf(const float* values, std::size_t count) {
    const hn::Rebind<float, DI> d;
    const auto first = hn::Set(d, values[0]);
    auto least = first;
    auto greatest = first;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto v = hn::IfThenElse(hn::FirstN(d, count - i), hn::LoadU(d, values + i), first);
        least = hn::Min(least, v);
        greatest = hn::Max(greatest, v);
    }
    return {hn::GetLane(hn::MinOfLanes(d, least)), hn::GetLane(hn::MaxOfLanes(d, greatest))};
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(ProjectCluster);
HWY_EXPORT(RangeOf);

ValueRange range_of(const float* values, std::size_t count) {
    return HWY_DYNAMIC_DISPATCH(RangeOf)(values, count);
}

CornerBatch ClusterLanes::batch(const LaneMesh& mesh, std::size_t cluster) const {
    CornerBatch result;
    result.count = mesh.clusters().clusters[cluster].vertex_count;
    result.w = w;
    result.inv_w = inv_w;
    for (int axis = 0; axis < 3 && mesh.has_normals(); ++axis)
        result.n_world[axis] = mesh.normals(cluster, axis);
    return result;
}

bool project_cluster(const LaneMesh& mesh,
                     std::size_t cluster,
                     const ViewTransform& transform,
                     double near,
                     ClusterLanes& lanes) {
    return HWY_DYNAMIC_DISPATCH(ProjectCluster)(mesh, cluster, transform, near, lanes);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
