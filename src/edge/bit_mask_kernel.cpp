#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge/bit_mask_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

#include "core/bits.h"
#include "edge/bit_mask.h"
#include "edge/row_bands.h"
#include "edge/vector_loops.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::edge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Sets the bits of the bytes that are not 0; the words are 0 before.
void pack_row(const std::uint8_t* row, int width, std::uint64_t* words) {
    const hn::ScalableTag<std::uint8_t> d;
    constexpr int kBitsOfByte = 8;
    const int lanes = static_cast<int>(hn::Lanes(d));
    auto* const bytes = reinterpret_cast<std::uint8_t*>(words);
    int x = 0;
    for (; lanes >= kBitsOfByte && x + lanes <= width; x += lanes) {
        const auto is_set = hn::Ne(hn::LoadU(d, row + x), hn::Zero(d));
        hn::StoreMaskBits(d, is_set, bytes + x / kBitsOfByte);
    }
    for (; x < width; ++x)
        words[x / 64] |= std::uint64_t{row[x] != 0} << (x % 64);
}

void threshold_row(const std::uint8_t* from, int at_least, std::uint8_t* to, int width) {
    cover_once<std::uint8_t, HWY_LANES(std::uint8_t)>(width, [=](auto d, int x) HWY_ATTR {
        const auto below = hn::Set(d, static_cast<std::uint8_t>(at_least - 1));
        const auto excess = hn::SaturatedSub(hn::LoadU(d, from + x), below);
        hn::StoreU(hn::Min(excess, hn::Set(d, 1)), d, to + x);
    });
}

void threshold_rows(const core::ImageView<const std::uint8_t>& edge_responses,
                    int at_least,
                    const core::ImageView<std::uint8_t>& mask) {
    for (int y = 0; y < mask.height_px; ++y)
        threshold_row(edge_responses.row(y), at_least, mask.row(y), mask.width_px);
}

}  // namespace ink::edge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::edge {

namespace {

HWY_EXPORT(pack_row);

/// Eight bits as eight bytes of 0 or 1.
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
        HWY_DYNAMIC_DISPATCH(pack_row)(mask.row(y), width_px_, &words_[word_of(0, y)]);
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

HWY_EXPORT(threshold_rows);

void threshold(const core::ImageView<const std::uint8_t>& edge_responses,
               int at_least,
               const core::ImageView<std::uint8_t>& mask,
               int threads) {
    assert(at_least >= 1 && at_least <= 255);
    const auto kernel = HWY_DYNAMIC_DISPATCH(threshold_rows);
    filter_row_bands(edge_responses, mask, threads, [&](const auto& from, const auto& to) {
        kernel(from, at_least, to);
    });
}

Mask threshold(const EdgeImage& image, int at_least) {
    Mask mask(image.width_px(), image.height_px());
    threshold(image.view(), at_least, mask.view());
    return mask;
}

}  // namespace ink::edge
#endif
