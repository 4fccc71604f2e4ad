#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/side_differences_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "edge/side_differences.h"
#include "edge/vector_loops.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The rule for vectors of sides, each between the middle two of four samples in line.
template <class D>
class Jumps {
  public:
    using V = hn::Vec<D>;

    explicit Jumps(const DepthJump& jump)
        : least_share_(hn::Set(D(), jump.least_share)),
          slack_(hn::Set(D(), jump.slack)),
          ratio_(hn::Set(D(), jump.ratio)) {}

    HWY_INLINE hn::Mask<D> operator()(V before, V a, V b, V after) const {
        const V j = hn::Sub(b, a), s0 = hn::Sub(a, before), s1 = hn::Sub(after, b);
        const V excess = hn::Max(hn::Sub(j, hn::Max(s0, s1)), hn::Sub(hn::Min(s0, s1), j));
        const V least = hn::Add(hn::Mul(hn::Max(a, b), least_share_), slack_);
        const V steepest = hn::Max(hn::Abs(s0), hn::Abs(s1));
        return hn::And(hn::Gt(excess, least), hn::Gt(hn::Abs(j), hn::Mul(steepest, ratio_)));
    }

  private:
    V least_share_, slack_, ratio_;
};

void jump_rows(const core::ImageView<const float>& q,
               const core::ImageView<std::uint8_t>& out,
               Sides sides,
               const DepthJump& jump) {
    constexpr int kLanes = HWY_LANES(float);
    const bool is_square = sides == Sides::square;
    // The slopes beside a jump are at most |j| / ratio, so that |j| itself is at least this part of
    // what is asked for. Less for rounding. Most squares have no such range.
    const float part = 0.999F * jump.ratio / (1 + jump.ratio);
    const float share = part * jump.least_share;
    const float slack = part * jump.slack;
    for (int y = 0; y < out.height_px; ++y) {
        const float* const above = q.row(y) - q.stride;
        const float* const upper = q.row(y);
        const float* const lower = upper + q.stride;
        const float* const below = lower + q.stride;
        std::uint8_t* to = out.row(y);
        cover<float, kLanes>(out.width_px, kLanes, [=](auto d, int x) HWY_ATTR {
            const auto a = hn::LoadU(d, upper + x), b = hn::LoadU(d, upper + x + 1);
            const auto c = hn::LoadU(d, lower + x), e = hn::LoadU(d, lower + x + 1);
            const auto least = hn::Min(hn::Min(a, b), hn::Min(c, e));
            const auto range = hn::Sub(hn::Max(hn::Max(a, b), hn::Max(c, e)), least);
            const auto enough = hn::Add(hn::Mul(least, hn::Set(d, share)), hn::Set(d, slack));
            if (hn::AllFalse(d, hn::Gt(range, enough))) return;
            const Jumps<decltype(d)> jumps(jump);
            const auto across = [&](const float* row) HWY_ATTR {
                return jumps(hn::LoadU(d, row + x - 1),
                             hn::LoadU(d, row + x),
                             hn::LoadU(d, row + x + 1),
                             hn::LoadU(d, row + x + 2));
            };
            const auto down = [&](int column) HWY_ATTR {
                return jumps(hn::LoadU(d, above + column),
                             hn::LoadU(d, upper + column),
                             hn::LoadU(d, lower + column),
                             hn::LoadU(d, below + column));
            };
            auto any = hn::Or(across(upper), down(x));
            if (is_square) any = hn::Or(any, hn::Or(across(lower), down(x + 1)));
            if (hn::AllFalse(d, any)) return;
            const hn::Rebind<std::uint8_t, decltype(d)> d_out;
            const hn::RebindToSigned<decltype(d)> d_whole;
            const auto full = hn::Set(d_whole, 255);
            const auto marks =
                hn::DemoteTo(d_out, hn::IfThenElseZero(hn::RebindMask(d_whole, any), full));
            hn::StoreU(hn::Or(marks, hn::LoadU(d_out, to + x)), d_out, to + x);
        });
    }
}

template <class V>
HWY_INLINE V difference(V a, V b) {
    return hn::Or(hn::SaturatedSub(a, b), hn::SaturatedSub(b, a));  // one of them is 0
}

/// The larger of the differences from `a` to its two neighbours.
template <class V>
HWY_INLINE V most_side(V a, V b, V c) {
    return hn::Max(difference(a, b), difference(a, c));
}

void side_rows(const core::ImageView<const std::uint8_t>& codes,
               const core::ImageView<std::uint8_t>& out,
               Sides sides,
               int gain_bits) {
    constexpr int kLanes = HWY_LANES(std::uint8_t);
    const bool is_square = sides == Sides::square;
    for (int y = 0; y < out.height_px; ++y) {
        const std::uint8_t* upper = codes.row(y);
        const std::uint8_t* lower = upper + codes.stride;
        std::uint8_t* to = out.row(y);
        cover<std::uint8_t, kLanes>(out.width_px, kLanes, [=](auto d, int x) HWY_ATTR {
            const auto a = hn::LoadU(d, upper + x);
            const auto b = hn::LoadU(d, upper + x + 1);
            const auto c = hn::LoadU(d, lower + x);
            auto most = most_side(a, b, c);
            if (is_square) most = hn::Max(most, most_side(hn::LoadU(d, lower + x + 1), b, c));
            for (int bit = 0; bit < gain_bits; ++bit)
                most = hn::SaturatedAdd(most, most);
            hn::StoreU(most, d, to + x);
        });
    }
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {

namespace {

HWY_EXPORT(jump_rows);

}  // namespace

void add_depth_jumps(const core::ImageView<const float>& q,
                     const core::ImageView<std::uint8_t>& out,
                     Sides sides,
                     const DepthJump& jump) {
    HWY_DYNAMIC_DISPATCH(jump_rows)(q, out, sides, jump);
}

namespace {

HWY_EXPORT(side_rows);

}  // namespace

void side_differences(const core::ImageView<const std::uint8_t>& codes,
                      const core::ImageView<std::uint8_t>& out,
                      Sides sides,
                      int gain_bits) {
    HWY_DYNAMIC_DISPATCH(side_rows)(codes, out, sides, gain_bits);
}

}  // namespace ink::edge
#endif
