#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/suite/suite.h"

namespace ink::cli {

/// Where a scene is and from where it is seen, so that a user can place a camera: its box, the
/// centre and radius of the sphere that views are fitted to, and each view as the options that make
/// it.
/// All coordinates are the file's own (Scene::origin).
struct Place {
    struct Camera {
        std::string name;
        glm::dvec3 eye_world{0};
        glm::dvec3 target_world{0};  ///< on the line of sight, as far away as the centre is
        glm::dvec3 up_world{0};
        double fov_deg = 0;
        double height_world = 0;  ///< of a parallel camera, else 0
    };
    glm::dvec3 low_world{0};
    glm::dvec3 high_world{0};
    glm::dvec3 center_world{0};
    double radius = 0;
    harness::UpAxis up = harness::UpAxis::y;  ///< in views by name
    std::vector<Camera> cameras;
    glm::dvec3 origin{0};  ///< taken out of all coordinates before they became floats
    std::vector<std::string> animations;
    std::vector<std::string> not_heeded;  ///< what of the file does not count here
};

/// Says on stderr which axis is up in the views by name of a scene, unless that is y.
void print_up(const std::string& scene, harness::UpAxis up);

/// That, where views are by name, and what of a model's file does not count here.
void print_notes(const harness::SceneViews& scene_views);

/// Says on stderr, in one line, what of a model's file does not count here; nothing if all does.
void print_not_heeded(const std::string& scene, const std::vector<std::string>& notes);

/// The place of a scene with at least one triangle.
[[nodiscard]] Place place_of(const harness::SceneViews& scene_views);

/// A line for the box and the sphere, then one for each view: `name  --eye X,Y,Z --target ...`, to
/// nine digits, or fifteen for a scene that is far out.
[[nodiscard]] std::string as_text(const Place& place);

/// The same as `box`, `centre`, `radius` and `cameras` by name.
[[nodiscard]] nlohmann::ordered_json as_json(const Place& place);

}  // namespace ink::cli
