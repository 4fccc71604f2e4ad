#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "raster/depth/polygon_offset.h"
#include "raster/mesh/lane_mesh.h"
#include "raster/pass/corner_values.h"
#include "raster/pass/pass.h"
#include "raster/skips.h"
#include "scene/camera.h"

namespace ink::raster {

/// Which triangles are left out, by the side that the eye sees, exactly; an edge-on one counts as
/// seen from its front.
enum class Cull {
    none,
    back,   ///< those seen from their back
    front,  ///< those seen from their front
};

/// A frame of a surface that was laid out in clusters. Borrowed for the length of the draw.
struct MeshInput {
    const LaneMesh* mesh = nullptr;
    const CornerValues* values = nullptr;  ///< null where the format interpolates nothing
    /// Per triangle of the surface, if the format has a constant; empty otherwise.
    std::span<const std::uint32_t> constants;
    /// The same as bytes in the order of the mesh's clusters (Clusters::triangle_ids), where all
    /// fit: these lie side by side, and need not be looked up. Empty: they are.
    std::span<const std::uint8_t> constants_in_clusters;
    scene::View view;
    scene::Sphere bounds;  ///< holds all vertices; near planes are fitted to it
    int threads = 1;
    SkipSet skips;
    Cull cull = Cull::none;
    /// Moves every triangle's depth. Faces turned away of solids are then all drawn:
    /// they may be moved out in front of others.
    PolygonOffset offset;
    std::array<float, kMaxPlanes> sky_f32{};
    std::array<std::uint32_t, kMaxPlanes> sky_code{};
    /// Whether a tile inside one plane, or a stencil inside one triangle, certainly gives 0 in
    /// whatever the sink does: such tiles may come as empty ones, such blocks be left out.
    bool flat_gives_zero = false;
    /// Whether tiles of this draw may serve the next one: the objects in each are noted.
    bool may_keep_still = false;
    /// Objects (instances, modulo 64) that moved since the last draw, if the caller still has what
    /// that drew and nothing else changed since then: camera, size, values, sky. Tiles that none of
    /// them touches, now or then, are not drawn, empty ones included. Nothing: all tiles are drawn.
    std::optional<std::uint64_t> moved_objects;
};

/// What a draw left undone, and which tiles it did not hand over.
struct MeshResult {
    SkipCounts skips{};
    /// Per tile, 1 where nothing moved: its sink was not called. Empty unless may_keep_still.
    std::vector<std::uint8_t> still;
};

/// Draws surfaces in clusters: what a method calls each frame.
///
/// The image is that of draw_pass with one addition: a face turned away of a watertight solid, seen
/// from outside it, is never drawn. (It is never seen: but at a contour two faces meet, and the one
/// turned away could win a pixel whose centre lies within a rounding of the edge.) The same holds
/// of a solid with a few small holes, as scans have them (scene::Hole), for clusters that no sight
/// line through a hole meets.
///
/// Clusters that lie outside the image or are turned away are not even transformed. What is left
/// is put on the screen a vector of vertices at a time, its triangles sorted out and set up a
/// vector at a time, and drawn tile by tile; only what is cut by the near plane, larger than
/// kLaneExtent_px or of a rarer format goes through the plain code of triangle_stage and tile_fill,
/// in the same lists. The same bits for every thread count and SIMD target, and whatever is
/// skipped.
class MeshPass {
  public:
    MeshPass();
    ~MeshPass();

    [[nodiscard]] MeshResult draw(const PassFormat& format, const MeshInput& input, TileSink& sink);

  private:
    struct Scratch;
    std::unique_ptr<Scratch> scratch_;
};

}  // namespace ink::raster
