#include <limits>

#include "raster/mesh/lane_collect.h"
#include "raster/mesh/lane_rows.h"
#include "raster/mesh/lane_triangles.h"
#include "raster/pass/screen_vertex.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/mesh/lane_setup.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DI = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<DI>;
using DF = hn::Rebind<float, DI>;
using VF = hn::Vec<DF>;

#include "raster/mesh/lane_edges.inl"
#include "raster/mesh/lane_planes.inl"

#include "raster/mesh/lane_values.inl"

HWY_INLINE Corner LoadCorner(const LaneTriangles::Corners& from, std::size_t at) {
    const DI d;
    const DF df;
    Corner c;
    c.x = hn::Load(d, from.x + at);
    c.y = hn::Load(d, from.y + at);
    c.q = hn::Load(df, from.q + at);
    c.value = hn::Load(df, from.values[0] + at);
    c.Snap();
    return c;
}

/// The 9 numbers of three edges; returns where the triangle is thin.
HWY_INLINE hn::Mask<DI> SetUpEdges(const Corner (&c)[3],
                                   const Reference& ref,
                                   std::size_t at,
                                   LaneTriangles& out) {
    const DI d;
    const EdgeLanes edges = MakeEdges(c, ref);
    for (int k = 0; k < 3; ++k) {
        hn::Store(edges.at_ref[k], d, out.edge_at_ref[k] + at);
        hn::Store(edges.dx[k], d, out.edge_dx[k] + at);
        hn::Store(edges.dy[k], d, out.edge_dy[k] + at);
    }
    return edges.is_thin;
}

HWY_INLINE void SetUpBox(const Corner (&c)[3],
                         const PixelRect& drawn,
                         std::size_t at,
                         LaneTriangles& out) {
    const DI d;
    const auto to_centre = hn::Set(d, kSubpixels / 2 - 1);
    const auto first = [&](VI v) { return hn::ShiftRight<kSubpixelBits>(hn::Add(v, to_centre)); };
    const auto low = [](VI a, VI b, VI e) { return hn::Min(hn::Min(a, b), e); };
    const auto high = [](VI a, VI b, VI e) { return hn::Max(hn::Max(a, b), e); };
    const auto x0 = first(low(c[0].x_snapped, c[1].x_snapped, c[2].x_snapped));
    const auto x1 = first(high(c[0].x_snapped, c[1].x_snapped, c[2].x_snapped));
    const auto y0 = first(low(c[0].y_snapped, c[1].y_snapped, c[2].y_snapped));
    const auto y1 = first(high(c[0].y_snapped, c[1].y_snapped, c[2].y_snapped));
    hn::Store(hn::Max(x0, hn::Set(d, drawn.x0)), d, out.x0 + at);
    hn::Store(hn::Max(y0, hn::Set(d, drawn.y0)), d, out.y0 + at);
    hn::Store(hn::Min(x1, hn::Set(d, drawn.x1)), d, out.x1 + at);
    hn::Store(hn::Min(y1, hn::Set(d, drawn.y1)), d, out.y1 + at);
}

template <class D, class Plane, class Planes>
HWY_INLINE void StorePlane(D d, const Plane& p, std::size_t at, Planes& out) {
    hn::Store(p.at_ref, d, out.at_ref + at);
    hn::Store(p.dx, d, out.dx + at);
    hn::Store(p.dy, d, out.dy + at);
    hn::Store(p.low, d, out.low + at);
    hn::Store(p.high, d, out.high + at);
}

void SetUpLanes(const PassFormat& format,
                const LaneSource& source,
                std::span<const std::uint32_t> entries,
                const PixelRect& drawn,
                const LaneDepthBias& depth_bias,
                LaneTriangles& out) {
    const DI d;
    const DF df;
    const auto values = static_cast<std::size_t>(format.interpolants);
    collect_corners(source, values, format.constant, entries, out);
    out.count = entries.size();
    const CodeScale scale(format);
    for (std::size_t at = 0; at < out.count; at += hn::Lanes(d)) {
        Corner c[3];
        for (int k = 0; k < 3; ++k)
            c[k] = LoadCorner(out.corners[k], at);
        const Reference ref(c[0]);
        hn::Store(ref.x, d, out.ref_x + at);
        hn::Store(ref.y, d, out.ref_y + at);
        SetUpBox(c, drawn, at, out);
        const auto is_thin = SetUpEdges(c, ref, at, out);
        const PlaneLanes planes = MakePlanes(c, ref);
        StorePlane(df, MakeDepth(planes, c, depth_bias), at, out.q);
        auto needs_limits = is_thin;
        const auto set_up = [&](VF v0, VF v1, VF v2, std::size_t i) {
            if (format.store == Store::f32) {
                const auto limit = hn::RebindMask(df, is_thin);
                StorePlane(df, MakeNumbers(planes, v0, v1, v2, limit), at, out.numbers[i]);
                return;
            }
            const CodePlane codes = MakeCodes(planes, v0, v1, v2, is_thin, scale);
            StorePlane(d, codes, at, out.codes[i]);
            needs_limits = hn::Or(needs_limits, codes.may_leave);
        };
        if (values > 0) set_up(c[0].value, c[1].value, c[2].value, 0);
        for (std::size_t i = 1; i < values; ++i) {
            set_up(hn::Load(df, out.corners[0].values[i] + at),
                   hn::Load(df, out.corners[1].values[i] + at),
                   hn::Load(df, out.corners[2].values[i] + at),
                   i);
        }
        hn::Store(hn::VecFromMask(d, needs_limits), d, out.needs_limits + at);
    }
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(SetUpLanes);

void set_up_lanes(const PassFormat& format,
                  const LaneSource& source,
                  std::span<const std::uint32_t> entries,
                  const PixelRect& drawn,
                  const LaneDepthBias& depth_bias,
                  LaneTriangles& out) {
    HWY_DYNAMIC_DISPATCH(SetUpLanes)(format, source, entries, drawn, depth_bias, out);
    find_rows(out);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
