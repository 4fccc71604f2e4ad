#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/camera.h"
#include "scene/mesh.h"

namespace ink::scene {

struct Animation;

/// A placed mesh. Its index in `Scene::instances` is its object id.
struct Instance {
    std::uint32_t mesh = 0;           ///< index into Scene::meshes
    glm::dmat4 world_from_object{1};  ///< affine; may mirror or scale unevenly
    std::string name;
};

/// The world position of an object-space point: the one expression by which everyone places
/// vertices, so that equal inputs weld bit for bit.
[[nodiscard]] inline glm::dvec3 to_world(const Instance& instance, const glm::vec3& p_object) {
    return glm::dvec3(instance.world_from_object * glm::dvec4(glm::dvec3(p_object), 1.0));
}

/// Whether the instance turns its mesh inside out (negative determinant). Its triangles are then
/// taken with two corners swapped, so that their fronts stay fronts (glTF 2.0, section 3.7.4).
[[nodiscard]] bool is_mirrored(const Instance& instance);

/// A lamp for the shaded images; outlines do not know it.
struct OmniLight {
    glm::dvec3 p_world{0};
    glm::vec3 color{1};
    double range = 0;  ///< world units at which it visibly ends; 0 reaches everywhere
};

/// Which part of the suite a scene belongs to: views of one scene leak, so scenes are split, not
/// views.
enum class Split {
    train,    ///< thresholds and presets are found on these
    heldout,  ///< made by code; nothing is found on these
    real,     ///< a model file; nothing is found on these
};

/// What rows call a part: "train", "heldout" or "real".
[[nodiscard]] std::string_view split_name(Split split);

/// Per vertex whether a triangle uses it.
[[nodiscard]] std::vector<bool> used_vertices(const Mesh& mesh);

/// What a model file has beside the scene; a scene made by code has nothing of it.
struct FileFacts {
    std::vector<std::string> animation_names;  ///< of all, "" where one has none
    std::vector<std::string> notes;            ///< what does not count here, a few words each
};

/// Everything a method, the rasterizer and the truth may know.
struct Scene {
    std::string name;
    Split split = Split::heldout;  ///< importers say `real`
    std::string kind;              ///< of thing: "vehicle"; "" where nobody said
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Camera> cameras;  ///< the scene's own views, near and far fitted
    std::vector<OmniLight> lights;
    /// Taken out of all coordinates before they became floats: a place p_world here is
    /// `origin + p_world` in the file.
    glm::dvec3 origin{0};
    FileFacts file{};
    std::shared_ptr<const Animation>
        animation{};  ///< how it moves (animation.h); null: it does not
};

/// The number of triangles over all instances (a mesh placed twice counts twice).
///
/// Triangles are numbered over the scene in this order: instance by instance, and within one as its
/// mesh lists them. This *global triangle index* is what id planes and truth layers hold.
[[nodiscard]] std::size_t triangle_count(const Scene& scene);

/// A ball round all placed vertices that a triangle uses; radius 0 and centre 0 for an empty scene.
[[nodiscard]] Sphere bounding_sphere(const Scene& scene);

/// Throws Error (where = the scene's name) if an index is out of range, a number is not finite, an
/// array has the wrong length, or there is no triangle at all. Importers and the catalogue call it.
void check_scene(const Scene& scene);

/// A hash of everything that could change an image of the scene, cameras and lights excepted.
[[nodiscard]] std::uint64_t scene_hash(const Scene& scene);

/// `count` cameras round the bounding sphere (section 10 of the design: `--views N`), evenly turned
/// about the vertical from a three-quarter view, at alternating heights, the whole ball in the
/// frame of aspect `width_px : height_px`. Names are "view0", "view1", ... Empty for count 0.
[[nodiscard]] std::vector<Camera> orbit_cameras(const Sphere& bounds,
                                                int count,
                                                double width_over_height);

/// From where a view is seen, and what stands upright in it.
struct NamedDirection {
    std::string_view name;
    glm::dvec3 outward_world{0};  ///< from what is looked at to the eye, of length 1
    glm::dvec3 up_world{0};
};

/// The views of a technical drawing: front (from +z), back, left, right (from +x), top (from +y, -z
/// up on the page), bottom (+z up) and iso (from 1,1,1).
[[nodiscard]] std::span<const NamedDirection> drawing_views();

/// A camera called by the view's name that looks at the middle of the ball, all of it in the frame.
[[nodiscard]] Camera camera_round(const Sphere& bounds,
                                  const NamedDirection& view,
                                  double width_over_height);

}  // namespace ink::scene
