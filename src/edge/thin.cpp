#include "edge/thin.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ink::edge {
namespace {

using Bits = std::uint64_t;

/// Neighbours of 64 pixels at once: the paper's x1..x8, counter-clockwise from the right-hand one.
struct Ring {
    Bits x1, x2, x3, x4, x5, x6, x7, x8;
};

Ring ring_of(const Bits* word, std::ptrdiff_t stride) {
    const auto right = [](const Bits* at) { return at[0] >> 1 | at[1] << 63; };
    const auto left = [](const Bits* at) { return at[0] << 1 | at[-1] >> 63; };
    const Bits* up = word - stride;
    const Bits* down = word + stride;
    return {right(word), right(up), up[0], left(up), left(word), left(down), down[0], right(down)};
}

Bits is_one_of(Bits a, Bits b, Bits c, Bits d) {
    return ((a ^ b) & ~(c | d)) | (~(a | b) & (c ^ d));
}

Bits are_two_of(Bits a, Bits b, Bits c, Bits d) {
    return (a & b) | (c & d) | ((a | b) & (c | d));
}

/// G1, G2 and the subiteration's G3: which pixels with these neighbours may go?
Bits removable(const Ring& r, bool is_second) {
    const Bits is_border = is_one_of(
        ~r.x1 & (r.x2 | r.x3), ~r.x3 & (r.x4 | r.x5), ~r.x5 & (r.x6 | r.x7), ~r.x7 & (r.x8 | r.x1));
    // Pairs of neighbours, begun at a side or at a corner: the lesser count must be 2 or 3.
    const std::array<Bits, 4> a = {r.x1 | r.x2, r.x3 | r.x4, r.x5 | r.x6, r.x7 | r.x8};
    const std::array<Bits, 4> b = {r.x2 | r.x3, r.x4 | r.x5, r.x6 | r.x7, r.x8 | r.x1};
    const Bits is_no_end = are_two_of(a[0], a[1], a[2], a[3]) & are_two_of(b[0], b[1], b[2], b[3]);
    const Bits is_within = a[0] & a[1] & a[2] & a[3] & b[0] & b[1] & b[2] & b[3];
    // G3' is G3 turned by 180 degrees.
    const Bits keeps_side = is_second ? (r.x6 | r.x7 | ~r.x4) & r.x5 : (r.x2 | r.x3 | ~r.x8) & r.x1;
    return is_border & is_no_end & ~is_within & ~keeps_side;
}

/// A list of words to look at per subiteration.
///
/// A pixel that stayed can go later only after one of its neighbours went. So after each
/// subiteration has seen every word once, only words in which a pixel went and those round them are
/// looked at again: the same result as full passes, since each subiteration removes all its pixels
/// at once.
class Thinner {
  public:
    explicit Thinner(BitMask& mask)
        : words_(mask.words()),
          stride_(static_cast<std::ptrdiff_t>(mask.stride())),
          waits_(words_.size()) {
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (words_[i] == 0) continue;
            waits_[i] = 3;
            waiting_[0].push_back(i);
        }
        waiting_[1] = waiting_[0];
    }

    void run() {
        bool has_changed = true;
        while (has_changed) {
            const bool first = subiterate(0);
            const bool second = subiterate(1);
            has_changed = first || second;
        }
    }

  private:
    struct Doomed {
        std::size_t word;
        Bits bits;
    };

    /// Returns whether any pixel went.
    bool subiterate(unsigned which) {
        looked_at_.swap(waiting_[which]);
        doomed_.clear();
        for (const std::size_t i : looked_at_) {
            waits_[i] = static_cast<std::uint8_t>(waits_[i] & ~(1U << which));
            const Bits bits =
                words_[i] & removable(ring_of(words_.data() + i, stride_), which == 1);
            if (bits != 0) doomed_.push_back({i, bits});
        }
        looked_at_.clear();
        for (const Doomed& d : doomed_) {
            words_[d.word] &= ~d.bits;
            wake(d);
        }
        return !doomed_.empty();
    }

    /// Has all looked at again that may have lost a neighbour.
    void wake(const Doomed& d) {
        const auto at = static_cast<std::ptrdiff_t>(d.word);
        const std::ptrdiff_t first = (d.bits & 1U) != 0 ? -1 : 0;
        const std::ptrdiff_t last = d.bits >> 63 != 0 ? 1 : 0;
        for (std::ptrdiff_t row = at - stride_; row <= at + stride_; row += stride_) {
            for (std::ptrdiff_t i = row + first; i <= row + last; ++i) {
                const auto word = static_cast<std::size_t>(i);
                if (words_[word] == 0) continue;
                for (unsigned which = 0; which < 2; ++which) {
                    if ((waits_[word] >> which & 1U) == 0) waiting_[which].push_back(word);
                }
                waits_[word] = 3;
            }
        }
    }

    std::vector<Bits>& words_;
    std::ptrdiff_t stride_;
    std::vector<std::uint8_t> waits_;  ///< bit `which`: the word is in that list
    std::array<std::vector<std::size_t>, 2> waiting_;
    std::vector<std::size_t> looked_at_;
    std::vector<Doomed> doomed_;
};

}  // namespace

void thin(BitMask& mask) {
    Thinner(mask).run();
}

Mask thin(const Mask& mask) {
    BitMask bits(mask);
    thin(bits);
    return bits.bytes();
}

}  // namespace ink::edge
