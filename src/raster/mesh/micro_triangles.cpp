#include "raster/mesh/micro_triangles.h"

#include <limits>

#include "raster/pass/tile_buffer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/mesh/micro_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DI = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<DI>;
using DF = hn::Rebind<float, DI>;
using VF = hn::Vec<DF>;

/// Numbers of the four pixels of a vector of triangles: (0, 0), (1, 0), (0, 1), (1, 1).
using Four = VI[4];

/// Where the pixels lie, from the triangles' references.
struct Places {
    VI x;
    VI y;
    VF x_f[2];  ///< of both columns
    VF y_f[2];  ///< of both rows
    hn::Mask<DI> needs_limits;
};

HWY_INLINE Places MakePlaces(const LaneTriangles& t, std::size_t at) {
    const DI d;
    const DF df;
    const auto one = hn::Set(d, 1);
    Places p;
    p.x = hn::Sub(hn::Load(d, t.x0 + at), hn::Load(d, t.ref_x + at));
    p.y = hn::Sub(hn::Load(d, t.y0 + at), hn::Load(d, t.ref_y + at));
    p.x_f[0] = hn::ConvertTo(df, p.x);
    p.y_f[0] = hn::ConvertTo(df, p.y);
    p.x_f[1] = hn::ConvertTo(df, hn::Add(p.x, one));
    p.y_f[1] = hn::ConvertTo(df, hn::Add(p.y, one));
    p.needs_limits = hn::MaskFromVec(hn::Load(d, t.needs_limits + at));
    return p;
}

/// An integer plane at all four, modulo 2^32.
HWY_INLINE void AtPixels(const Places& p, VI at_ref, VI dx, VI dy, Four& out) {
    out[0] = hn::Add(hn::Add(at_ref, hn::Mul(dy, p.y)), hn::Mul(dx, p.x));
    out[1] = hn::Add(out[0], dx);
    out[2] = hn::Add(out[0], dy);
    out[3] = hn::Add(out[1], dy);
}

/// The offsets of the four; negative where a pixel is not the triangle's.
HWY_INLINE void Offsets(
    const LaneTriangles& t, const Places& p, hn::Mask<DI> is_small, std::size_t at, Four& out) {
    const DI d;
    const auto sign = hn::Set(d, std::numeric_limits<std::int32_t>::min());
    Four edges[3];
    for (int k = 0; k < 3; ++k) {
        AtPixels(p,
                 hn::Load(d, t.edge_at_ref[k] + at),
                 hn::Load(d, t.edge_dx[k] + at),
                 hn::Load(d, t.edge_dy[k] + at),
                 edges[k]);
    }
    const auto x0 = hn::Load(d, t.x0 + at);
    const auto y0 = hn::Load(d, t.y0 + at);
    const auto width = hn::Sub(hn::Load(d, t.x1 + at), x0);
    const auto height = hn::Sub(hn::Load(d, t.y1 + at), y0);
    const auto first = hn::Add(hn::Mul(y0, hn::Set(d, kTileStride)), x0);
    const auto is_other = hn::VecFromMask(d, hn::Not(is_small));
    for (int i = 0; i < 4; ++i) {
        const int column = i & 1;
        const int row = i >> 1;
        const auto beyond = hn::Or3(
            hn::Sub(width, hn::Set(d, column + 1)), hn::Sub(height, hn::Set(d, row + 1)), is_other);
        const auto outside = hn::Or(beyond, hn::Or3(edges[0][i], edges[1][i], edges[2][i]));
        out[i] =
            hn::Or(hn::Add(first, hn::Set(d, row * kTileStride + column)), hn::And(outside, sign));
    }
}

/// A float plane, in the order of operations of lane_fill.cpp.
HWY_INLINE void NumbersAt(const LaneTriangles::Numbers& n,
                          const Places& p,
                          std::size_t at,
                          Four& out) {
    const DI d;
    const DF df;
    const auto at_ref = hn::Load(df, n.at_ref + at);
    const auto dx = hn::Load(df, n.dx + at);
    const auto dy = hn::Load(df, n.dy + at);
    const auto low = hn::Load(df, n.low + at);
    const auto high = hn::Load(df, n.high + at);
    const auto needs_limits = hn::RebindMask(df, p.needs_limits);
    for (int i = 0; i < 4; ++i) {
        const auto row = hn::Add(at_ref, hn::Mul(dy, p.y_f[i >> 1]));
        const auto v = hn::Add(row, hn::Mul(dx, p.x_f[i & 1]));
        const auto limited = hn::Min(hn::Max(v, low), high);
        out[i] = hn::BitCast(d, hn::IfThenElse(needs_limits, limited, v));
    }
}

template <int kFraction>
HWY_INLINE void CodesAt(const LaneTriangles::Codes& c, const Places& p, std::size_t at, Four& out) {
    const DI d;
    const auto low = hn::Load(d, c.low + at);
    const auto high = hn::Load(d, c.high + at);
    AtPixels(p, hn::Load(d, c.at_ref + at), hn::Load(d, c.dx + at), hn::Load(d, c.dy + at), out);
    for (VI& code : out) {
        const auto limited = hn::Min(hn::Max(code, low), high);
        code = hn::ShiftRight<kFraction>(hn::IfThenElse(p.needs_limits, limited, code));
    }
}

/// The four pixels of each triangle side by side.
struct Interleaved {
    alignas(64) std::int32_t numbers[4 * kLanePad];

    HWY_INLINE void Store(const Four& v) {
        hn::StoreInterleaved4(v[0], v[1], v[2], v[3], DI(), numbers);
    }
};

/// The micro-triangles of a vector of triangles; returns how many there are now.
HWY_INLINE std::size_t AddMicroTriangles(const PassFormat& format,
                                         LaneTriangles& t,
                                         hn::Mask<DI> is_small,
                                         std::size_t at,
                                         std::size_t found) {
    const DI d;
    const DF df;
    const auto minus_one = hn::Set(d, -1);
    const Places places = MakePlaces(t, at);
    const auto planes = static_cast<std::size_t>(format.planes());
    Interleaved offsets, q, values[kMaxPlanes];
    Four four;
    Offsets(t, places, is_small, at, four);
    auto count = hn::Zero(d);
    for (const VI& offset : four)
        count = hn::Sub(count, hn::VecFromMask(d, hn::Gt(offset, minus_one)));
    hn::Store(hn::IfThenElse(is_small, count, minus_one), d, t.micro_triangles.counts + at);
    offsets.Store(four);
    NumbersAt(t.q, places, at, four);
    q.Store(four);
    for (std::size_t k = 0; k < planes; ++k) {
        if (format.store == Store::f32) NumbersAt(t.numbers[k], places, at, four);
        if (format.constant) {
            for (VI& constant : four)
                constant = hn::Load(d, t.constants + at);
        } else if (format.store == Store::u8) {
            CodesAt<lane_fraction_bits(Store::u8)>(t.codes[k], places, at, four);
        } else if (format.store == Store::u16) {
            CodesAt<lane_fraction_bits(Store::u16)>(t.codes[k], places, at, four);
        }
        values[k].Store(four);
    }
    const std::size_t n = hn::Lanes(d);
    for (std::size_t i = 0; i < 4 * n; i += n) {
        const auto offset = hn::Load(d, offsets.numbers + i);
        const auto is_dot = hn::Gt(offset, minus_one);
        const auto append = [&](VI v, auto* to) {
            hn::StoreU(hn::Compress(v, is_dot), d, reinterpret_cast<std::int32_t*>(to) + found);
        };
        append(offset, t.micro_triangles.offset);
        hn::StoreU(hn::BitCast(df, hn::Compress(hn::Load(d, q.numbers + i), is_dot)),
                   df,
                   t.micro_triangles.q + found);
        for (std::size_t k = 0; k < planes; ++k)
            append(hn::Load(d, values[k].numbers + i), t.micro_triangles.values[k]);
        found += hn::CountTrue(d, is_dot);
    }
    return found;
}

void FindMicroTriangles(const PassFormat& format, LaneTriangles& t) {
    const DI d;
    const auto three = hn::Set(d, 3);
    const bool is_float = format.depth == DepthFormat::q32;
    std::size_t found = 0;
    for (std::size_t at = 0; at < t.count; at += hn::Lanes(d)) {
        const auto is_real = hn::FirstN(d, t.count - at);
        const auto width = hn::Sub(hn::Load(d, t.x1 + at), hn::Load(d, t.x0 + at));
        const auto height = hn::Sub(hn::Load(d, t.y1 + at), hn::Load(d, t.y0 + at));
        const auto is_small =
            hn::And(is_real, hn::And(hn::Lt(width, three), hn::Lt(height, three)));
        if (!is_float || 2 * hn::CountTrue(d, is_small) < hn::CountTrue(d, is_real)) {
            hn::Store(hn::Set(d, -1), d, t.micro_triangles.counts + at);
            continue;
        }
        found = AddMicroTriangles(format, t, is_small, at, found);
    }
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(FindMicroTriangles);

void find_micro_triangles(const PassFormat& format, LaneTriangles& triangles) {
    HWY_DYNAMIC_DISPATCH(FindMicroTriangles)(format, triangles);
}

MicroTriangleRun::MicroTriangleRun(const PassFormat& format,
                                   const LaneTriangles& triangles,
                                   TileBuffer& to)
    : micro_triangles_(triangles.micro_triangles),
      depth_(to.depth_row<float>(0)),
      plane_count_(format.planes()) {
    if (format.constant && (format.store == Store::u8 || format.store == Store::u16)) {
        narrow_ = format.store;
        planes_[0] = narrow_ == Store::u8 ? static_cast<void*>(to.plane_row<std::uint8_t>(0, 0))
                                          : to.plane_row<std::uint16_t>(0, 0);
        return;
    }
    for (int k = 0; k < plane_count_; ++k)
        planes_[static_cast<std::size_t>(k)] = to.plane_row<std::uint32_t>(k, 0);
}

template <class T, std::size_t kPlanes>
void MicroTriangleRun::draw() {
    float* const depth = depth_;
    std::array<T*, kMaxPlanes> planes{};
    for (std::size_t k = 0; k < kPlanes; ++k)
        planes[k] = static_cast<T*>(planes_[k]);
    for (std::size_t i = drawn_; i < due_; ++i) {
        const std::ptrdiff_t at = micro_triangles_.offset[i];
        const bool is_seen = micro_triangles_.q[i] > depth[at];
        depth[at] = is_seen ? micro_triangles_.q[i] : depth[at];
        for (std::size_t k = 0; k < kPlanes; ++k) {
            const auto value = static_cast<T>(micro_triangles_.values[k][i]);
            planes[k][at] = is_seen ? value : planes[k][at];
        }
    }
    drawn_ = due_;
}

void MicroTriangleRun::finish() {
    if (narrow_ == Store::u8) return draw<std::uint8_t, 1>();
    if (narrow_ == Store::u16) return draw<std::uint16_t, 1>();
    switch (plane_count_) {
        case 0:
            return draw<std::uint32_t, 0>();
        case 1:
            return draw<std::uint32_t, 1>();
        case 2:
            return draw<std::uint32_t, 2>();
        default:
            return draw<std::uint32_t, kMaxPlanes>();
    }
}

}  // namespace ink::raster
#endif  // HWY_ONCE
