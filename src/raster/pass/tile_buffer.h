#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "raster/pass/aligned_array.h"
#include "raster/pass/bin.h"
#include "raster/pass/pass.h"

namespace ink::raster {

/// Columns on either side of a tile's own: its halo, rounded up to a vector of pixels, so that
/// vectors that start at multiples of 8 px start at aligned addresses and never leave the row.
inline constexpr int kTileMargin_px = 8;

/// Elements from one row of a tile buffer to the next, the same in every plane.
inline constexpr int kTileStride = kTileSize_px + 2 * kTileMargin_px;
inline constexpr int kTileRows = kTileSize_px + 2 * kMaxHalo_px;

/// The pixels of a tile that is put aside half drawn, as bytes aligned for any vector.
struct TilePixels {
    AlignedArray<std::byte> depth;
    std::array<AlignedArray<std::byte>, kMaxPlanes> planes;
};

/// The pixels of one tile and its halo while it is drawn. One per thread, used for tile after tile.
class TileBuffer {
  public:
    TileBuffer(const PassFormat& format, const PassInput& input, const TileGrid& grid);

    /// Makes it the buffer of `tile`, holding nothing but sky. What nobody wrote to since it was
    /// last cleared is not cleared again.
    void start(int tile);
    /// Says that something is about to be written: start() clears no other tile, finish() narrows
    /// none.
    void touch() { is_clean_ = false; }
    /// Puts the tile aside as it is, for resume().
    void put_aside(TilePixels& to) { exchange(to); }
    /// Goes on with a tile that was put aside; what it was in is scratch then.
    void resume(int tile, TilePixels& from);
    /// Copies the image's outermost pixels to the halo pixels beyond the frame.
    void extend_frame();
    /// How a sink sees it.
    [[nodiscard]] Tile view(bool is_empty) const;

    /// The tile's own pixels, and those to rasterize, in the image's coordinates.
    [[nodiscard]] const PixelRect& own() const { return own_; }
    [[nodiscard]] const PixelRect& drawn() const { return drawn_; }

    /// Whether the image goes on beyond the tile on every side, halo included.
    [[nodiscard]] bool is_inner() const {
        const int halo = grid_.halo_px;
        return drawn_.x0 == own_.x0 - halo && drawn_.x1 == own_.x1 + halo &&
               drawn_.y0 == own_.y0 - halo && drawn_.y1 == own_.y1 + halo;
    }

    /// Row `y` such that [x] is a pixel, x and y in the image's coordinates and drawn(). T is
    /// float or uint32 for depth.
    template <class T>
    [[nodiscard]] T* depth_row(int y) {
        return reinterpret_cast<T*>(depth_.data()) + offset(y);
    }
    /// The same of an f32 plane, of one of u32, or of one of constants, which are drawn as the
    /// store has them.
    template <class T>
    [[nodiscard]] T* plane_row(int plane, int y) {
        assert(sizeof(T) == drawn_bytes());
        return reinterpret_cast<T*>(drawn_plane(plane).data()) + offset(y);
    }
    /// The same of a plane of interpolated codes, whatever its store: while a tile is drawn, a code
    /// takes 32 bits, so that depth and code have the same lanes; finish() makes them as narrow as
    /// the store.
    [[nodiscard]] std::uint32_t* code_row(int plane, int y) {
        return plane_row<std::uint32_t>(plane, y);
    }
    /// Makes the planes what a sink is shown: codes in the store's type. Needed before view(), for
    /// an empty tile too.
    void finish();

  private:
    /// Plain bytes, aligned for any vector; whoever writes elements gives them a type.
    using Memory = AlignedArray<std::byte>;

    [[nodiscard]] std::ptrdiff_t offset(int y) const {
        return static_cast<std::ptrdiff_t>(y - own_.y0 + kMaxHalo_px) * kTileStride +
               kTileMargin_px - own_.x0;
    }
    [[nodiscard]] std::size_t element_bytes() const { return bytes_of(format_.store); }
    /// Whether planes are drawn with more bits than the store has.
    [[nodiscard]] bool is_narrowed() const {
        return format_.interpolants > 0 && element_bytes() < sizeof(std::uint32_t);
    }
    [[nodiscard]] std::size_t drawn_bytes() const {
        return is_narrowed() ? sizeof(std::uint32_t) : element_bytes();
    }
    [[nodiscard]] Memory& drawn_plane(int plane) {
        const auto at = static_cast<std::size_t>(plane);
        return is_narrowed() ? wide_[at] : planes_[at];
    }
    void exchange(TilePixels& other);
    void extend_frame_of(Memory& memory, std::size_t bytes_per_element) const;

    const PassFormat& format_;
    TileGrid grid_;
    PixelRect own_;
    PixelRect drawn_;
    std::array<std::uint32_t, kMaxPlanes> sky_{};  ///< one element's bits, repeated over four bytes
    bool is_clean_ = false;                        ///< the drawn planes hold nothing but sky
    bool shows_sky_ = false;                       ///< the narrowed planes hold nothing but sky
    Memory depth_;
    std::array<Memory, kMaxPlanes> planes_;  ///< as the store has them
    std::array<Memory, kMaxPlanes> wide_;    ///< codes of u8 and u16 while they are drawn
};

}  // namespace ink::raster
