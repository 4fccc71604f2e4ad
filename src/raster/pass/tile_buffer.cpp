#include "raster/pass/tile_buffer.h"

#include <bit>
#include <cstring>
#include <utility>

#include "raster/mesh/lane_steps.h"

namespace ink::raster {
namespace {

/// Rows, and a vector more: one that starts at a row's last pixel ends in the next row's margin.
constexpr std::size_t kElements = static_cast<std::size_t>(kTileStride) * kTileRows + 16;

/// The bits of one sky element as the store has it.
std::uint32_t sky_bits(const PassFormat& format, const PassInput& input, std::size_t plane) {
    if (format.store == Store::f32) return std::bit_cast<std::uint32_t>(input.sky_f32[plane]);
    return input.sky_code[plane] & (~0U >> (32 - 8 * bytes_of(format.store)));
}

/// The first `count` bytes of a plane, in whole words.
void fill_words(AlignedArray<std::byte>& memory, std::size_t count, std::uint32_t word) {
    const auto byte = static_cast<int>(word & 0xffU);
    if (word == 0x01010101U * (word & 0xffU)) {  // nearly always: the library has wider stores
        std::memset(memory.data(), byte, count);
    } else {
        std::fill_n(reinterpret_cast<std::uint32_t*>(memory.data()), count / sizeof word, word);
    }
}

/// An element of `bytes` bytes, side by side as often as a word holds it.
std::uint32_t repeated(std::uint32_t element, std::size_t bytes) {
    if (bytes == 1) return element * 0x01010101U;
    return bytes == 2 ? element * 0x00010001U : element;
}

}  // namespace

TileBuffer::TileBuffer(const PassFormat& format, const PassInput& input, const TileGrid& grid)
    : format_(format), grid_(grid) {
    depth_.resize(kElements * sizeof(std::uint32_t));
    for (std::size_t plane = 0; plane < static_cast<std::size_t>(format.planes()); ++plane) {
        sky_[plane] = repeated(sky_bits(format, input, plane), drawn_bytes());
        planes_[plane].resize(kElements * element_bytes());
        if (is_narrowed()) wide_[plane].resize(kElements * sizeof(std::uint32_t));
    }
}

void TileBuffer::start(int tile) {
    own_ = grid_.own(tile);
    drawn_ = grid_.drawn(tile);
    if (is_clean_) return;
    // 0 is infinity in every depth format, float included.
    const auto clear = [this](Memory& memory, std::size_t bytes, std::uint32_t word) {
        fill_words(memory, kElements * bytes, word);
    };
    clear(depth_, sizeof(std::uint32_t), 0);
    for (int plane = 0; plane < format_.planes(); ++plane) {
        const std::uint32_t sky = sky_[static_cast<std::size_t>(plane)];
        clear(drawn_plane(plane), drawn_bytes(), sky);
    }
    is_clean_ = true;
}

void TileBuffer::exchange(TilePixels& other) {
    other.depth.resize(depth_.size());
    std::swap(depth_, other.depth);
    for (int plane = 0; plane < format_.planes(); ++plane) {
        Memory& pixels = other.planes[static_cast<std::size_t>(plane)];
        pixels.resize(drawn_plane(plane).size());
        std::swap(drawn_plane(plane), pixels);
    }
    touch();
}

void TileBuffer::resume(int tile, TilePixels& from) {
    own_ = grid_.own(tile);
    drawn_ = grid_.drawn(tile);
    exchange(from);
}

void TileBuffer::finish() {
    if (!is_narrowed() || (is_clean_ && shows_sky_)) return;
    shows_sky_ = is_clean_;
    // A tile of sky alone, too: what was drawn before is still there.
    for (std::size_t plane = 0; plane < static_cast<std::size_t>(format_.planes()); ++plane) {
        const auto* from = reinterpret_cast<const std::uint32_t*>(wide_[plane].data());
        if (format_.store == Store::u8) {
            narrow(from, kElements, reinterpret_cast<std::uint8_t*>(planes_[plane].data()));
        } else {
            narrow(from, kElements, reinterpret_cast<std::uint16_t*>(planes_[plane].data()));
        }
    }
}

void TileBuffer::extend_frame_of(Memory& memory, std::size_t bytes_per_element) const {
    std::byte* const bytes = memory.data();
    const auto pixel = [&](int x, int y) {
        return bytes + (offset(y) + x) * static_cast<std::ptrdiff_t>(bytes_per_element);
    };
    const int left = own_.x0 - grid_.halo_px;
    const int right = own_.x1 + grid_.halo_px;
    for (int y = drawn_.y0; y < drawn_.y1; ++y) {
        for (int x = left; x < drawn_.x0; ++x)
            std::memcpy(pixel(x, y), pixel(drawn_.x0, y), bytes_per_element);
        for (int x = drawn_.x1; x < right; ++x)
            std::memcpy(pixel(x, y), pixel(drawn_.x1 - 1, y), bytes_per_element);
    }
    const std::size_t row_bytes = static_cast<std::size_t>(right - left) * bytes_per_element;
    for (int y = own_.y0 - grid_.halo_px; y < drawn_.y0; ++y)
        std::memcpy(pixel(left, y), pixel(left, drawn_.y0), row_bytes);
    for (int y = drawn_.y1; y < own_.y1 + grid_.halo_px; ++y)
        std::memcpy(pixel(left, y), pixel(left, drawn_.y1 - 1), row_bytes);
}

void TileBuffer::extend_frame() {
    if (is_inner()) return;
    extend_frame_of(depth_, sizeof(std::uint32_t));
    for (std::size_t plane = 0; plane < static_cast<std::size_t>(format_.planes()); ++plane)
        extend_frame_of(planes_[plane], element_bytes());
}

Tile TileBuffer::view(bool is_empty) const {
    Tile tile;
    tile.x0_px = own_.x0;
    tile.y0_px = own_.y0;
    tile.width_px = own_.x1 - own_.x0;
    tile.height_px = own_.y1 - own_.y0;
    tile.halo_px = grid_.halo_px;
    tile.is_empty = is_empty;
    tile.stride = kTileStride;
    constexpr std::size_t kOrigin =
        static_cast<std::size_t>(kMaxHalo_px) * kTileStride + kTileMargin_px;
    for (std::size_t plane = 0; plane < static_cast<std::size_t>(format_.planes()); ++plane) {
        tile.planes[plane] = planes_[plane].data() + kOrigin * element_bytes();
    }
    tile.depth = depth_.data() + kOrigin * sizeof(std::uint32_t);
    return tile;
}

}  // namespace ink::raster
