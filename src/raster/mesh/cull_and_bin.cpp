#include "raster/mesh/cull_and_bin.h"

#include "raster/pass/screen_vertex.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/mesh/cull_and_bin.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DI = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<DI>;
using DU = hn::RebindToUnsigned<DI>;

#include "raster/mesh/lane_edges.inl"
#include "raster/mesh/lane_tables.inl"

/// Corners of a vector of triangles, from the box's corner, 1/256 px.
struct Corners {
    VI x[3];
    VI y[3];
};

/// Of a cluster that fits 16 bits each way.
class PackedCorners {
  public:
    HWY_INLINE explicit PackedCorners(const ClusterLanes& lanes) : table_(lanes.packed) {}
    HWY_INLINE Corners Of(VI corners) const {
        const DI d;
        Corners c;
        for (int k = 0; k < 3; ++k) {
            const auto v = table_.At(CornerOf(corners, k));
            c.x[k] = hn::BitCast(d, hn::ShiftRight<16>(hn::BitCast(DU(), v)));
            c.y[k] = hn::And(v, hn::Set(d, 0xffff));
        }
        return c;
    }

  private:
    VertexTable table_;
};

/// Of a larger one.
class WideCorners {
  public:
    HWY_INLINE explicit WideCorners(const ClusterLanes& lanes)
        : x_(lanes.x_snapped), y_(lanes.y_snapped) {}
    HWY_INLINE Corners Of(VI corners) const {
        Corners c;
        for (int k = 0; k < 3; ++k) {
            c.x[k] = x_.At(CornerOf(corners, k));
            c.y[k] = y_.At(CornerOf(corners, k));
        }
        return c;
    }

  private:
    VertexTable x_;
    VertexTable y_;
};

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

/// Whether all of the 2 x 2 centres from (x, y) on lie outside: corners and centre from one origin,
/// `turned` -1 where the corners run counter-clockwise.
HWY_INLINE hn::Mask<DI> MissesSquare(const Corners& c, VI turned, VI x, VI y) {
    const DI d;
    auto outside00 = hn::Zero(d);
    auto outside10 = outside00;
    auto outside01 = outside00;
    auto outside11 = outside00;
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        const auto dx = Turn(hn::Sub(c.x[next], c.x[k]), turned);
        const auto dy = Turn(hn::Sub(c.y[next], c.y[k]), turned);
        const auto right = hn::ShiftLeft<kSubpixelBits>(dy);
        const auto down = hn::ShiftLeft<kSubpixelBits>(dx);
        const auto e00 = EdgeAt(dx, dy, hn::Sub(x, c.x[k]), hn::Sub(y, c.y[k]));
        const auto e10 = hn::Sub(e00, right);
        outside00 = hn::Or(outside00, e00);
        outside10 = hn::Or(outside10, e10);
        outside01 = hn::Or(outside01, hn::Add(e00, down));
        outside11 = hn::Or(outside11, hn::Add(e10, down));
    }
    const auto all = hn::And(hn::And(outside00, outside10), hn::And(outside01, outside11));
    return hn::Lt(all, hn::Zero(d));
}

HWY_INLINE void Append(VI v, hn::Mask<DI> mask, std::int32_t* to) {
    hn::StoreU(hn::Compress(v, mask), DI(), to);
}

template <class Vertices>
void CullTriangles(const std::int32_t* corners,
                   std::size_t count,
                   const ClusterLanes& lanes,
                   const CullJob& job,
                   CullResult& result) {
    const DI d;
    const std::size_t n = hn::Lanes(d);
    const Vertices vertices(lanes);
    const auto left = hn::Set(d, lanes.x0);
    const auto top = hn::Set(d, lanes.y0);
    const auto to_centre = hn::Set(d, kSubpixels / 2 - 1);
    const auto zero = hn::Zero(d);
    auto largest = zero;
    auto largest_px = zero;
    auto area_px = zero;
    bool has_back = false;
    std::size_t kept = 0;
    std::size_t unsure = 0;
    std::size_t no_sample = 0;
    std::size_t outside = 0;
    auto* kept_corners = reinterpret_cast<std::int32_t*>(result.corners);
    for (std::size_t at = 0; at < count; at += n) {
        const auto indices = hn::Load(d, corners + at);
        const Corners c = vertices.Of(indices);
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
        const auto x0 = hn::Max(left_px, hn::Set(d, job.image.x0));
        const auto y0 = hn::Max(top_px, hn::Set(d, job.image.y0));
        const auto x1 = hn::Min(right_px, hn::Set(d, job.image.x1));
        const auto y1 = hn::Min(bottom_px, hn::Set(d, job.image.y1));

        const auto is_real = hn::FirstN(d, count - at);
        const auto has_box = hn::And(hn::Lt(left_px, right_px), hn::Lt(top_px, bottom_px));
        const auto has_area = hn::And(hn::Ne(area, zero), has_box);
        const auto in_image = hn::And(hn::Lt(x0, x1), hn::Lt(y0, y1));
        auto keep = hn::And(is_real, hn::And(has_area, in_image));
        no_sample += hn::CountTrue(d, hn::AndNot(has_area, is_real));
        outside += hn::CountTrue(d, hn::And(is_real, hn::AndNot(in_image, has_area)));

        const auto is_sure = hn::Gt(hn::Abs(area), AreaDoubt(c));
        // Counter-clockwise in the world is counter-clockwise as seen: negative with y down.
        const auto is_back = hn::And(is_sure, hn::Gt(area, zero));
        if (job.drops_backs) keep = hn::AndNot(is_back, keep);
        if (job.drops_fronts) keep = hn::AndNot(hn::And(is_sure, hn::Lt(area, zero)), keep);

        const auto width = hn::Sub(right_px, left_px);
        const auto height = hn::Sub(bottom_px, top_px);
        const auto three = hn::Set(d, 3);
        const auto is_tiny = hn::And(keep, hn::And(hn::Lt(width, three), hn::Lt(height, three)));
        if (!hn::AllFalse(d, is_tiny)) {
            const auto turned = hn::VecFromMask(d, hn::Lt(area, zero));
            const auto centre = hn::Set(d, kSubpixels / 2);
            const auto x = hn::Sub(hn::Add(hn::ShiftLeft<kSubpixelBits>(left_px), centre), left);
            const auto y = hn::Sub(hn::Add(hn::ShiftLeft<kSubpixelBits>(top_px), centre), top);
            const auto is_missed = hn::And(is_tiny, MissesSquare(c, turned, x, y));
            no_sample += hn::CountTrue(d, is_missed);
            if (job.drops_no_sample) keep = hn::AndNot(is_missed, keep);
        }
        const std::size_t more = hn::CountTrue(d, keep);
        if (more == 0) continue;
        largest_px = hn::Max(largest_px, hn::IfThenElseZero(keep, hn::Max(width, height)));
        area_px = hn::Add(area_px, hn::IfThenElseZero(keep, hn::Mul(width, height)));
        has_back = has_back || !hn::AllFalse(d, hn::And(is_back, keep));
        const auto side =
            hn::IfThenElseZero(is_back, hn::Set(d, static_cast<std::int32_t>(kBackSide)));
        Append(hn::Or(indices, side), keep, kept_corners + kept);
        Append(hn::Or(x0, hn::ShiftLeft<16>(x1)), keep, result.x_span + kept);
        Append(hn::Or(y0, hn::ShiftLeft<16>(y1)), keep, result.y_span + kept);
        const auto is_unsure = hn::AndNot(is_sure, keep);
        if (!hn::AllFalse(d, is_unsure)) {
            const auto places = hn::Iota(d, static_cast<std::int32_t>(kept));
            const auto left_over = hn::Compress(hn::VecFromMask(d, is_unsure), keep);
            const auto is_one = hn::And(hn::MaskFromVec(left_over), hn::FirstN(d, more));
            Append(places, is_one, reinterpret_cast<std::int32_t*>(result.unsure) + unsure);
            unsure += hn::CountTrue(d, is_one);
        }
        kept += more;
    }
    result.count = kept;
    result.unsure_count = unsure;
    result.no_sample = no_sample;
    result.outside = outside;
    result.has_back = has_back;
    result.area_px = static_cast<std::size_t>(hn::GetLane(hn::SumOfLanes(d, area_px)));
    result.extent_px = hn::GetLane(hn::MaxOfLanes(d, largest_px));
    const std::int32_t extent = hn::GetLane(hn::MaxOfLanes(d, largest));
    result.has_large = extent > kLaneExtent_px * kSubpixels;
}

void CullCluster(const LaneMesh& mesh,
                 std::size_t cluster,
                 const ClusterLanes& lanes,
                 const CullJob& job,
                 CullResult& result) {
    const std::size_t count = mesh.clusters().clusters[cluster].triangle_count;
    const std::int32_t* corners = mesh.corners(cluster);
    lanes.is_packed ? CullTriangles<PackedCorners>(corners, count, lanes, job, result)
                    : CullTriangles<WideCorners>(corners, count, lanes, job, result);
}

/// Which of a vector of triangles from `i` on have centres in a column and a row of `rect`.
HWY_INLINE hn::Mask<DI> Meets(const CullResult& result, const PixelRect& rect, std::size_t i) {
    const DI d;
    const auto low_half = hn::Set(d, 0xffff);
    const auto meets = [&](VI span, std::int32_t begin, std::int32_t end) {
        return hn::And(hn::Lt(hn::And(span, low_half), hn::Set(d, end)),
                       hn::Gt(hn::ShiftRight<16>(span), hn::Set(d, begin)));
    };
    return hn::And(hn::FirstN(d, result.count - i),
                   hn::And(meets(hn::Load(d, result.x_span + i), rect.x0, rect.x1),
                           meets(hn::Load(d, result.y_span + i), rect.y0, rect.y1)));
}

std::size_t CountTriangles(const CullResult& result, const PixelRect& rect) {
    const DI d;
    std::size_t count = 0;
    for (std::size_t i = 0; i < result.count; i += hn::Lanes(d))
        count += hn::CountTrue(d, Meets(result, rect, i));
    return count;
}

std::size_t ListTriangles(const CullResult& result,
                          const PixelRect& rect,
                          std::uint32_t base,
                          std::uint32_t* to) {
    const DI d;
    const auto entry_base = hn::Set(d, static_cast<std::int32_t>(base));
    std::size_t listed = 0;
    for (std::size_t i = 0; i < result.count; i += hn::Lanes(d)) {
        const auto here = Meets(result, rect, i);
        const auto entry = hn::Or(hn::Iota(d, static_cast<std::int32_t>(i)), entry_base);
        Append(entry, here, reinterpret_cast<std::int32_t*>(to) + listed);
        listed += hn::CountTrue(d, here);
    }
    return listed;
}

void ListAllTriangles(std::size_t count, std::uint32_t base, std::uint32_t* to) {
    const hn::RebindToUnsigned<DI> d;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d))
        hn::StoreU(hn::Iota(d, base + static_cast<std::uint32_t>(i)), d, to + i);
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(CullCluster);
HWY_EXPORT(CountTriangles);
HWY_EXPORT(ListTriangles);
HWY_EXPORT(ListAllTriangles);

void cull_cluster(const LaneMesh& mesh,
                  std::size_t cluster,
                  const ClusterLanes& lanes,
                  const CullJob& job,
                  CullResult& result) {
    HWY_DYNAMIC_DISPATCH(CullCluster)(mesh, cluster, lanes, job, result);
}

std::size_t list_triangles(const CullResult& result,
                           const PixelRect& rect,
                           std::uint32_t base,
                           EntryList& to) {
    std::uint32_t* room = to.room(result.count + kLanePad);
    const std::size_t listed = HWY_DYNAMIC_DISPATCH(ListTriangles)(result, rect, base, room);
    to.grow(listed);
    return listed;
}

std::size_t count_triangles(const CullResult& result, const PixelRect& rect) {
    return HWY_DYNAMIC_DISPATCH(CountTriangles)(result, rect);
}

void list_all_triangles(const CullResult& result, std::uint32_t base, EntryList& to) {
    HWY_DYNAMIC_DISPATCH(ListAllTriangles)(result.count, base, to.room(result.count + kLanePad));
    to.grow(result.count);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
