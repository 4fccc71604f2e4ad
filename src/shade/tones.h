#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "scene/surface.h"

namespace ink::shade {

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

}  // namespace ink::shade
