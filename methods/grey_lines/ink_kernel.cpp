#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/grey_lines/ink_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "methods/grey_lines/ink.h"
#include "raster/pass/pass.h"

HWY_BEFORE_NAMESPACE();
namespace ink::methods::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A piece reaches over three pixels of a row or so, which is twelve points.
constexpr int kMostLanes = std::min<int>(8, HWY_LANES(float));
using Lanes = hn::CappedTag<float, kMostLanes>;

/// The middles of the quarters of pixels; those of a pixel follow each other, upper left, upper
/// right, lower left, lower right. A strip of so many rows of pixels stays in the nearest cache.
constexpr int kStripRows = 16;
constexpr int kQuarters = 4;
constexpr std::size_t kPoints = std::size_t{kQuarters} * raster::kTileSize_px;  ///< in a row

/// Where the points of a row are: from the left of the first pixel, and from above each.
struct RowPlaces {
    std::array<float, kPoints> x, y;

    constexpr RowPlaces() : x(), y() {
        for (std::size_t i = 0; i < kPoints; ++i) {
            x[i] = static_cast<float>(i / kQuarters) + (i % 2 == 0 ? 0.25F : 0.75F);
            y[i] = i % kQuarters < 2 ? 0.25F : 0.75F;
        }
    }
};
constexpr RowPlaces kPlaces;

/// The nearest line at each point of a strip: by how much the pen reaches over it, and the way from
/// there to the line's middle. Between strips none is known that reaches any.
struct Strip {
    static constexpr float kNone = -1;

    /// By vectors, of each the first number, then the others: apart, they would be as far from each
    /// other as a cache takes for the same place.
    std::array<float, 3 * kStripRows * kPoints> nearest;
    std::array<std::uint64_t, kStripRows> touched{};  ///< pixels, a bit each
    std::array<float, kPoints> shares{};              ///< of a row while it is written, else 0

    Strip() { nearest.fill(kNone); }
    /// Of a vector of points.
    [[nodiscard]] float* at(std::size_t row, std::size_t point) {
        return &nearest[3 * (row * kPoints + point)];
    }
};

/// Pixels from the first to the last of whose points a stroke may reach some which runs from `low`
/// to `high`.
struct Reach {
    int first, last;

    Reach(float low, float high, float reach, int pixels) {
        // Clamped before: what is far outside has no number of a pixel.
        const auto most = static_cast<float>(pixels);
        first = static_cast<int>(std::clamp(low - reach + 0.25F, 0.0F, most));
        last = static_cast<int>(std::clamp(high + reach + 0.75F, 0.0F, most)) - 1;
    }
};

/// Where a long piece that runs aslant is near a row of pixels.
struct Aslant {
    float slope, low_y, high_y;

    explicit Aslant(const InkPiece& piece)
        : slope(piece.dx / piece.dy),
          low_y(std::min(0.0F, piece.dy)),
          high_y(std::max(0.0F, piece.dy)) {}
    [[nodiscard]] static bool is(const InkPiece& piece) {
        constexpr float kShort_px = 1.5F;
        return std::abs(piece.dx) > kShort_px && std::abs(piece.dy) > kShort_px;
    }
    /// In a row that begins so far below its first end.
    [[nodiscard]] Reach columns(float x, float y, float reach, int pixels) const {
        const float from = x + slope * std::clamp(y - reach, low_y, high_y);
        const float to = x + slope * std::clamp(y + 1 + reach, low_y, high_y);
        return {std::min(from, to), std::max(from, to), reach, pixels};
    }
};

/// Lets a piece reach over the points of a strip of `height_px` rows of pixels from `y0` on.
HWY_INLINE void reach_over(
    const InkPiece& piece, int width_px, int y0, int height_px, Strip& strip) {
    const Lanes d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto top = static_cast<float>(y0);
    if (piece.y_high < top || piece.y_low > top + kStripRows) return;
    const float reach = std::max(piece.half_px, piece.half_px + piece.half_more_px) + kPenReach_px;
    const Reach rows(piece.y_low - top, piece.y_high - top, 0, height_px);
    const bool is_aslant = Aslant::is(piece);
    Reach columns(
        piece.x + std::min(0.0F, piece.dx), piece.x + std::max(0.0F, piece.dx), reach, width_px);
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0F);
    const auto along_x = hn::Set(d, piece.dx), along_y = hn::Set(d, piece.dy);
    for (int row = rows.first; row <= rows.last; ++row) {
        const float row_y = top + static_cast<float>(row);
        if (is_aslant) columns = Aslant(piece).columns(piece.x, row_y - piece.y, reach, width_px);
        if (columns.first > columns.last) continue;
        const auto at = static_cast<std::size_t>(row);
        strip.touched[at] |= (~std::uint64_t{0} >> (63 - (columns.last - columns.first)))
                             << columns.first;
        // Where vectors begin is the same for all pieces: what one has stored the next loads whole.
        const int end = kQuarters * (columns.last + 1);
        for (int i = (kQuarters * columns.first) & -lanes; i < end; i += lanes) {
            const float* const place_x = &kPlaces.x[static_cast<std::size_t>(i)];
            const float* const place_y = &kPlaces.y[static_cast<std::size_t>(i)];
            const auto x = hn::Sub(hn::LoadU(d, place_x), hn::Set(d, piece.x));
            const auto y =
                hn::Sub(hn::Add(hn::LoadU(d, place_y), hn::Set(d, row_y)), hn::Set(d, piece.y));
            const auto along = hn::Mul(hn::Add(hn::Mul(x, along_x), hn::Mul(y, along_y)),
                                       hn::Set(d, piece.per_length2));
            const auto t = hn::Min(hn::Max(along, zero), one);
            const auto way_x = hn::Sub(x, hn::Mul(t, along_x));
            const auto way_y = hn::Sub(y, hn::Mul(t, along_y));
            const auto length = hn::Sqrt(hn::Add(hn::Mul(way_x, way_x), hn::Mul(way_y, way_y)));
            const auto half =
                hn::Add(hn::Set(d, piece.half_px), hn::Mul(t, hn::Set(d, piece.half_more_px)));
            const auto over = hn::Sub(half, length);
            float* const nearest = strip.at(at, static_cast<std::size_t>(i));
            const auto before = hn::LoadU(d, nearest);
            const auto is_further = hn::Gt(over, before);
            const auto keep = [&](auto now, auto known, float* to) HWY_ATTR {
                hn::StoreU(hn::IfThenElse(is_further, now, known), d, to);
            };
            keep(over, before, nearest);
            keep(way_x, hn::LoadU(d, nearest + lanes), nearest + lanes);
            keep(way_y, hn::LoadU(d, nearest + 2 * lanes), nearest + 2 * lanes);
        }
    }
}

/// The direction of a straight side of a stroke: of a way across it the larger and the smaller
/// coordinate, without signs, its length, and what they are always asked for.
template <class V>
struct Slope {
    V larger, smaller, length, per_larger, per_corner;
};

/// The share of a unit square that lies on the near side of a straight line which passes its middle
/// at a distance of x, beyond it.
template <class D, class V>
HWY_INLINE V share_within(D d, const Slope<V>& slope, V x) {
    const auto half = hn::Set(d, 0.5F), one = hn::Set(d, 1.0F);
    // As long as the way is: of what that is a share, it is no matter.
    const auto left = hn::Sub(hn::Mul(hn::Add(slope.larger, slope.smaller), half),
                              hn::Mul(hn::Abs(x), slope.length));
    const auto corner = hn::Mul(hn::Mul(left, left), slope.per_corner);
    const auto trapezium = hn::Mul(hn::Sub(left, hn::Mul(slope.smaller, half)), slope.per_larger);
    auto less = hn::IfThenElse(hn::Lt(left, slope.smaller), corner, trapezium);
    less = hn::IfThenElseZero(hn::Gt(left, hn::Zero(d)), less);
    return hn::IfThenElse(hn::Gt(x, hn::Zero(d)), hn::Sub(one, less), less);
}

/// The share of each quarter that the pen covers, which reaches over its middle, or nearly.
template <class D, class V>
HWY_INLINE V share(D d, V over, V way_x, V way_y) {
    const auto one = hn::Set(d, 1.0F);
    const auto length = hn::Sqrt(hn::Add(hn::Mul(way_x, way_x), hn::Mul(way_y, way_y)));
    const auto x = hn::Abs(way_x), y = hn::Abs(way_y);
    const auto is_known = hn::Gt(length, hn::Set(d, 1e-6F));
    const auto larger = hn::IfThenElse(is_known, hn::Max(x, y), one);
    const auto smaller = hn::IfThenElseZero(is_known, hn::Min(x, y));
    const Slope<V> slope{larger,
                         smaller,
                         hn::IfThenElse(is_known, length, one),
                         hn::Div(one, larger),
                         hn::Div(hn::Set(d, 0.5F), hn::Mul(larger, smaller))};
    const auto near_side = hn::Add(over, over);
    const auto width = hn::Mul(hn::Set(d, 4.0F), hn::Add(over, length));
    const auto far_side = hn::Sub(near_side, width);
    const auto inside = share_within(d, slope, near_side);
    // Of lines that are wide enough, none of the far side is seen.
    if (hn::AllFalse(d, hn::Gt(far_side, hn::Set(d, -0.75F)))) return inside;
    return hn::Sub(inside, share_within(d, slope, far_side));
}

/// Finds the shares of the points of a row, of which nothing else is known any more.
HWY_INLINE void find_shares(Strip& strip, std::size_t row) {
    const Lanes d;
    const std::size_t lanes = hn::Lanes(d);
    const std::size_t pixels = std::max<std::size_t>(lanes / kQuarters, 1);
    const std::uint64_t own = (std::uint64_t{1} << pixels) - 1;
    for (std::uint64_t rest = strip.touched[row]; rest != 0;) {
        const std::size_t x = static_cast<std::size_t>(std::countr_zero(rest)) & ~(pixels - 1);
        rest &= ~(own << x);
        for (std::size_t i = kQuarters * x; i < kQuarters * (x + pixels); i += lanes) {
            float* const nearest = strip.at(row, i);
            const auto over = hn::LoadU(d, nearest);
            const auto is_reached = hn::Gt(over, hn::Set(d, -0.5F));
            if (hn::AllFalse(d, is_reached)) continue;
            const auto shares =
                share(d, over, hn::LoadU(d, nearest + lanes), hn::LoadU(d, nearest + 2 * lanes));
            hn::StoreU(hn::IfThenElseZero(is_reached, shares), d, &strip.shares[i]);
            hn::StoreU(hn::Set(d, Strip::kNone), d, nearest);
        }
    }
}

/// The ink of as many pixels as a vector has lanes, from their points on, whose shares it forgets.
template <class D>
HWY_INLINE auto ink_of(D d, float* shares) {
    auto upper_left = hn::Zero(d), upper_right = hn::Zero(d);
    auto lower_left = hn::Zero(d), lower_right = hn::Zero(d);
    hn::LoadInterleaved4(d, shares, upper_left, upper_right, lower_left, lower_right);
    std::fill_n(shares, kQuarters * hn::Lanes(d), 0.0F);
    const auto sum = hn::Add(hn::Add(upper_left, upper_right), hn::Add(lower_left, lower_right));
    return hn::NearestInt(hn::Mul(sum, hn::Set(d, 255.0F / 4)));
}

/// Writes a row of pixels, and forgets what was known of it.
HWY_INLINE void write_row(Strip& strip, std::size_t row, int width_px, std::uint8_t* out) {
    const Lanes d;
    const hn::Rebind<std::uint8_t, Lanes> d_ink;
    const int lanes = static_cast<int>(hn::Lanes(d));
    if (strip.touched[row] == 0) return;
    find_shares(strip, row);
    std::array<std::uint8_t, raster::kTileSize_px> ink{};
    for (int x = 0; x < width_px; x += lanes) {
        const std::uint64_t own = strip.touched[row] >> x;
        if ((own & ((std::uint64_t{1} << lanes) - 1)) == 0) continue;
        const auto inks = ink_of(d, &strip.shares[kQuarters * static_cast<std::size_t>(x)]);
        hn::StoreU(hn::DemoteTo(d_ink, inks), d_ink, ink.data() + x);
    }
    std::memcpy(out, ink.data(), static_cast<std::size_t>(width_px));
    strip.touched[row] = 0;
}

/// Apart, or its place is asked for in each row of each piece.
HWY_NOINLINE Strip& own_strip() {
    static thread_local Strip strip;
    return strip;
}

void draw_in(std::span<const InkPiece> pieces, const InkTile& tile) {
    Strip& strip = own_strip();
    for (int y0 = 0; y0 < tile.height_px; y0 += kStripRows) {
        const int rows = std::min(kStripRows, tile.height_px - y0);
        for (const InkPiece& piece : pieces)
            reach_over(piece, tile.width_px, y0, rows, strip);
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
