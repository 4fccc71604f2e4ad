#include "raster/cluster_triage.h"

#include "raster/screen_vertex.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/cluster_triage.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DI = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<DI>;
using DU = hn::RebindToUnsigned<DI>;

#include "raster/lane_edges.inl"

/// Corners of a vector of triangles, from the box's corner, 1/256 px.
struct Corners {
    VI x[3];
    VI y[3];
};

HWY_INLINE Corners Gather(const std::uint8_t* const (&index)[3],
                          const ClusterLanes& lanes,
                          std::size_t at) {
    const DI d;
    const hn::Rebind<std::uint8_t, DI> d8;
    Corners c;
    for (int k = 0; k < 3; ++k) {
        const auto vertex = hn::PromoteTo(d, hn::LoadU(d8, index[k] + at));
        if (lanes.is_packed) {  // half the gathers
            const auto v = hn::GatherIndex(d, lanes.packed, vertex);
            c.x[k] = hn::BitCast(d, hn::ShiftRight<16>(hn::BitCast(DU(), v)));
            c.y[k] = hn::And(v, hn::Set(d, 0xffff));
        } else {
            c.x[k] = hn::GatherIndex(d, lanes.x_snapped, vertex);
            c.y[k] = hn::GatherIndex(d, lanes.y_snapped, vertex);
        }
    }
    return c;
}

/// Twice the area; positive where the corners run clockwise as seen, y running down.
HWY_INLINE VI Area(const Corners& c) {
    return hn::Sub(hn::Mul(hn::Sub(c.x[1], c.x[0]), hn::Sub(c.y[2], c.y[0])),
                   hn::Mul(hn::Sub(c.x[2], c.x[0]), hn::Sub(c.y[1], c.y[0])));
}

/// By how much rounding the corners may have moved twice the area, and a bit.
HWY_INLINE VI AreaDoubt(const Corners& c) {
    const DI d;
    const auto sum =
        hn::Add(hn::Add(hn::Abs(hn::Sub(c.x[1], c.x[0])), hn::Abs(hn::Sub(c.y[1], c.y[0]))),
                hn::Add(hn::Abs(hn::Sub(c.x[2], c.x[0])), hn::Abs(hn::Sub(c.y[2], c.y[0]))));
    // Each difference is off by at most 1 and 1/256 of these units.
    return hn::Add(hn::Add(sum, hn::ShiftRight<6>(sum)), hn::Set(d, 4));
}

/// Whether a centre lies inside: corners and centre from one origin, `turned` -1 where the corners
/// run counter-clockwise.
HWY_INLINE hn::Mask<DI> IsInside(const Corners& c, VI turned, VI x, VI y) {
    const DI d;
    auto outside = hn::Zero(d);
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        const auto dx = Turn(hn::Sub(c.x[next], c.x[k]), turned);
        const auto dy = Turn(hn::Sub(c.y[next], c.y[k]), turned);
        outside = hn::Or(outside, EdgeAt(dx, dy, hn::Sub(x, c.x[k]), hn::Sub(y, c.y[k])));
    }
    return hn::Gt(outside, hn::Set(d, -1));
}

/// The tile that a box and its halo lie in, or -1.
HWY_INLINE VI OneTile(const TriageJob& job, VI x0, VI y0, VI x1, VI y1) {
    static_assert(kTileSize_px == 64);
    constexpr int kShift = 6;
    const DI d;
    const auto zero = hn::Zero(d);
    const auto halo = hn::Set(d, job.halo_px);
    const auto past = hn::Set(d, job.halo_px - 1);
    const auto low = [&](VI v) { return hn::ShiftRight<kShift>(hn::Max(hn::Sub(v, halo), zero)); };
    const auto high = [&](VI v, int count) {
        return hn::Min(hn::ShiftRight<kShift>(hn::Add(v, past)), hn::Set(d, count - 1));
    };
    const auto column = low(x0);
    const auto row = low(y0);
    const auto is_one =
        hn::And(hn::Eq(column, high(x1, job.columns)), hn::Eq(row, high(y1, job.rows)));
    const auto tile = hn::Add(hn::Mul(row, hn::Set(d, job.columns)), column);
    return hn::IfThenElse(is_one, tile, hn::Set(d, -1));
}

HWY_INLINE void Append(VI v, hn::Mask<DI> mask, std::int32_t* to) {
    hn::StoreU(hn::Compress(v, mask), DI(), to);
}

void TriageCluster(const LaneMesh& mesh,
                   std::size_t cluster,
                   const ClusterLanes& lanes,
                   const TriageJob& job,
                   TriageResult& result) {
    const DI d;
    const std::size_t n = hn::Lanes(d);
    const std::size_t count = mesh.clusters().clusters[cluster].triangle_count;
    const std::uint8_t* const index[3] = {
        mesh.corners(cluster, 0), mesh.corners(cluster, 1), mesh.corners(cluster, 2)};
    const auto left = hn::Set(d, lanes.x0);
    const auto top = hn::Set(d, lanes.y0);
    const auto to_centre = hn::Set(d, kSubpixels / 2 - 1);
    const auto zero = hn::Zero(d);
    auto largest = zero;
    result.count = 0;
    result.no_sample = 0;
    result.outside = 0;
    auto* triangle = reinterpret_cast<std::int32_t*>(result.triangle);
    for (std::size_t at = 0; at < count; at += n) {
        const Corners c = Gather(index, lanes, at);
        const auto area = Area(c);
        const auto first = [&](VI low, VI origin) {
            return hn::ShiftRight<kSubpixelBits>(hn::Add(hn::Add(low, origin), to_centre));
        };
        const auto least_x = hn::Min(hn::Min(c.x[0], c.x[1]), c.x[2]);
        const auto least_y = hn::Min(hn::Min(c.y[0], c.y[1]), c.y[2]);
        const auto most_x = hn::Max(hn::Max(c.x[0], c.x[1]), c.x[2]);
        const auto most_y = hn::Max(hn::Max(c.y[0], c.y[1]), c.y[2]);
        largest = hn::Max(largest, hn::Max(hn::Sub(most_x, least_x), hn::Sub(most_y, least_y)));
        const auto left_px = first(least_x, left);
        const auto top_px = first(least_y, top);
        const auto right_px = first(most_x, left);
        const auto bottom_px = first(most_y, top);
        const auto x0 = hn::Max(left_px, hn::Set(d, job.picture.x0));
        const auto y0 = hn::Max(top_px, hn::Set(d, job.picture.y0));
        const auto x1 = hn::Min(right_px, hn::Set(d, job.picture.x1));
        const auto y1 = hn::Min(bottom_px, hn::Set(d, job.picture.y1));

        const auto is_real = hn::FirstN(d, count - at);
        const auto has_box = hn::And(hn::Lt(left_px, right_px), hn::Lt(top_px, bottom_px));
        const auto has_area = hn::And(hn::Ne(area, zero), has_box);
        const auto in_picture = hn::And(hn::Lt(x0, x1), hn::Lt(y0, y1));
        auto keep = hn::And(is_real, hn::And(has_area, in_picture));
        result.no_sample += hn::CountTrue(d, hn::AndNot(has_area, is_real));
        result.outside += hn::CountTrue(d, hn::And(is_real, hn::AndNot(in_picture, has_area)));

        const auto is_sure = hn::Gt(hn::Abs(area), AreaDoubt(c));
        // Counter-clockwise in the world is counter-clockwise as seen: negative with y down.
        if (job.drops_backs) keep = hn::AndNot(hn::And(is_sure, hn::Gt(area, zero)), keep);

        const auto width = hn::Sub(right_px, left_px);
        const auto height = hn::Sub(bottom_px, top_px);
        const auto three = hn::Set(d, 3);
        const auto is_tiny = hn::And(keep, hn::And(hn::Lt(width, three), hn::Lt(height, three)));
        if (!hn::AllFalse(d, is_tiny)) {
            const auto turned = hn::VecFromMask(d, hn::Lt(area, zero));
            const auto x = hn::Sub(
                hn::Add(hn::ShiftLeft<kSubpixelBits>(left_px), hn::Set(d, kSubpixels / 2)), left);
            const auto y = hn::Sub(
                hn::Add(hn::ShiftLeft<kSubpixelBits>(top_px), hn::Set(d, kSubpixels / 2)), top);
            const auto step = hn::Set(d, kSubpixels);
            const auto is_hit =
                hn::Or(hn::Or(IsInside(c, turned, x, y), IsInside(c, turned, hn::Add(x, step), y)),
                       hn::Or(IsInside(c, turned, x, hn::Add(y, step)),
                              IsInside(c, turned, hn::Add(x, step), hn::Add(y, step))));
            const auto is_missed = hn::AndNot(is_hit, is_tiny);
            result.no_sample += hn::CountTrue(d, is_missed);
            if (job.drops_no_sample) keep = hn::AndNot(is_missed, keep);
        }
        const std::size_t kept = hn::CountTrue(d, keep);
        if (kept == 0) continue;
        Append(hn::Iota(d, static_cast<std::int32_t>(at)), keep, triangle + result.count);
        Append(x0, keep, result.x0 + result.count);
        Append(y0, keep, result.y0 + result.count);
        Append(x1, keep, result.x1 + result.count);
        Append(y1, keep, result.y1 + result.count);
        Append(hn::IfThenElseZero(is_sure, area), keep, result.area + result.count);
        Append(OneTile(job, x0, y0, x1, y1), keep, result.tile + result.count);
        result.count += kept;
    }
    const std::int32_t extent = hn::GetLane(hn::MaxOfLanes(d, largest));
    result.has_large = extent > kLaneExtent_px * kSubpixels;
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(TriageCluster);

void triage_cluster(const LaneMesh& mesh,
                    std::size_t cluster,
                    const ClusterLanes& lanes,
                    const TriageJob& job,
                    TriageResult& result) {
    HWY_DYNAMIC_DISPATCH(TriageCluster)(mesh, cluster, lanes, job, result);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
