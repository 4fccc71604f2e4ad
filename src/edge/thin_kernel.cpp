#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/thin_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "edge/thin.h"

#ifndef INK_EDGE_THIN_BLOCKS
#define INK_EDGE_THIN_BLOCKS
namespace ink::edge {

using Bits = std::uint64_t;

/// Words that are looked at together.
inline constexpr std::size_t kBlock = 8;

/// The pixels of a block that go.
struct Doomed {
    std::size_t block;
    std::array<Bits, kBlock> bits;
};

}  // namespace ink::edge
#endif

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Neighbours of 64 pixels a word: the paper's x1..x8, counter-clockwise from the right-hand one.
template <class V>
struct Ring {
    V x1, x2, x3, x4, x5, x6, x7, x8;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Ring<V> ring_of(D d, const Bits* word, std::ptrdiff_t stride) {
    const auto at = [d](const Bits* from) HWY_ATTR { return hn::LoadU(d, from); };
    const auto right = [at](const Bits* from) HWY_ATTR {
        return hn::Or(hn::ShiftRight<1>(at(from)), hn::ShiftLeft<63>(at(from + 1)));
    };
    const auto left = [at](const Bits* from) HWY_ATTR {
        return hn::Or(hn::ShiftLeft<1>(at(from)), hn::ShiftRight<63>(at(from - 1)));
    };
    const Bits* up = word - stride;
    const Bits* down = word + stride;
    return {
        right(word), right(up), at(up), left(up), left(word), left(down), at(down), right(down)};
}

template <class V>
HWY_INLINE V is_one_of(V a, V b, V c, V d) {
    return hn::Or(hn::AndNot(hn::Or(c, d), hn::Xor(a, b)), hn::AndNot(hn::Or(a, b), hn::Xor(c, d)));
}

template <class V>
HWY_INLINE V are_two_of(V a, V b, V c, V d) {
    return hn::Or(hn::Or(hn::And(a, b), hn::And(c, d)), hn::And(hn::Or(a, b), hn::Or(c, d)));
}

/// G1, G2 and the subiteration's G3: which pixels with these neighbours may go?
template <class V>
HWY_INLINE V removable(const Ring<V>& r, bool is_second) {
    const V is_border = is_one_of(hn::AndNot(r.x1, hn::Or(r.x2, r.x3)),
                                  hn::AndNot(r.x3, hn::Or(r.x4, r.x5)),
                                  hn::AndNot(r.x5, hn::Or(r.x6, r.x7)),
                                  hn::AndNot(r.x7, hn::Or(r.x8, r.x1)));
    // Pairs of neighbours, begun at a side or at a corner: the lesser count must be 2 or 3.
    const V a0 = hn::Or(r.x1, r.x2), a1 = hn::Or(r.x3, r.x4);
    const V a2 = hn::Or(r.x5, r.x6), a3 = hn::Or(r.x7, r.x8);
    const V b0 = hn::Or(r.x2, r.x3), b1 = hn::Or(r.x4, r.x5);
    const V b2 = hn::Or(r.x6, r.x7), b3 = hn::Or(r.x8, r.x1);
    const V is_no_end = hn::And(are_two_of(a0, a1, a2, a3), are_two_of(b0, b1, b2, b3));
    const V is_within = hn::And(hn::And(hn::And(a0, a1), hn::And(a2, a3)),
                                hn::And(hn::And(b0, b1), hn::And(b2, b3)));
    // G3' is G3 turned by 180 degrees: may the pixel not go for its side's sake?
    const V free_side = is_second ? hn::AndNot(b2, r.x4) : hn::AndNot(b0, r.x8);
    const V keeps_side = hn::AndNot(free_side, is_second ? r.x5 : r.x1);
    return hn::AndNot(hn::Or(is_within, keeps_side), hn::And(is_border, is_no_end));
}

/// Writes the blocks of which something goes, and returns how many they are.
std::size_t find_doomed(const Bits* words,
                        std::ptrdiff_t stride,
                        std::span<const std::size_t> blocks,
                        bool is_second,
                        Doomed* out) {
    const hn::CappedTag<Bits, kBlock> d;
    std::size_t count = 0;
    for (const std::size_t block : blocks) {
        Doomed& here = out[count];
        here.block = block;
        auto any = hn::Zero(d);
        for (std::size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
            const Bits* at = words + block * kBlock + i;
            const auto bits =
                hn::And(hn::LoadU(d, at), removable(ring_of(d, at, stride), is_second));
            hn::StoreU(bits, d, here.bits.data() + i);
            any = hn::Or(any, bits);
        }
        if (!hn::AllTrue(d, hn::Eq(any, hn::Zero(d)))) ++count;
    }
    return count;
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {
namespace {

HWY_EXPORT(find_doomed);

/// A list of blocks to look at per subiteration.
///
/// A pixel that stayed can go later only after one of its neighbours went. So after each
/// subiteration has seen every block once, only blocks in which a pixel went and those round them
/// are looked at again: the same result as full passes, since each subiteration removes all its
/// pixels at once.
class Thinner {
  public:
    explicit Thinner(const BitMask& mask)
        : stride_(mask.stride()),
          words_(head() + mask.words().size() + head()),
          waits_(words_.size() / kBlock),
          doomed_(new Doomed[waits_.size()]) {
        std::copy(mask.words().begin(), mask.words().end(), words_.begin() + shift(head()));
        for (std::size_t block = 0; block < waits_.size(); ++block) {
            const Bits* at = words_.data() + block * kBlock;
            if (std::all_of(at, at + kBlock, [](Bits word) { return word == 0; })) continue;
            waits_[block] = 3;
            waiting_[0].push_back(block);
        }
        waiting_[1] = waiting_[0];
    }

    void run(BitMask& out) {
        bool has_changed = true;
        while (has_changed) {
            const bool first = subiterate(0);
            const bool second = subiterate(1);
            has_changed = first || second;
        }
        std::copy_n(words_.begin() + shift(head()), out.words().size(), out.words().begin());
    }

  private:
    /// Words that stay 0 before and behind the mask's, so that every block has neighbours, those
    /// of the mask's frame too.
    [[nodiscard]] std::size_t head() const { return stride_ + kBlock; }
    [[nodiscard]] static std::ptrdiff_t shift(std::size_t words) {
        return static_cast<std::ptrdiff_t>(words);
    }

    /// Returns whether any pixel went.
    bool subiterate(unsigned which) {
        looked_at_.swap(waiting_[which]);
        for (const std::size_t block : looked_at_)
            waits_[block] = static_cast<std::uint8_t>(waits_[block] & ~(1U << which));
        const std::size_t count = HWY_DYNAMIC_DISPATCH(find_doomed)(
            words_.data(), shift(stride_), looked_at_, which == 1, doomed_.get());
        looked_at_.clear();
        for (std::size_t i = 0; i < count; ++i) {
            const Doomed& doomed = doomed_[i];
            for (std::size_t word = 0; word < kBlock; ++word)
                words_[doomed.block * kBlock + word] &= ~doomed.bits[word];
            wake(doomed);
        }
        return count != 0;
    }

    /// Has all looked at again that may have lost a neighbour.
    void wake(const Doomed& doomed) {
        std::size_t first = 0;
        std::size_t last = kBlock - 1;
        while (doomed.bits[first] == 0)
            ++first;
        while (doomed.bits[last] == 0)
            --last;
        const std::size_t at = doomed.block * kBlock;
        const std::size_t left = at + first - (doomed.bits[first] & 1U);
        const std::size_t right = at + last + (doomed.bits[last] >> 63);
        wake(left - stride_, right - stride_);
        wake(left, right);
        wake(left + stride_, right + stride_);
    }

    /// The same of the words of one row.
    void wake(std::size_t left, std::size_t right) {
        for (std::size_t block = left / kBlock; block <= right / kBlock; ++block) {
            for (unsigned which = 0; which < 2; ++which)
                if ((waits_[block] >> which & 1U) == 0) waiting_[which].push_back(block);
            waits_[block] = 3;
        }
    }

    std::size_t stride_;
    std::vector<Bits> words_;
    std::vector<std::uint8_t> waits_;  ///< bit `which`: the block is in that list
    std::unique_ptr<Doomed[]> doomed_;
    std::array<std::vector<std::size_t>, 2> waiting_;
    std::vector<std::size_t> looked_at_;
};

}  // namespace

void thin(BitMask& mask) {
    Thinner(mask).run(mask);
}

Mask thin(const Mask& mask) {
    BitMask bits(mask);
    thin(bits);
    return bits.bytes();
}

}  // namespace ink::edge
#endif
