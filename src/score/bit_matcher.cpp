#include "score/bit_matcher.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <numeric>

#include "core/bits.h"

namespace ink::score {
namespace {

using Bits = std::uint64_t;

constexpr std::ptrdiff_t kBits = 64;

/// The 64 bits from bit `place` on.
Bits bits_at(const Bits* words, std::ptrdiff_t place) {
    const Bits* word = words + (place >> 6);
    const auto shift = static_cast<unsigned>(place & 63);
    return shift == 0 ? *word : *word >> shift | word[1] << (64 - shift);
}

/// Takes `bits` out of the 64 from bit `place` on.
void clear_at(Bits* words, std::ptrdiff_t place, Bits bits) {
    Bits* word = words + (place >> 6);
    const auto shift = static_cast<unsigned>(place & 63);
    *word &= ~(bits << shift);
    if (shift != 0) word[1] &= ~(bits >> (64 - shift));
}

bool has(const std::vector<Bits>& words, std::uint32_t place) {
    return (words[place / 64] >> (place % 64) & 1U) != 0;
}
void set(std::vector<Bits>& words, std::uint32_t place) {
    words[place / 64] |= Bits{1} << (place % 64);
}
void clear(std::vector<Bits>& words, std::uint32_t place) {
    words[place / 64] &= ~(Bits{1} << (place % 64));
}

template <class Visit>
void visit_bits(Bits bits, Visit visit) {
    for (; bits != 0; bits &= bits - 1)
        visit(std::countr_zero(bits));
}

std::size_t stride_of(int width_px) {
    return static_cast<std::size_t>(width_px + 63) / 64 + 2;
}

}  // namespace

BitMatcher::BitMatcher(int width_px, int height_px, const Disk& disk) {
    assert(disk.radius_px() <= kMostRadius_px);
    const std::size_t stride = stride_of(width_px);
    const int radius = disk.radius_px();
    word_count_ = stride * static_cast<std::size_t>(height_px + 2);
    head_ = stride * static_cast<std::size_t>(std::max(radius, 1));
    const std::size_t all = word_count_ + 2 * head_;
    std::vector<int> square_distances;
    for (int dy = -radius; dy <= radius; ++dy) {
        const int half = disk.half_width_px(dy);
        const std::ptrdiff_t first = kBits * static_cast<std::ptrdiff_t>(stride) * dy - half;
        rows_.push_back(
            {first, (Bits{2} << (2 * half)) - 1, static_cast<std::uint8_t>(steps_.size())});
        for (int dx = -half; dx <= half; ++dx) {
            steps_.push_back(first + half + dx);
            square_distances.push_back(dx * dx + dy * dy);
        }
    }
    by_distance_.resize(steps_.size());
    std::iota(by_distance_.begin(), by_distance_.end(), std::uint8_t{0});
    std::stable_sort(by_distance_.begin(), by_distance_.end(), [&](std::uint8_t a, std::uint8_t b) {
        return square_distances[a] < square_distances[b];
    });
    for (Side* side : {&left_, &right_}) {
        side->set.assign(all, 0);
        side->free.assign(all, 0);
        // Read only where a pixel has a mate: what is there before does not matter.
        side->mate.reset(new std::uint8_t[all * kBits]);
    }
    parent_.reset(new std::uint8_t[all * kBits]);
}

void BitMatcher::replace(Side& side, Side& other, std::span<const Bits> words) {
    assert(words.size() == word_count_);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::size_t at = head_ + i;
        const Bits before = side.set[at];
        if (before == words[i]) continue;
        visit_bits(before & ~words[i] & ~side.free[at], [&](int bit) {
            const auto place = static_cast<std::ptrdiff_t>(at) * kBits + bit;
            score::set(other.free, static_cast<Place>(place + steps_[side.mate[place]]));
            --size_;
        });
        side.free[at] = (side.free[at] & words[i]) | (words[i] & ~before);
        side.set[at] = words[i];
    }
}

/// At one offset each pixel has one partner, so that all of them go together.
void BitMatcher::match_at_once() {
    std::vector<std::size_t> waiting;
    for (std::size_t i = head_; i < head_ + word_count_; ++i)
        if (left_.free[i] != 0) waiting.push_back(i);
    const auto last = static_cast<std::uint8_t>(steps_.size() - 1);
    for (const std::uint8_t offset : by_distance_) {
        std::erase_if(waiting, [&](std::size_t i) { return left_.free[i] == 0; });
        for (const std::size_t i : waiting) {
            const auto place = static_cast<std::ptrdiff_t>(i) * kBits;
            const Bits pairs = left_.free[i] & bits_at(right_.free.data(), place + steps_[offset]);
            if (pairs == 0) continue;
            left_.free[i] &= ~pairs;
            clear_at(right_.free.data(), place + steps_[offset], pairs);
            visit_bits(pairs, [&](int bit) {
                ++size_;
                left_.mate[place + bit] = offset;
                right_.mate[place + bit + steps_[offset]] =
                    static_cast<std::uint8_t>(last - offset);
            });
        }
    }
}

/// Breadth first from a free pixel to a free one of the other side, along alternating pairs.
///
/// Those of the other side that a failed search reached stay closed for good: no later augmenting
/// path leads through them.
bool BitMatcher::search(Place root, const Side& to, Place& end) {
    queue_.assign(1, root);
    reached_.clear();
    for (std::size_t head = 0; head < queue_.size(); ++head) {
        const auto at = static_cast<std::ptrdiff_t>(queue_[head]);
        for (const Row& row : rows_) {
            const std::ptrdiff_t first = at + row.first;
            Bits found = bits_at(open_.data(), first) & row.mask;
            for (; found != 0; found &= found - 1) {
                const int bit = std::countr_zero(found);
                const auto other = static_cast<Place>(first + bit);
                clear(open_, other);
                reached_.push_back(other);
                parent_[other] = static_cast<std::uint8_t>(row.offset + bit);
                if (has(to.free, other)) {
                    end = other;
                    return true;
                }
                queue_.push_back(static_cast<Place>(static_cast<std::ptrdiff_t>(other) +
                                                    steps_[to.mate[other]]));
            }
        }
    }
    return false;
}

/// Swaps matched and unmatched pairs on the path from `root` to `end`.
void BitMatcher::flip(Place root, Place end, Side& from, Side& to) {
    const auto last = static_cast<std::uint8_t>(steps_.size() - 1);
    clear(from.free, root);
    clear(to.free, end);
    for (Place other = end;;) {
        const std::uint8_t offset = parent_[other];
        const auto at = static_cast<Place>(static_cast<std::ptrdiff_t>(other) - steps_[offset]);
        const std::uint8_t before = from.mate[at];
        from.mate[at] = offset;
        to.mate[other] = static_cast<std::uint8_t>(last - offset);
        if (at == root) return;
        other = static_cast<Place>(static_cast<std::ptrdiff_t>(at) + steps_[before]);
    }
}

void BitMatcher::augment(Side& from, Side& to) {
    open_ = to.set;
    for (std::size_t i = head_; i < head_ + word_count_; ++i) {
        visit_bits(from.free[i], [&](int bit) {
            const auto root = static_cast<Place>(i * kBits + static_cast<std::size_t>(bit));
            Place end = 0;
            if (!search(root, to, end)) return;
            for (const Place place : reached_)
                score::set(open_, place);
            flip(root, end, from, to);
            ++size_;
        });
    }
}

std::int64_t BitMatcher::match() {
    match_at_once();
    // No augmenting path is left when none begins at any free pixel of one side, whichever.
    if (core::count_ones(left_.free) <= core::count_ones(right_.free)) {
        augment(left_, right_);
    } else {
        augment(right_, left_);
    }
    return size_;
}

std::int64_t BitMatcher::count_reached(const Side& side, const Side& other) const {
    std::int64_t reached = 0;
    for (std::size_t i = head_; i < head_ + word_count_; ++i) {
        const Bits wanted = side.set[i];
        if (wanted == 0) continue;
        Bits found = 0;
        for (const std::uint8_t offset : by_distance_) {
            found |=
                bits_at(other.set.data(), static_cast<std::ptrdiff_t>(i) * kBits + steps_[offset]);
            if ((wanted & ~found) == 0) break;
        }
        reached += core::count_ones(wanted & found);
    }
    return reached;
}

}  // namespace ink::score
