#include "score/matching.h"

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

/// Calls `visit(i)` for each word that is not 0, in order.
template <class Visit>
void visit_words(std::span<const Bits> words, Visit visit) {
    constexpr std::size_t kBlock = 8;  // most of them are empty
    for (std::size_t begin = 0; begin < words.size(); begin += kBlock) {
        const std::size_t end = std::min(words.size(), begin + kBlock);
        Bits any = 0;
        for (std::size_t i = begin; i < end; ++i)
            any |= words[i];
        if (any == 0) continue;
        for (std::size_t i = begin; i < end; ++i)
            if (words[i] != 0) visit(i);
    }
}

}  // namespace

MatchCounts match_pixels(const PixelList& left, const PixelList& right, const Disk& disk) {
    if (left.is_empty() || right.is_empty()) return {};
    BitMatcher matcher(left.width_px(), left.height_px(), disk);
    matcher.set_left(left);
    matcher.set_right(right);
    return {.k = matcher.match(),
            .left_reached = matcher.left_reached(),
            .right_reached = matcher.right_reached()};
}

DrawnMatcher::DrawnMatcher(const PixelList& drawn, const Disk& disk)
    : is_empty_(drawn.is_empty()), matcher_(drawn.width_px(), drawn.height_px(), disk) {
    matcher_.set_right(drawn);
}

std::int64_t DrawnMatcher::match(const PixelList& truth) {
    if (truth.is_empty() || is_empty_) return 0;
    matcher_.set_left(truth);
    return matcher_.match();
}

BitMatcher::BitMatcher(int width_px, int height_px, const Disk& disk)
    : stride_(static_cast<std::size_t>(width_px + 63) / 64 + 2),
      word_count_(stride_ * static_cast<std::size_t>(height_px + 2)) {
    assert(disk.radius_px() <= kMostRadius_px);
    const int radius = disk.radius_px();
    head_ = stride_ * static_cast<std::size_t>(std::max(radius, 1));
    const std::size_t all = word_count_ + 2 * head_;
    std::vector<int> square_distances;
    for (int dy = -radius; dy <= radius; ++dy) {
        const int half = disk.half_width_px(dy);
        const std::ptrdiff_t first = kBits * static_cast<std::ptrdiff_t>(stride_) * dy - half;
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
    open_.assign(all, 0);
    parent_.reset(new std::uint8_t[all * kBits]);
}

void BitMatcher::set_left(std::span<const Bits> words) {
    take(words);
    replace(left_, right_);
}

void BitMatcher::set_left(const PixelList& pixels) {
    take(pixels);
    replace(left_, right_);
}

void BitMatcher::set_right(const PixelList& pixels) {
    take(pixels);
    replace(right_, left_);
}

void BitMatcher::take(std::span<const Bits> words) {
    assert(words.size() == word_count_);
    taken_.clear();
    visit_words(words, [&](std::size_t i) { taken_.push_back({head_ + i, words[i]}); });
}

void BitMatcher::take(const PixelList& pixels) {
    taken_.clear();
    for (int y = 0; y < pixels.height_px(); ++y) {
        const std::size_t row = head_ + static_cast<std::size_t>(y + 1) * stride_ + 1;
        for (std::size_t i = pixels.row_begin(y); i < pixels.row_begin(y + 1); ++i) {
            const int x = pixels.x(i);
            const std::size_t at = row + static_cast<std::size_t>(x) / kBits;
            if (taken_.empty() || taken_.back().at != at) taken_.push_back({at, 0});
            taken_.back().bits |= Bits{1} << (x % kBits);
        }
    }
}

void BitMatcher::replace(Side& side, Side& other) {
    auto before = side.words.begin();
    for (const Word& word : taken_) {
        for (; before != side.words.end() && *before < word.at; ++before)
            replace_word(side, other, {*before, 0});
        if (before != side.words.end() && *before == word.at) ++before;
        replace_word(side, other, word);
    }
    for (; before != side.words.end(); ++before)
        replace_word(side, other, {*before, 0});
    side.words.clear();
    for (const Word& word : taken_)
        side.words.push_back(word.at);
}

void BitMatcher::replace_word(Side& side, Side& other, const Word& word) {
    const std::size_t at = word.at;
    const Bits bits = word.bits;
    const Bits before = side.set[at];
    if (before == bits) return;
    visit_bits(before & ~bits & ~side.free[at], [&](int bit) {
        const auto place = static_cast<std::ptrdiff_t>(at) * kBits + bit;
        score::set(other.free, static_cast<Place>(place + steps_[side.mate[place]]));
        --size_;
    });
    side.size += core::count_ones(bits) - core::count_ones(before);
    side.free[at] = (side.free[at] & bits) | (bits & ~before);
    side.set[at] = bits;
}

/// At one offset each pixel has one partner, so that all of them go together.
void BitMatcher::match_at_once() {
    waiting_ = left_.words;
    const auto last = static_cast<std::uint8_t>(steps_.size() - 1);
    for (const std::uint8_t offset : by_distance_) {
        std::erase_if(waiting_, [&](std::size_t i) { return left_.free[i] == 0; });
        for (const std::size_t i : waiting_) {
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
    for (const std::size_t i : to.words)
        open_[i] = to.set[i];
    for (const std::size_t i : from.words) {
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
    for (const std::size_t i : to.words)
        open_[i] = 0;
}

std::int64_t BitMatcher::match() {
    match_at_once();
    if (size_ == std::min(left_.size, right_.size)) return size_;
    // No augmenting path is left when none begins at any free pixel of one side, whichever.
    if (left_.size <= right_.size) {
        augment(left_, right_);
    } else {
        augment(right_, left_);
    }
    return size_;
}

std::int64_t BitMatcher::count_reached(const Side& side, const Side& other) const {
    std::int64_t reached = 0;
    for (const std::size_t i : side.words) {
        const Bits wanted = side.set[i];
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
