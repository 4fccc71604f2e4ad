#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <string>

#include "scene/scene.h"

namespace ink::catalogue {

/// Where a thing of the catalogue stands: scaled, turned about z, then x, then y, then moved.
struct Pose {
    glm::dvec3 at{0};
    glm::dvec3 turn_deg{0};  ///< about x, y, z
    glm::dvec3 scale{1};     ///< a negative number mirrors
};

/// The transform of a pose, its entries snapped like the positions of a mesh.
[[nodiscard]] glm::dmat4 placed(const Pose& pose);

/// A view that frames the whole scene by itself.
struct Shot {
    std::string name;
    double turn_deg = 0;    ///< of the eye about the vertical, from +z towards +x
    double height_deg = 0;  ///< of the eye above the horizontal
    double fov_deg = 30;
};

/// A view with its eye given.
struct EyeShot {
    std::string name;
    glm::dvec3 eye_world{0};
    glm::dvec3 target_world{0};
    double fov_deg = 40;
    double near = 0;  ///< replaces the fitted near plane if above 0
};

/// Builds one scene of the catalogue: meshes and instances, then `finish` with the views.
class Stage {
  public:
    /// Takes a mesh and returns its number, for `place`.
    std::uint32_t mesh(std::string name, scene::Mesh mesh);
    void place(std::uint32_t mesh, std::string name, const glm::dmat4& world_from_object);
    void place(std::uint32_t mesh, std::string name, const Pose& pose = {});
    /// A mesh that is placed once.
    void add_at(const glm::dmat4& world_from_object, std::string name, scene::Mesh mesh);
    void add(std::string name, scene::Mesh mesh, const Pose& pose = {}) {
        add_at(placed(pose), std::move(name), std::move(mesh));
    }

    /// A view that comes before those of `finish`.
    void view(const EyeShot& shot);
    void light(const scene::OmniLight& light) { scene_.lights.push_back(light); }

    /// The scene with its views, their near and far fitted and, if none were given, two lights: a
    /// white one from the upper left, and a warm one from the right that ends inside the scene.
    [[nodiscard]] scene::Scene finish(std::initializer_list<Shot> shots,
                                      std::initializer_list<EyeShot> eye_shots = {});

  private:
    /// A 16:9 view from a side, as near as the scene fits with a margin of 4 % on either side.
    void view(const Shot& shot);

    scene::Scene scene_;
    std::vector<double> nears_;  ///< per camera, 0: fitted
};

}  // namespace ink::catalogue
