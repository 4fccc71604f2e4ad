#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "scene/surface.h"

namespace ink::shade {

/// How much of a lamp's light arrives at distance `distance`: falling evenly from 1 to
/// 0 at its range, where it ends with a bend that can be seen; 1 everywhere for range 0.
/// Never negative.
///
/// As engines of 1998 had it; real light falls with the square and never ends.
[[nodiscard]] double reach(const scene::OmniLight& lamp, double distance);

/// The light that arrives at a point of a surface: `ambient` plus what each lamp sends, times the
/// cosine between its direction and the unit normal; a lamp behind the surface sends nothing.
/// Lambert's law.
[[nodiscard]] glm::vec3 light_at(const glm::dvec3& p_world,
                                 const glm::dvec3& n_world,
                                 std::span<const scene::OmniLight> lamps,
                                 const glm::vec3& ambient);

/// Three lamps for a scene that has none, hung about `camera`: a bright one over its left shoulder
/// that reaches everywhere, a bluish one from the right and a reddish one from below that end
/// inside `bounds`.
[[nodiscard]] std::vector<scene::OmniLight> studio_lamps(const scene::Camera& camera,
                                                         const scene::Sphere& bounds);

/// What a shading knows of a point: the light that arrives, and how the key lamp stands to it.
struct Tone {
    glm::vec3 light{0};  ///< ambient and every lamp's share, 0 .. 1 and beyond
    float cosine = 0;    ///< l.n, l towards the key lamp (the first), n the side that is seen
};

/// Over what a tone is one.
enum class ShadeBy {
    vertex,  ///< found at vertices and interpolated (Gouraud 1971)
    face,    ///< one per triangle, at its centroid under its own normal
    patch,   ///< one per flat patch (see find_flat_patches); the rest as `vertex`
};

/// The tone of a point under a unit normal; cosine 0 without lamps, or where the key lamp is.
[[nodiscard]] Tone tone_at(const glm::dvec3& p_world,
                           const glm::dvec3& n_world,
                           std::span<const scene::OmniLight> lamps,
                           const glm::vec3& ambient);

/// How bright light looks, 0 .. 1: its luma (ITU-R 601), limited.
[[nodiscard]] float brightness(const glm::vec3& light);

/// Where a tone is one over several triangles.
struct UniformSpots {
    /// A point with the unit normal of its front; the back has it negated.
    struct Spot {
        glm::dvec3 p_world{0};
        glm::dvec3 n_world{0, 0, 1};
    };
    std::vector<Spot> spots;
    std::vector<std::uint32_t> of;  ///< per triangle into `spots`, or kNone; empty: all kNone

    static constexpr std::uint32_t kNone = 0xffffffffU;
};

/// The tones of a surface as its pixels read them; index 0 for fronts, 1 for backs.
struct SurfaceTones {
    std::array<std::vector<Tone>, 2> vertices;  ///< one per corner of the surface
    std::array<std::vector<Tone>, 2> spots;     ///< one per uniform spot
};

/// The tones of every corner and spot, on both sides. The surface has normals.
[[nodiscard]] SurfaceTones make_tones(const scene::Surface& surface,
                                      const UniformSpots& spots,
                                      std::span<const scene::OmniLight> lamps,
                                      const glm::vec3& ambient);

/// Faces that bend by less than this at an edge (rad) are in one plane: float corners say no more.
inline constexpr double kFlat_rad = 1e-3;

/// One spot per triangle: its centroid and normal (+z where it has no area).
[[nodiscard]] UniformSpots face_spots(const scene::Surface& surface);

/// One spot per flat patch: faces of one plane that hang together over edges, none of which goes on
/// smoothly beyond (bends by less than `crease_rad`). The caps of a cylinder are flat patches, its
/// side is none.
///
/// The spot is the patch's centroid under its mean normal, both weighted by area. Edges of more
/// than two faces and between faces of opposite orientation end a patch like a crease. Triangles
/// that the weld drops (degenerate, duplicate) have none. An empty scene has no patches.
///
/// CoRgi's own suggestion against the gradients that shading by vertices lays over flat faces.
[[nodiscard]] UniformSpots patch_spots(const scene::Scene& scene, double crease_rad);

}  // namespace ink::shade
