#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "score/pixel_list.h"

namespace ink::score {

/// Matches two sets of pixels one to one, and again after they changed, without a list of pairs.
///
/// Sets are masks with a bit a pixel. Who may be matched with whom is read off the bits round a
/// pixel: 64 pixels that have a partner at one offset are matched at once, and breadth-first
/// augmenting paths (Berge) find the rest, so the size is exact. A set that is replaced keeps the
/// pairs whose pixels stayed: the next matching begins there, and sets that differ in little cost
/// little.
class BitMatcher {
  public:
    /// The widest disk: the number of a place in it must fit in a byte.
    static constexpr int kMostRadius_px = 8;

    /// Of two empty sets, on an image of this size.
    BitMatcher(int width_px, int height_px, const Disk& disk);

    /// Replaces a set by the pixels of a list, or the words of an edge::BitMask, of the image's
    /// size.
    void set_left(const PixelList& pixels);
    void set_left(std::span<const std::uint64_t> words);
    void set_right(const PixelList& pixels);

    /// Pixels of a set.
    [[nodiscard]] std::int64_t left_size() const { return left_.size; }
    [[nodiscard]] std::int64_t right_size() const { return right_.size; }
    /// Makes the matching as large as it can be, and returns its size.
    [[nodiscard]] std::int64_t match();
    /// Pixels of one set that have one of the other in reach.
    [[nodiscard]] std::int64_t left_reached() const { return count_reached(left_, right_); }
    [[nodiscard]] std::int64_t right_reached() const { return count_reached(right_, left_); }

  private:
    using Bits = std::uint64_t;
    /// A pixel: the number of its bit in the words.
    using Place = std::uint32_t;

    /// 64 pixels in a row.
    struct Word {
        std::size_t at = 0;
        Bits bits = 0;
    };
    struct Side {
        std::vector<Bits> set;
        std::vector<std::size_t> words;        ///< those that hold any of it, in order
        std::int64_t size = 0;                 ///< pixels of it
        std::vector<Bits> free;                ///< those of them without a mate
        std::unique_ptr<std::uint8_t[]> mate;  ///< the offset to it, of those that have one
    };
    /// A row of the disk.
    struct Row {
        std::ptrdiff_t first = 0;  ///< from a pixel's place to the row's first
        Bits mask = 0;             ///< as many bits as the row has pixels
        std::uint8_t offset = 0;   ///< the number of the first pixel's offset
    };

    void take(std::span<const Bits> words);
    void take(const PixelList& pixels);
    void replace(Side& side, Side& other);
    void replace_word(Side& side, Side& other, const Word& word);
    void match_at_once();
    void augment(Side& from, Side& to);
    [[nodiscard]] bool search(Place root, const Side& to, Place& end);
    void flip(Place root, Place end, Side& from, Side& to);
    [[nodiscard]] std::int64_t count_reached(const Side& side, const Side& other) const;

    std::size_t stride_;
    std::size_t word_count_;
    std::size_t head_;  ///< words before those of a set, so that a row above the first is there
    std::vector<Row> rows_;
    std::vector<std::ptrdiff_t> steps_;      ///< of each offset, row by row: the last is -the first
    std::vector<std::uint8_t> by_distance_;  ///< the offsets, the nearest first
    Side left_;
    Side right_;
    std::int64_t size_ = 0;

    std::vector<Word> taken_;           ///< the set that comes, where there is any of it
    std::vector<std::size_t> waiting_;  ///< words with pixels that may be matched at once
    // The searches: who may still be reached (nobody between two), from which offset others were,
    // and in which order.
    std::vector<Bits> open_;
    std::unique_ptr<std::uint8_t[]> parent_;
    std::vector<Place> queue_;
    std::vector<Place> reached_;
};

/// What a maximum matching of two sets says; every number is unique.
struct MatchCounts {
    std::int64_t k = 0;             ///< pairs
    std::int64_t left_reached = 0;  ///< left pixels with a right pixel in reach
    std::int64_t right_reached = 0;
};

/// Matches two sets of pixels one to one within `disk`, which is one that a BitMatcher takes.
/// Symmetric: swapped sets give the same numbers.
[[nodiscard]] MatchCounts match_pixels(const PixelList& left,
                                       const PixelList& right,
                                       const Disk& disk);

/// Matches the drawn pixels of one image with one set of true pixels after the other: classes,
/// bins, kinds. What belongs to the image alone is made once.
class DrawnMatcher {
  public:
    DrawnMatcher(const PixelList& drawn, const Disk& disk);

    /// The size of a maximum one-to-one matching with `truth`, of the image's size:
    /// match_pixels().k.
    [[nodiscard]] std::int64_t match(const PixelList& truth);

  private:
    bool is_empty_;
    BitMatcher matcher_;
};

}  // namespace ink::score
