#include <limits>

#include "raster/mesh/lane_collect.h"
#include "raster/mesh/lane_rows.h"
#include "raster/mesh/lane_triangles.h"
#include "raster/mesh/micro_triangles.h"
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

/// One corner of a vector of triangles.
struct Corner {
    VI x;  ///< 1/65536 px
    VI y;
    VF q;
    VF value;
    VI x_snapped;  ///< 1/256 px
    VI y_snapped;
};

HWY_INLINE Corner LoadCorner(const LaneTriangles::Corners& from, std::size_t at) {
    const DI d;
    const DF df;
    Corner c;
    c.x = hn::Load(d, from.x + at);
    c.y = hn::Load(d, from.y + at);
    c.q = hn::Load(df, from.q + at);
    c.value = hn::Load(df, from.values[0] + at);
    const auto half = hn::Set(d, 1 << (kLaneBits - kSubpixelBits - 1));
    c.x_snapped = hn::ShiftRight<kLaneBits - kSubpixelBits>(hn::Add(c.x, half));
    c.y_snapped = hn::ShiftRight<kLaneBits - kSubpixelBits>(hn::Add(c.y, half));
    return c;
}

/// The 9 numbers of three edges; returns where the triangle is thin.
HWY_INLINE hn::Mask<DI> SetUpEdges(
    const Corner (&c)[3], VI ref_x, VI ref_y, std::size_t at, LaneTriangles& out) {
    const DI d;
    const DF df;
    const auto zero = hn::Zero(d);
    const auto area = hn::Sub(
        hn::Mul(hn::Sub(c[1].x_snapped, c[0].x_snapped), hn::Sub(c[2].y_snapped, c[0].y_snapped)),
        hn::Mul(hn::Sub(c[2].x_snapped, c[0].x_snapped), hn::Sub(c[1].y_snapped, c[0].y_snapped)));
    // -1 where the corners run the other way: (v ^ -1) - -1 = -v turns the edges.
    const auto turned = hn::VecFromMask(d, hn::Lt(area, zero));
    const auto centre = hn::Set(d, kSubpixels / 2);
    const auto x = hn::Add(hn::ShiftLeft<kSubpixelBits>(ref_x), centre);
    const auto y = hn::Add(hn::ShiftLeft<kSubpixelBits>(ref_y), centre);
    auto longest2 = hn::Zero(df);
    for (int k = 0; k < 3; ++k) {
        const Corner& from = c[k];
        const Corner& to = c[(k + 1) % 3];
        auto dx = hn::Sub(to.x_snapped, from.x_snapped);
        auto dy = hn::Sub(to.y_snapped, from.y_snapped);
        const auto fx = hn::ConvertTo(df, dx);
        const auto fy = hn::ConvertTo(df, dy);
        longest2 = hn::Max(longest2, hn::Add(hn::Mul(fx, fx), hn::Mul(fy, fy)));
        dx = Turn(dx, turned);
        dy = Turn(dy, turned);
        const auto biased = EdgeAt(dx, dy, hn::Sub(x, from.x_snapped), hn::Sub(y, from.y_snapped));
        // Steps are whole multiples of 256, so the low bits never change a sign.
        hn::Store(hn::ShiftRight<kSubpixelBits>(biased), d, out.edge_at_ref[k] + at);
        hn::Store(hn::Neg(dy), d, out.edge_dx[k] + at);
        hn::Store(dx, d, out.edge_dy[k] + at);
    }
    // As is_thin of setup.cpp, in float: a height below 1.25 px.
    constexpr float kLimit = 1.25F * kSubpixels;
    const auto a = hn::ConvertTo(df, area);
    const auto is_thin = hn::Lt(hn::Mul(a, a), hn::Mul(hn::Set(df, kLimit * kLimit), longest2));
    return hn::RebindMask(d, is_thin);
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

/// A float plane, limited to its corners where `limit` says so.
HWY_INLINE void StoreNumbers(const PlaneLanes& planes,
                             VF v0,
                             VF v1,
                             VF v2,
                             hn::Mask<DF> limit,
                             std::size_t at,
                             LaneTriangles::Numbers& out) {
    const DF df;
    const auto p = planes.Through(v0, v1, v2);
    const auto most = hn::Set(df, std::numeric_limits<float>::max());
    hn::Store(p.at_ref, df, out.at_ref + at);
    hn::Store(p.dx, df, out.dx + at);
    hn::Store(p.dy, df, out.dy + at);
    hn::Store(hn::IfThenElse(limit, hn::Min(hn::Min(v0, v1), v2), hn::Neg(most)), df, out.low + at);
    hn::Store(hn::IfThenElse(limit, hn::Max(hn::Max(v0, v1), v2), most), df, out.high + at);
}

/// Depth's plane, limited to its corners, both moved by polygon offset.
HWY_INLINE void StoreDepth(const PlaneLanes& planes,
                           const Corner (&c)[3],
                           const LaneDepthBias& depth_bias,
                           std::size_t at,
                           LaneTriangles::Numbers& out) {
    const DF df;
    auto p = planes.Through(c[0].q, c[1].q, c[2].q);
    auto low = hn::Min(hn::Min(c[0].q, c[1].q), c[2].q);
    auto high = hn::Max(hn::Max(c[0].q, c[1].q), c[2].q);
    if (depth_bias.is_any) {
        const auto moved = DepthBiasOf(depth_bias, p, high);
        const auto within = [&](VF q) {
            const auto first = hn::Set(df, depth_bias.first);
            return hn::Min(hn::Max(hn::Add(q, moved), first), hn::Set(df, depth_bias.last));
        };
        p.at_ref = hn::Add(p.at_ref, moved);
        low = within(low);
        high = within(high);
    }
    hn::Store(p.at_ref, df, out.at_ref + at);
    hn::Store(p.dx, df, out.dx + at);
    hn::Store(p.dy, df, out.dy + at);
    hn::Store(low, df, out.low + at);
    hn::Store(high, df, out.high + at);
}

/// How a code's numbers are made fixed.
struct CodeScale {
    float scale;       ///< 2^fraction bits
    std::int32_t low;  ///< of a code anywhere: the store's range if it saturates
    std::int32_t high;
    bool is_limited;  ///< it saturates
};

/// Returns where a code may leave the store's range: its corners come within one code of an end,
/// and a centre of the snapped triangle may lie a little outside the true one.
HWY_INLINE hn::Mask<DI> StoreCodes(const PlaneLanes& planes,
                                   VF v0,
                                   VF v1,
                                   VF v2,
                                   hn::Mask<DI> is_thin,
                                   const CodeScale& scale,
                                   std::size_t at,
                                   LaneTriangles::Codes& out) {
    const DI d;
    const DF df;
    const auto p = planes.Through(v0, v1, v2);
    const auto limit = hn::Set(df, 0x1p30F);
    const auto fixed = [&](VF v) {
        const auto scaled = hn::Mul(v, hn::Set(df, scale.scale));
        return hn::NearestInt(hn::Min(hn::Max(scaled, hn::Neg(limit)), limit));
    };
    hn::Store(fixed(p.at_ref), d, out.at_ref + at);
    hn::Store(fixed(p.dx), d, out.dx + at);
    hn::Store(fixed(p.dy), d, out.dy + at);
    const auto low = hn::Set(d, scale.low);
    const auto high = hn::Set(d, scale.high);
    const auto least = fixed(hn::Floor(hn::Min(hn::Min(v0, v1), v2)));
    const auto greatest = fixed(hn::Floor(hn::Max(hn::Max(v0, v1), v2)));
    const auto within = [&](VI v) { return hn::Min(hn::Max(v, low), high); };
    hn::Store(hn::IfThenElse(is_thin, within(least), low), d, out.low + at);
    hn::Store(hn::IfThenElse(is_thin, within(greatest), high), d, out.high + at);
    const auto unit = hn::Set(d, static_cast<std::int32_t>(scale.scale));
    const auto span = hn::Add(hn::ShiftRight<6>(hn::Sub(greatest, least)), unit);
    const auto near_low = hn::Lt(hn::Sub(least, span), low);
    const auto near_high = hn::Gt(hn::Add(greatest, hn::Add(span, unit)), high);
    const auto always = hn::VecFromMask(d, hn::Or(near_low, near_high));
    return hn::MaskFromVec(scale.is_limited ? always : hn::Zero(d));
}

CodeScale ScaleOf(const PassFormat& format) {
    const int bits = lane_fraction_bits(format.store);
    CodeScale scale{};
    scale.scale = static_cast<float>(1 << bits);
    scale.low = std::numeric_limits<std::int32_t>::min();
    scale.high = std::numeric_limits<std::int32_t>::max();
    scale.is_limited = format.overflow == Overflow::saturate;
    if (scale.is_limited) {
        const std::int64_t codes = format.store == Store::u16 ? 1 << 16 : 1 << 8;
        scale.low = 0;
        scale.high = static_cast<std::int32_t>((codes << bits) - 1);
    }
    return scale;
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
    const CodeScale scale = ScaleOf(format);
    for (std::size_t at = 0; at < out.count; at += hn::Lanes(d)) {
        Corner c[3];
        for (int k = 0; k < 3; ++k)
            c[k] = LoadCorner(out.corners[k], at);
        const auto ref_x = hn::ShiftRight<kSubpixelBits>(c[0].x_snapped);
        const auto ref_y = hn::ShiftRight<kSubpixelBits>(c[0].y_snapped);
        hn::Store(ref_x, d, out.ref_x + at);
        hn::Store(ref_y, d, out.ref_y + at);
        SetUpBox(c, drawn, at, out);
        const auto is_thin = SetUpEdges(c, ref_x, ref_y, at, out);
        PlaneLanes planes = MakePlanes({c[0].x, c[1].x, c[2].x}, {c[0].y, c[1].y, c[2].y});
        const auto half = hn::Set(d, 1 << (kLaneBits - 1));
        planes.ref_x = ToPx(hn::Sub(hn::Add(hn::ShiftLeft<kLaneBits>(ref_x), half), c[0].x));
        planes.ref_y = ToPx(hn::Sub(hn::Add(hn::ShiftLeft<kLaneBits>(ref_y), half), c[0].y));
        StoreDepth(planes, c, depth_bias, at, out.q);
        auto needs_limits = is_thin;
        hn::Store(hn::VecFromMask(d, needs_limits), d, out.needs_limits + at);
        if (format.interpolants == 0) continue;
        if (format.store == Store::f32) {
            StoreNumbers(planes,
                         c[0].value,
                         c[1].value,
                         c[2].value,
                         hn::RebindMask(df, is_thin),
                         at,
                         out.numbers[0]);
        } else {
            needs_limits = hn::Or(
                needs_limits,
                StoreCodes(
                    planes, c[0].value, c[1].value, c[2].value, is_thin, scale, at, out.codes[0]));
            hn::Store(hn::VecFromMask(d, needs_limits), d, out.needs_limits + at);
        }
        if (format.interpolants == 1) continue;
        for (std::size_t i = 1; i < values; ++i) {
            const auto v0 = hn::Load(df, out.corners[0].values[i] + at);
            const auto v1 = hn::Load(df, out.corners[1].values[i] + at);
            const auto v2 = hn::Load(df, out.corners[2].values[i] + at);
            if (format.store == Store::f32) {
                StoreNumbers(planes, v0, v1, v2, hn::RebindMask(df, is_thin), at, out.numbers[i]);
            } else {
                needs_limits = hn::Or(
                    needs_limits, StoreCodes(planes, v0, v1, v2, is_thin, scale, at, out.codes[i]));
            }
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
    find_micro_triangles(format, out);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
