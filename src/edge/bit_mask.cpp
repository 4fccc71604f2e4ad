#include "edge/bit_mask.h"

#include <algorithm>
#include <cstring>

#include "core/bits.h"

namespace ink::edge {
namespace {

/// Eight bytes of 0 or 1 as eight bits: each product that falls into the top byte is of another
/// pair of bits, so that nothing is carried.
std::uint64_t bits_of(std::uint64_t bytes) {
    return (bytes * 0x0102040810204080U) >> 56;
}

/// And back.
std::uint64_t bytes_of(std::uint64_t bits) {
    const std::uint64_t spread = (bits * 0x0101010101010101U) & 0x8040201008040201U;
    return ((spread + 0x7f7f7f7f7f7f7f7fU) >> 7) & 0x0101010101010101U;
}

static_assert(std::endian::native == std::endian::little);

}  // namespace

BitMask::BitMask(int width_px, int height_px)
    : width_px_(width_px),
      height_px_(height_px),
      stride_(static_cast<std::size_t>(width_px + 63) / 64 + 2),
      words_(stride_ * static_cast<std::size_t>(height_px + 2)) {}

BitMask::BitMask(const Mask& mask) : BitMask(mask.width_px(), mask.height_px()) {
    for (int y = 0; y < height_px_; ++y) {
        const std::uint8_t* row = mask.row(y);
        for (int x = 0; x < width_px_; x += 8) {
            std::uint64_t bytes = 0;
            std::memcpy(&bytes, row + x, static_cast<std::size_t>(std::min(8, width_px_ - x)));
            if (bytes != 0) words_[word_of(x, y)] |= bits_of(bytes) << (x % 64);
        }
    }
}

std::int64_t BitMask::count() const {
    return core::count_ones(words_);
}

Mask BitMask::bytes() const {
    Mask mask(width_px_, height_px_);
    for (int y = 0; y < height_px_; ++y) {
        std::uint8_t* row = mask.row(y);
        for (int x = 0; x < width_px_; x += 64) {
            std::uint64_t bits = words_[word_of(x, y)];
            for (int at = x; bits != 0; at += 8, bits >>= 8) {
                const std::uint64_t bytes = bytes_of(bits & 0xffU);
                std::memcpy(
                    row + at, &bytes, static_cast<std::size_t>(std::min(8, width_px_ - at)));
            }
        }
    }
    return mask;
}

}  // namespace ink::edge
