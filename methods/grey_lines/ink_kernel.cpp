#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/grey_lines/ink_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "methods/grey_lines/ink.h"

HWY_BEFORE_NAMESPACE();
namespace ink::methods::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A piece reaches over six points of a row or so.
constexpr int kMostLanes = std::min<int>(8, HWY_LANES(float));
using Lanes = hn::CappedTag<float, kMostLanes>;

/// The middles of quarters of pixels, in rows of twice as many as there are pixels. A strip of so
/// many rows of pixels stays in the nearest cache.
constexpr int kStripRows = 16;
constexpr std::size_t kPoints = 128 + 16;  ///< in a row, and a vector more

/// The nearest line at each point of a strip: by how much the pen reaches over it, and the way from
/// there to the line's middle.
struct Strip {
    using Row = std::array<float, kPoints>;
    std::array<Row, 2 * kStripRows> over;
    std::array<Row, 2 * kStripRows> way_x;
    std::array<Row, 2 * kStripRows> way_y;
    std::array<std::uint64_t, kStripRows> touched;  ///< pixels, a bit each

    void clear() {
        for (Row& row : over)
            row.fill(-1);
        touched.fill(0);
    }
};

/// Points from the first to the last that a stroke may reach.
struct Reach {
    int first, last;

    Reach(float from, float way, float reach, int points) {
        const float low = std::min(from, from + way) - reach;
        const float high = std::max(from, from + way) + reach;
        // Clamped before: what is far outside has no number of a point.
        const auto most = static_cast<float>(points);
        first = static_cast<int>(std::ceil(std::clamp(2 * low - 0.5F, 0.0F, most)));
        last = static_cast<int>(std::floor(std::clamp(2 * high - 0.5F, -1.0F, most - 1)));
    }
};

/// Lets a piece reach over the points of a strip whose first row of pixels is `y0`.
HWY_INLINE void reach_over(const InkPiece& piece, int width_px, int y0, Strip& strip) {
    const Lanes d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const float reach = std::max(piece.half_px, piece.half_px + piece.half_more_px) + 0.36F;
    const auto top = static_cast<float>(y0);
    const Reach rows(piece.y - top, piece.dy, reach, 2 * kStripRows);
    const Reach columns(piece.x, piece.dx, reach, 2 * width_px);
    if (rows.first > rows.last || columns.first > columns.last) return;
    const int x0 = columns.first / 2, x1 = columns.last / 2;
    const std::uint64_t pixels = (~std::uint64_t{0} >> (63 - (x1 - x0))) << x0;
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0F);
    const auto along_x = hn::Set(d, piece.dx), along_y = hn::Set(d, piece.dy);
    for (int j = rows.first; j <= rows.last; ++j) {
        const auto at = static_cast<std::size_t>(j);
        strip.touched[at / 2] |= pixels;
        const float from_y = top + (static_cast<float>(j) + 0.5F) / 2 - piece.y;
        const auto y = hn::Set(d, from_y), y_along = hn::Set(d, from_y * piece.dy);
        for (int i = columns.first; i <= columns.last; i += lanes) {
            const auto points = hn::Add(hn::Iota(d, static_cast<float>(i)), hn::Set(d, 0.5F));
            const auto x = hn::Sub(hn::Mul(points, hn::Set(d, 0.5F)), hn::Set(d, piece.x));
            const auto along =
                hn::Mul(hn::Add(hn::Mul(x, along_x), y_along), hn::Set(d, piece.per_length2));
            const auto t = hn::Min(hn::Max(along, zero), one);
            const auto way_x = hn::Sub(x, hn::Mul(t, along_x));
            const auto way_y = hn::Sub(y, hn::Mul(t, along_y));
            const auto length = hn::Sqrt(hn::Add(hn::Mul(way_x, way_x), hn::Mul(way_y, way_y)));
            const auto half =
                hn::Add(hn::Set(d, piece.half_px), hn::Mul(t, hn::Set(d, piece.half_more_px)));
            const auto over = hn::Sub(half, length);
            float* const known = &strip.over[at][static_cast<std::size_t>(i)];
            const auto before = hn::LoadU(d, known);
            const auto is_further = hn::Gt(over, before);
            hn::StoreU(hn::IfThenElse(is_further, over, before), d, known);
            hn::BlendedStore(way_x, is_further, d, &strip.way_x[at][static_cast<std::size_t>(i)]);
            hn::BlendedStore(way_y, is_further, d, &strip.way_y[at][static_cast<std::size_t>(i)]);
        }
    }
}

/// The direction of a straight side of a stroke: of its normal the larger and the smaller
/// coordinate, without signs.
template <class V>
struct Slope {
    V larger, smaller;
};

/// The share of a unit square that lies on the near side of a straight line which passes its middle
/// at a distance of x, beyond it.
template <class D, class V>
HWY_INLINE V share_within(D d, const Slope<V>& slope, V x) {
    const auto half = hn::Set(d, 0.5F), one = hn::Set(d, 1.0F);
    const auto left = hn::Sub(hn::Mul(hn::Add(slope.larger, slope.smaller), half), hn::Abs(x));
    const auto corner = hn::Div(hn::Mul(left, left),
                                hn::Mul(hn::Mul(hn::Set(d, 2.0F), slope.larger), slope.smaller));
    const auto trapezium = hn::Div(hn::Sub(left, hn::Mul(slope.smaller, half)), slope.larger);
    auto less = hn::IfThenElse(hn::Lt(left, slope.smaller), corner, trapezium);
    less = hn::IfThenElseZero(hn::Gt(left, hn::Zero(d)), less);
    return hn::IfThenElse(hn::Gt(x, hn::Zero(d)), hn::Sub(one, less), less);
}

/// The share of each quarter that the pen covers, which reaches over its middle.
template <class D, class V>
HWY_INLINE V share(D d, V over, V way_x, V way_y) {
    const auto length = hn::Sqrt(hn::Add(hn::Mul(way_x, way_x), hn::Mul(way_y, way_y)));
    const auto x = hn::Abs(way_x), y = hn::Abs(way_y);
    const auto is_known = hn::Gt(length, hn::Set(d, 1e-6F));
    const auto per_length = hn::Div(hn::Set(d, 1.0F), length);
    const Slope<V> slope{
        hn::IfThenElse(is_known, hn::Mul(hn::Max(x, y), per_length), hn::Set(d, 1.0F)),
        hn::IfThenElseZero(is_known, hn::Mul(hn::Min(x, y), per_length))};
    const auto near_side = hn::Add(over, over);
    const auto width = hn::Mul(hn::Set(d, 4.0F), hn::Add(over, length));
    const auto far_side = hn::Sub(near_side, width);
    auto inside = share_within(d, slope, near_side);
    const auto is_reached = hn::Gt(over, hn::Set(d, -0.5F));
    // Of lines that are wide enough, none of the far side is seen.
    const auto is_narrow = hn::And(is_reached, hn::Gt(far_side, hn::Set(d, -0.75F)));
    if (!hn::AllFalse(d, is_narrow)) inside = hn::Sub(inside, share_within(d, slope, far_side));
    return hn::IfThenElseZero(is_reached, inside);
}

/// The ink of as many pixels as a vector has lanes, from point `i` of a pair of rows on.
template <class D>
HWY_INLINE auto ink_of(D d, const Strip& strip, std::size_t row, std::size_t i) {
    auto sum = hn::Zero(d);
    for (const std::size_t at : {2 * row, 2 * row + 1}) {
        auto over0 = sum, over1 = sum, x0 = sum, x1 = sum, y0 = sum, y1 = sum;
        hn::LoadInterleaved2(d, &strip.over[at][i], over0, over1);
        hn::LoadInterleaved2(d, &strip.way_x[at][i], x0, x1);
        hn::LoadInterleaved2(d, &strip.way_y[at][i], y0, y1);
        sum = hn::Add(sum, hn::Add(share(d, over0, x0, y0), share(d, over1, x1, y1)));
    }
    return hn::NearestInt(hn::Mul(sum, hn::Set(d, 255.0F / 4)));
}

HWY_INLINE void write_row(const Strip& strip, std::size_t row, int width_px, std::uint8_t* out) {
    const Lanes d;
    const hn::Rebind<std::uint8_t, Lanes> d_ink;
    const int lanes = static_cast<int>(hn::Lanes(d));
    std::array<std::uint8_t, 64 + 16> ink{};
    for (int x = 0; x < width_px; x += lanes) {
        const std::uint64_t own = strip.touched[row] >> x;
        if ((own & ((std::uint64_t{1} << lanes) - 1)) == 0) continue;
        const auto shares = ink_of(d, strip, row, 2 * static_cast<std::size_t>(x));
        hn::StoreU(hn::DemoteTo(d_ink, shares), d_ink, ink.data() + x);
    }
    std::memcpy(out, ink.data(), static_cast<std::size_t>(width_px));
}

void draw_in(std::span<const InkPiece> pieces, const InkTile& tile) {
    if (pieces.empty()) {
        for (int y = 0; y < tile.height_px; ++y)
            std::memset(tile.first + y * tile.stride, 0, static_cast<std::size_t>(tile.width_px));
        return;
    }
    // What it holds of ways is looked at where a piece reaches alone.
    static thread_local Strip strip{};
    for (int y0 = 0; y0 < tile.height_px; y0 += kStripRows) {
        strip.clear();
        for (const InkPiece& piece : pieces)
            reach_over(piece, tile.width_px, y0, strip);
        const int rows = std::min(kStripRows, tile.height_px - y0);
        for (int row = 0; row < rows; ++row)
            write_row(strip,
                      static_cast<std::size_t>(row),
                      tile.width_px,
                      tile.first + (y0 + row) * tile.stride);
    }
}

}  // namespace ink::methods::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::methods {
namespace {

HWY_EXPORT(draw_in);

}  // namespace

void draw_ink(std::span<const InkPiece> pieces, const InkTile& tile) {
    HWY_DYNAMIC_DISPATCH(draw_in)(pieces, tile);
}

}  // namespace ink::methods
#endif
