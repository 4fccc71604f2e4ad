#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh.h"
#include "studies/axis.h"

// What `stress_axes()` is put together from.

namespace ink::studies {

/// A place on an axis on its way to cases.
struct StressPoint {
    std::string_view axis;
    double value = 0;
    CaseSize size;
};

/// A case of `scene` seen by `camera`, named as stress_axes() says.
[[nodiscard]] Case make_case(const StressPoint& point,
                             scene::Scene scene,
                             const scene::Camera& camera);

/// A case of each scene: near and far fitted, seen from `eye_world`.
struct StressLook {
    glm::dvec3 eye_world{0};
    glm::dvec3 target_world{0};
    double fov_deg = 30;
};
[[nodiscard]] std::vector<Case> make_cases(const StressPoint& point,
                                           std::vector<scene::Scene> scenes,
                                           const StressLook& look);

/// The cases of one value.
using StressMaker = std::function<std::vector<Case>(const StressPoint&)>;

/// Catalogue scenes, each from its first view, at rest.
[[nodiscard]] StressMaker catalogue_cases(std::vector<std::string> scenes);
/// What most axes are tried on: five boxes driven through each other, gears, a ring, a rocket.
[[nodiscard]] StressMaker base_cases();
/// The cases of `make`, each changed as the value asks.
using CaseChange = std::function<void(const StressPoint&, Case&)>;
[[nodiscard]] StressMaker changed(StressMaker make, CaseChange change);

/// What an axis is called and what its values are.
struct StressHeading {
    std::string name;
    std::string title;
    std::string unit = "";
    AxisScale scale = AxisScale::log;
};
[[nodiscard]] Axis make_axis(StressHeading heading,
                             std::vector<double> values,
                             std::string sentence,
                             StressMaker make);

/// From `low` to `high`, both included.
[[nodiscard]] std::vector<double> evenly(double low, double high, double step);
/// The powers of ten from 10^low to 10^high.
[[nodiscard]] std::vector<double> decades(int low, int high);

[[nodiscard]] glm::dmat4 moved(const glm::dvec3& by);
/// Adds a mesh to a scene, exactly where it is said to be.
void put(scene::Scene& scene, scene::Mesh mesh, const glm::dmat4& world_from_object);
/// A mesh as a scene, placed by `world_from_object`.
[[nodiscard]] scene::Scene scene_of(std::string name,
                                    scene::Mesh mesh,
                                    const glm::dmat4& world_from_object = glm::dmat4(1));
/// A cube whose faces are cut at `cuts`, ascending, its sides at the first and the last; every
/// face has vertices of its own. Positions are the cuts as floats, not snapped.
[[nodiscard]] scene::Mesh cut_cube(const std::vector<double>& cuts);

/// stress_places.cpp: where the eye is, and where numbers run out.
void add_place_axes(std::vector<Axis>& axes);
/// stress_shapes.cpp: what the triangles are like.
void add_shape_axes(std::vector<Axis>& axes);
/// stress_parameters.cpp: what the methods and the machine are set to.
void add_parameter_axes(std::vector<Axis>& axes);
/// stress_defects.cpp: a share of the triangles, in percent, is not as it should be.
void add_defect_axes(std::vector<Axis>& axes);

}  // namespace ink::studies
