#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "edge/edge_image.h"

namespace ink::edge {

/// A mask with a bit a pixel: what takes 64 pixels a word at once.
///
/// Words hold pixels of one row, the leftmost in the lowest bit; a frame of words that stay 0 lies
/// round them, so that every pixel has eight neighbours.
class BitMask {
  public:
    BitMask() = default;
    BitMask(int width_px, int height_px);
    /// `mask` holds 0 or 1.
    explicit BitMask(const Mask& mask);

    [[nodiscard]] int width_px() const { return width_px_; }
    [[nodiscard]] int height_px() const { return height_px_; }

    [[nodiscard]] bool is_set(int x, int y) const {
        return (words_[word_of(x, y)] >> (x % 64) & 1U) != 0;
    }
    void set(int x, int y) { words_[word_of(x, y)] |= std::uint64_t{1} << (x % 64); }
    void clear(int x, int y) { words_[word_of(x, y)] &= ~(std::uint64_t{1} << (x % 64)); }
    /// How many pixels are set.
    [[nodiscard]] std::int64_t count() const;
    /// The same as 0 or 1 a pixel.
    [[nodiscard]] Mask bytes() const;

    /// Calls `visit(x)` for each pixel of row `y` that is set, from left to right.
    template <class Visit>
    void visit_row(int y, Visit visit) const {
        const std::uint64_t* row = words_.data() + word_of(0, y);
        const int count = static_cast<int>(stride_) - 2;
        for (int i = 0; i < count; ++i) {
            for (std::uint64_t left = row[i]; left != 0; left &= left - 1)
                visit(64 * i + std::countr_zero(left));
        }
    }

    /// All words, the frame's included, row by row; stride() from one row to the next.
    [[nodiscard]] std::vector<std::uint64_t>& words() { return words_; }
    [[nodiscard]] const std::vector<std::uint64_t>& words() const { return words_; }
    [[nodiscard]] std::size_t stride() const { return stride_; }

  private:
    [[nodiscard]] std::size_t word_of(int x, int y) const {
        assert(x >= 0 && x <= width_px_ && y >= 0 && y < height_px_);
        return static_cast<std::size_t>(y + 1) * stride_ + 1 + static_cast<std::size_t>(x) / 64;
    }

    int width_px_ = 0;
    int height_px_ = 0;
    std::size_t stride_ = 2;
    std::vector<std::uint64_t> words_;
};

/// The pixels drawn at least as strongly as `at_least` (1..255): edge response >= at_least.
///
/// Same size as `image`; an empty image gives an empty mask. Another range is a caller's bug: 0
/// would call the bare background a line.
[[nodiscard]] Mask threshold(const EdgeImage& image, int at_least);

/// The same into a mask of the same size, rows shared among `threads`. May be done in place.
void threshold(const core::ImageView<const std::uint8_t>& edge_responses,
               int at_least,
               const core::ImageView<std::uint8_t>& mask,
               int threads = 1);

}  // namespace ink::edge
