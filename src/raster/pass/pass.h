#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "raster/depth/depth.h"
#include "scene/mesh.h"

namespace ink::raster {

inline constexpr int kTileSize_px = 64;
inline constexpr int kMaxHalo_px = 2;
inline constexpr int kMaxPlanes = 4;

/// What a pixel keeps besides its depth.
enum class Store {
    none,  ///< depth only
    u8,    ///< integer planes; `planes` of them, or the low bits of the per-triangle constant
    u16,
    u32,  ///< one plane: integer code, or the per-triangle constant as it is
    f32,  ///< float planes
};

/// Bytes of a store's element; 4 of `none`, which has none.
[[nodiscard]] constexpr std::size_t bytes_of(Store store) {
    return store == Store::u8 ? 1 : store == Store::u16 ? 2 : 4;
}

/// What happens to an integer code outside its store's range.
enum class Overflow {
    saturate,  ///< clamped to 0 .. 2^b - 1
    wrap,      ///< taken modulo 2^b
};

/// How interpolants run across a triangle.
enum class Interpolation {
    affine,  ///< linear on the screen, as 1998's hardware did; clipped first, linear in clip space
    perspective,  ///< linear on the surface
};

/// What a pass declares; nothing undeclared is read, interpolated or stored.
///
/// A closed set: interpolants 0, 1, 2 or 4. With 0 and a store, the per-triangle constant alone is
/// kept. Integer stores with interpolants are *codes*: value = floor(interpolated + constant),
/// computed (affine) on a 16.16 integer plane modulo 2^32 set up from the unsnapped vertices, so
/// that a code quantised once from an affine value keeps the Laplacian lemma of the design's
/// section 6 exactly.
struct PassFormat {
    int interpolants = 0;   ///< K: floats per vertex, and planes stored if K > 0
    bool constant = false;  ///< a per-triangle uint32 is added to the code (or is the code)
    Store store = Store::none;
    Overflow overflow = Overflow::saturate;
    Interpolation interpolation = Interpolation::affine;
    DepthFormat depth = DepthFormat::q32;
    int halo_px = 0;  ///< pixels round a tile that its sink may read: 0, 1 or 2

    /// Planes a pixel keeps: K, or 1 for a constant alone, or 0.
    [[nodiscard]] int planes() const {
        return store == Store::none ? 0 : (interpolants > 0 ? interpolants : 1);
    }
    /// Bytes a pixel keeps, depth included (q32 4, z24 3, z16 2): what a row's `bytes_per_px`
    /// reports, whatever a buffer pads it to.
    [[nodiscard]] int bytes_per_px() const;
};

/// Triangles to draw, in submission order. Borrowed for the length of the pass.
struct PassInput {
    std::span<const glm::dvec3> p_clip;  ///< (x, y, w) of scene::Projection::to_clip, unsnapped
    std::span<const scene::Triangle> triangles;
    std::span<const float> values;  ///< interpolants floats per vertex
    /// For triangles seen from their back; empty: `values` serves both sides.
    std::span<const float> values_back;
    std::span<const std::int8_t> facing;       ///< per triangle, negative = back; empty: all front
    std::span<const std::uint32_t> constants;  ///< per triangle if the format has a constant
    double near = 0;                           ///< what has w < near is clipped away
    double far = 0;                            ///< scales z24 and z16 only
    std::array<float, kMaxPlanes> sky_f32{};   ///< what an f32 plane holds where nothing was drawn
    std::array<std::uint32_t, kMaxPlanes> sky_code{};  ///< what an integer plane holds there
};

/// A finished tile as its sink sees it: its pixels and `halo_px` more on every side.
///
/// Local (0,0) is the tile's own top left pixel, which is (x0_px, y0_px) of the image; local
/// coordinates run from -halo_px to width_px + halo_px - 1. Pixels outside the image hold copies
/// of the nearest pixel inside. The tile and its planes are only valid during the call.
struct Tile {
    int x0_px = 0;
    int y0_px = 0;
    int width_px = 0;  ///< of its own pixels; less than kTileSize_px at the right frame
    int height_px = 0;
    int halo_px = 0;
    /// Nothing was drawn, halo included: every plane holds sky. Where the input of a MeshPass
    /// allows it, also a tile inside one plane, whose planes then hold nothing of use.
    bool is_empty = false;
    std::ptrdiff_t stride = 0;  ///< elements from one row to the next, the same in every plane
    /// Local (0,0) of each plane; the type is the format's store.
    std::array<const void*, kMaxPlanes> planes{};
    const void* depth = nullptr;  ///< float (q32) or uint32 (z24, z16); 0 where there is sky

    /// Row y of plane i; T must be the format's store type.
    template <class T>
    [[nodiscard]] const T* row(int i, int y) const {
        assert(y >= -halo_px && y < height_px + halo_px);
        return static_cast<const T*>(planes[static_cast<std::size_t>(i)]) + y * stride;
    }
    template <class T>
    [[nodiscard]] const T* depth_row(int y) const {
        return static_cast<const T*>(depth) + y * stride;
    }
};

/// Receives every tile of a pass once. Called from several threads, each tile from one of them.
class TileSink {
  public:
    virtual ~TileSink() = default;
    virtual void finish(const Tile& tile) = 0;
};

/// Draws the triangles and hands every tile of a width_px x height_px image to `sink`.
///
/// Exact and watertight: vertices snapped to 1/256 px, integer edge functions, top-left rule, so
/// that each pixel centre of a closed fan is covered once. Both sides of a triangle are drawn.
/// Clipped at the near plane and at a guard band far outside the image only. The depth test keeps
/// the nearest, the first submitted on a tie. The same bits for every thread count. An empty
/// image calls nobody.
void draw_pass(const PassFormat& format,
               const PassInput& input,
               int width_px,
               int height_px,
               int threads,
               TileSink& sink);

}  // namespace ink::raster
