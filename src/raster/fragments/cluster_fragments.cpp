#include "raster/fragments/cluster_fragments.h"

#include <limits>

#include "raster/pass/screen_vertex.h"
#include "raster/pass/tile_buffer.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fragments/cluster_fragments.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DI = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<DI>;
using MI = hn::Mask<DI>;
using DF = hn::Rebind<float, DI>;
using VF = hn::Vec<DF>;

#include "raster/mesh/lane_edges.inl"
#include "raster/mesh/lane_planes.inl"
#include "raster/mesh/lane_tables.inl"
#include "raster/mesh/lane_values.inl"

HWY_INLINE const std::int32_t* AsInts(const float* from) {
    return reinterpret_cast<const std::int32_t*>(from);
}

/// No value but depth.
struct NoValues {
    static constexpr bool kIsWide = false;
    HWY_INLINE NoValues(const FragmentJob&, const CullResult&) {}
    HWY_INLINE void Load(std::size_t, VI, Corner (&)[3]) {}
    HWY_INLINE MI SetUp(const PlaneLanes&, const Corner (&)[3], MI is_thin) { return is_thin; }
    HWY_INLINE void StartColumn(int, VI) {}
    HWY_INLINE void StartRow(VI) {}
    template <bool kLimits>
    HWY_INLINE VI At(int, MI) const {
        return hn::Zero(DI());
    }
};

/// One constant a triangle; kIsWide: of 32 bits.
template <bool kWide>
struct ConstantValues {
    static constexpr bool kIsWide = kWide;
    HWY_INLINE ConstantValues(const FragmentJob& job, const CullResult&)
        : constants(reinterpret_cast<const std::int32_t*>(job.constants)) {}
    HWY_INLINE void Load(std::size_t at, VI, Corner (&)[3]) {
        constant = hn::LoadU(DI(), constants + at);
    }
    HWY_INLINE MI SetUp(const PlaneLanes&, const Corner (&)[3], MI is_thin) { return is_thin; }
    HWY_INLINE void StartColumn(int, VI) {}
    HWY_INLINE void StartRow(VI) {}
    template <bool kLimits>
    HWY_INLINE VI At(int, MI) const {
        return constant;
    }

    const std::int32_t* constants;
    VI constant;
};

/// A code with kFraction bits after the point.
template <int kFraction>
struct CodeValues {
    static constexpr bool kIsWide = false;
    HWY_INLINE CodeValues(const FragmentJob& job, const CullResult& culled)
        : front(AsInts(job.records.array(job.values[0]))),
          back(AsInts(job.records.array(job.values[1]))),
          has_back(culled.has_back && job.values[0] != job.values[1]),
          scale(job.format) {}
    HWY_INLINE void Load(std::size_t, VI corners, Corner (&c)[3]) {
        const DI d;
        const DF df;
        for (int k = 0; k < 3; ++k)
            c[k].value = hn::BitCast(df, front.At(CornerOf(corners, k)));
        if (!has_back) return;
        const auto is_back = hn::RebindMask(df, hn::Lt(corners, hn::Zero(d)));
        for (int k = 0; k < 3; ++k) {
            const auto value = hn::BitCast(df, back.At(CornerOf(corners, k)));
            c[k].value = hn::IfThenElse(is_back, value, c[k].value);
        }
    }
    HWY_INLINE MI SetUp(const PlaneLanes& planes, const Corner (&c)[3], MI is_thin) {
        plane = MakeCodes(planes, c[0].value, c[1].value, c[2].value, is_thin, scale);
        return hn::Or(is_thin, plane.may_leave);
    }
    HWY_INLINE void StartColumn(int column, VI x) { columns[column] = hn::Mul(plane.dx, x); }
    HWY_INLINE void StartRow(VI y) { row = hn::Add(plane.at_ref, hn::Mul(plane.dy, y)); }
    template <bool kLimits>
    HWY_INLINE VI At(int column, MI needs_limits) const {
        auto code = hn::Add(row, columns[column]);
        if (kLimits) {
            const auto limited = hn::Min(hn::Max(code, plane.low), plane.high);
            code = hn::IfThenElse(needs_limits, limited, code);
        }
        return hn::ShiftRight<kFraction>(code);
    }

    VertexTable front;
    VertexTable back;
    bool has_back;
    CodeScale scale;
    CodePlane plane;
    VI row;
    VI columns[kFragmentExtent_px];
};

/// A vector of triangles, set up.
struct SetUp {
    Reference ref;
    EdgeLanes edges;
    NumberPlane depth;
    MI needs_limits;
};

/// One axis of a grid that no triangle of a vector exceeds: it repeats every `side` pixels.
class GridAxis {
  public:
    HWY_INLINE GridAxis(VI first, VI extents, MI is_real) : first_(first) {
        const DI d;
        const DF df;
        const auto most = hn::IfThenElseZero(is_real, extents);
        const auto side = hn::MaxOfLanes(d, most);
        side_ = hn::GetLane(side);
        // The first pixels are below 2^15: the half keeps rounding away from whole numbers.
        const auto middle = hn::Add(hn::ConvertTo(df, first), hn::Set(df, 0.5F));
        const auto periods = hn::ConvertTo(d, hn::Div(middle, hn::ConvertTo(df, side)));
        place_ = hn::Sub(first, hn::Mul(periods, side));
    }
    [[nodiscard]] HWY_INLINE int side() const { return side_; }
    /// The one pixel of each triangle's `side` pixels from its first on that lies at place i.
    [[nodiscard]] HWY_INLINE VI PixelAt(int i) const {
        const DI d;
        const auto way = hn::Sub(hn::Set(d, i), place_);
        const auto is_before = hn::Lt(way, hn::Zero(d));
        return hn::Add(hn::Add(first_, way), hn::IfThenElseZero(is_before, hn::Set(d, side_)));
    }

  private:
    VI first_;
    VI place_;  ///< of the first pixels
    int side_;
};

/// Every pixel that the triangles cover, by its place in the grid: each triangle has one pixel at
/// each place, so that all that may meet in one pixel stand in one vector, in order. Returns how
/// many fragments there are now.
template <bool kLimits, class Values>
HWY_INLINE std::size_t AddPixels(const SetUp& t,
                                 const PixelRect& bounds,
                                 const GridAxis& columns,
                                 const GridAxis& rows,
                                 Values& values,
                                 std::size_t found,
                                 ClusterFragments& out) {
    const DI d;
    const DF df;
    const auto minus_one = hn::Set(d, -1);
    const auto limits = hn::RebindMask(df, t.needs_limits);
    VI edges[3][kFragmentExtent_px];
    VF q[kFragmentExtent_px];
    VI place[kFragmentExtent_px];
    for (int i = 0; i < columns.side(); ++i) {
        const auto x = columns.PixelAt(i);
        const auto from_ref = hn::Sub(x, t.ref.x);
        for (int k = 0; k < 3; ++k)
            edges[k][i] = hn::Mul(t.edges.dx[k], from_ref);
        q[i] = hn::Mul(t.depth.dx, hn::ConvertTo(df, from_ref));
        place[i] = hn::Sub(x, hn::Set(d, bounds.x0));
        values.StartColumn(i, from_ref);
    }
    for (int j = 0; j < rows.side(); ++j) {
        const auto y = rows.PixelAt(j);
        const auto from_ref = hn::Sub(y, t.ref.y);
        VI edge[3];
        for (int k = 0; k < 3; ++k)
            edge[k] = hn::Add(t.edges.at_ref[k], hn::Mul(t.edges.dy[k], from_ref));
        const auto row_q =
            hn::Add(t.depth.at_ref, hn::Mul(t.depth.dy, hn::ConvertTo(df, from_ref)));
        const auto row_place = hn::ShiftLeft<8>(hn::Sub(y, hn::Set(d, bounds.y0)));
        values.StartRow(from_ref);
        for (int i = 0; i < columns.side(); ++i) {
            const auto all = hn::Or3(hn::Add(edge[0], edges[0][i]),
                                     hn::Add(edge[1], edges[1][i]),
                                     hn::Add(edge[2], edges[2][i]));
            const auto is_covered = hn::Gt(all, minus_one);
            const std::size_t more = hn::CountTrue(d, is_covered);
            if (more == 0) continue;
            auto depth = hn::Add(row_q, q[i]);
            if (kLimits) {
                const auto limited = hn::Min(hn::Max(depth, t.depth.low), t.depth.high);
                depth = hn::IfThenElse(limits, limited, depth);
            }
            const auto value = values.template At<kLimits>(i, t.needs_limits);
            auto word = hn::Add(row_place, place[i]);
            const auto append = [&](VI v, auto* to) {
                hn::StoreU(
                    hn::Compress(v, is_covered), d, reinterpret_cast<std::int32_t*>(to) + found);
            };
            if (Values::kIsWide) {
                append(value, out.values);
            } else {
                word = hn::Or(word, hn::ShiftLeft<16>(value));
            }
            append(word, out.words);
            append(hn::BitCast(d, depth), out.q);
            found += more;
        }
    }
    return found;
}

template <class Values>
void FindIn(const FragmentJob& job, const CullResult& culled, ClusterFragments& out) {
    const DI d;
    const DF df;
    const LaneRecords& records = job.records;
    const VertexTable x(records.x());
    const VertexTable y(records.y());
    const VertexTable q(AsInts(records.q()));
    const auto low_half = hn::Set(d, 0xffff);
    Values values(job, culled);
    std::size_t found = 0;
    for (std::size_t at = 0; at < culled.count; at += hn::Lanes(d)) {
        const auto corners =
            hn::Load(d, reinterpret_cast<const std::int32_t*>(culled.corners) + at);
        Corner c[3];
        for (int k = 0; k < 3; ++k) {
            const auto index = CornerOf(corners, k);
            c[k].x = x.At(index);
            c[k].y = y.At(index);
            c[k].q = hn::BitCast(df, q.At(index));
            c[k].Snap();
        }
        values.Load(at, corners, c);
        const Reference ref(c[0]);
        const auto is_real = hn::FirstN(d, culled.count - at);
        EdgeLanes edges = MakeEdges(c, ref);
        const PlaneLanes planes = MakePlanes(c, ref);
        const NumberPlane depth = MakeDepth(planes, c, job.depth_bias);
        const auto needs_limits = values.SetUp(planes, c, edges.is_thin);
        const auto x_span = hn::Load(d, culled.x_span + at);
        const auto y_span = hn::Load(d, culled.y_span + at);
        // What is no triangle covers nothing.
        edges.at_ref[0] = hn::IfThenElse(is_real, edges.at_ref[0], hn::Set(d, -1));
        edges.dx[0] = hn::IfThenElseZero(is_real, edges.dx[0]);
        edges.dy[0] = hn::IfThenElseZero(is_real, edges.dy[0]);
        const SetUp t{ref, edges, depth, needs_limits};
        const auto axis = [&](VI span) {
            const auto begin = hn::And(span, low_half);
            return GridAxis(begin, hn::Sub(hn::ShiftRight<16>(span), begin), is_real);
        };
        const GridAxis columns = axis(x_span);
        const GridAxis rows = axis(y_span);
        const bool has_limits = !hn::AllFalse(d, hn::And(needs_limits, is_real));
        found = has_limits ? AddPixels<true>(t, job.bounds, columns, rows, values, found, out)
                           : AddPixels<false>(t, job.bounds, columns, rows, values, found, out);
    }
    out.count = found;
}

void FindFragments(const FragmentJob& job, const CullResult& culled, ClusterFragments& out) {
    const PassFormat& format = job.format;
    if (format.store == Store::none) return FindIn<NoValues>(job, culled, out);
    if (format.constant) {
        FragmentBlock::has_wide_values(format) ? FindIn<ConstantValues<true>>(job, culled, out)
                                               : FindIn<ConstantValues<false>>(job, culled, out);
        return;
    }
    format.store == Store::u8
        ? FindIn<CodeValues<lane_fraction_bits(Store::u8)>>(job, culled, out)
        : FindIn<CodeValues<lane_fraction_bits(Store::u16)>>(job, culled, out);
}

/// Which fragments a tile draws, and where they lie in it.
class TilePlaces {
  public:
    HWY_INLINE TilePlaces(const PixelRect& bounds, const FragmentTile& tile)
        : x0_(tile.drawn.x0 - bounds.x0),
          y0_(tile.drawn.y0 - bounds.y0),
          x1_(tile.drawn.x1 - bounds.x0),
          y1_(tile.drawn.y1 - bounds.y0),
          first_((bounds.y0 - tile.own.y0 + kMaxHalo_px) * kTileStride + kTileMargin_px +
                 bounds.x0 - tile.own.x0),
          has_all_(x0_ <= 0 && y0_ <= 0 && bounds.x1 <= tile.drawn.x1 &&
                   bounds.y1 <= tile.drawn.y1) {}

    [[nodiscard]] HWY_INLINE bool has_all() const { return has_all_; }
    [[nodiscard]] HWY_INLINE MI Has(VI word) const {
        const DI d;
        const auto is_in = [&](VI v, int begin, int end) {
            return hn::And(hn::Gt(v, hn::Set(d, begin - 1)), hn::Lt(v, hn::Set(d, end)));
        };
        return hn::And(is_in(X(word), x0_, x1_), is_in(Y(word), y0_, y1_));
    }
    /// The word with its place in the tile.
    [[nodiscard]] HWY_INLINE VI Of(VI word) const {
        const DI d;
        const auto row = hn::Mul(Y(word), hn::Set(d, kTileStride));
        const auto place = hn::Add(hn::Add(hn::Set(d, first_), X(word)), row);
        return hn::Or(place, hn::And(word, hn::Set(d, static_cast<std::int32_t>(0xffff0000))));
    }

  private:
    static HWY_INLINE VI X(VI word) { return hn::And(word, hn::Set(DI(), 0xff)); }
    static HWY_INLINE VI Y(VI word) {
        return hn::And(hn::ShiftRight<8>(word), hn::Set(DI(), 0xff));
    }
    std::int32_t x0_, y0_, x1_, y1_;  ///< what the tile draws, from the cluster's box
    std::int32_t first_;
    bool has_all_;
};

/// Array by array, since each is written up to a vector beyond its end.
std::size_t KeepFragments(const PassFormat& format,
                          const ClusterFragments& fragments,
                          const PixelRect& bounds,
                          const FragmentTile& tile,
                          std::byte* data) {
    const DI d;
    const TilePlaces places(bounds, tile);
    const auto* words = reinterpret_cast<const std::int32_t*>(fragments.words);
    const auto keep = [&](const std::int32_t* from, std::byte* array, const auto& change) {
        auto* const to = reinterpret_cast<std::int32_t*>(array);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < fragments.count; i += hn::Lanes(d)) {
            const auto v = change(hn::Load(d, from + i));
            if (places.has_all()) {
                hn::StoreU(v, d, to + i);
                continue;
            }
            const auto is_kept =
                hn::And(places.Has(hn::Load(d, words + i)), hn::FirstN(d, fragments.count - i));
            hn::StoreU(hn::Compress(v, is_kept), d, to + kept);
            kept += hn::CountTrue(d, is_kept);
        }
        return places.has_all() ? fragments.count : kept;
    };
    const auto same = [](VI v) { return v; };
    const std::size_t count = keep(words, data, [&](VI word) { return places.Of(word); });
    data += lane_padded(count) * sizeof(std::uint32_t);
    keep(AsInts(fragments.q), data, same);
    data += lane_padded(count) * sizeof(std::uint32_t);
    if (FragmentBlock::has_wide_values(format))
        keep(reinterpret_cast<const std::int32_t*>(fragments.values), data, same);
    return count;
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(FindFragments);
HWY_EXPORT(KeepFragments);

bool has_fragments(const PassFormat& format) {
    const bool is_integer = format.store != Store::f32;
    return lanes_can_draw(format) && format.depth == DepthFormat::q32 && is_integer &&
           format.planes() <= 1;
}

void find_fragments(const FragmentJob& job, const CullResult& culled, ClusterFragments& out) {
    HWY_DYNAMIC_DISPATCH(FindFragments)(job, culled, out);
}

std::size_t keep_fragments(const PassFormat& format,
                           const ClusterFragments& fragments,
                           const PixelRect& bounds,
                           const FragmentTile& tile,
                           std::byte* to) {
    return HWY_DYNAMIC_DISPATCH(KeepFragments)(format, fragments, bounds, tile, to);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
