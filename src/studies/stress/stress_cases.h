#pragma once

#include <glm/vec3.hpp>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh.h"
#include "studies/stress/stress_axes.h"

// The makers behind `stress_axes()`: each returns the cases of one value of its axis.

namespace ink::studies {

/// A place on an axis on its way to cases.
struct StressPoint {
    std::string_view axis;
    double value = 0;
    CaseSize size;
};

/// A case of `scene` seen by `camera`, named as stress_axes.h says.
[[nodiscard]] Case make_case(const StressPoint& point,
                             scene::Scene scene,
                             const scene::Camera& camera);

/// A scene of its own: near and far fitted, seen from `eye_world`.
struct StressLook {
    glm::dvec3 eye_world{0};
    glm::dvec3 target_world{0};
    double fov_deg = 30;
};
[[nodiscard]] Case make_case(const StressPoint& point, scene::Scene scene, const StressLook& look);

/// Catalogue scenes, each from its first view, at rest.
[[nodiscard]] std::vector<Case> catalogue_cases(const StressPoint& point,
                                                std::initializer_list<const char*> scenes);
/// What most axes are tried on: five boxes driven through each other, gears, a ring, a rocket.
[[nodiscard]] std::vector<Case> base_cases(const StressPoint& point);

/// A mesh as a scene, placed by `world_from_object`.
[[nodiscard]] scene::Scene scene_of(std::string name,
                                    scene::Mesh mesh,
                                    const glm::dmat4& world_from_object = glm::dmat4(1));
/// A cube whose faces are cut at `cuts`, ascending, its sides at the first and the last; every
/// face has vertices of its own. Positions are the cuts as floats, not snapped.
[[nodiscard]] scene::Mesh cut_cube(const std::vector<double>& cuts);

// stress_places.cpp: where the eye is, and where numbers run out
[[nodiscard]] std::vector<Case> near_far_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> grazing_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> grazing_linear_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> origin_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> fp32_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> scale_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> zoom_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> roll_cases(const StressPoint& point);

// stress_shapes.cpp: what the triangles are like
[[nodiscard]] std::vector<Case> gap_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> sliver_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> facet_cases(const StressPoint& point);

// stress_defects.cpp: a share of the triangles, in percent, is not as it should be
[[nodiscard]] std::vector<Case> duplicate_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> t_junction_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> crack_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> orientation_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> soup_cases(const StressPoint& point);

// stress_parameters.cpp: what the methods and the machine are set to
/// Names of the depth axis' values, from 1.
[[nodiscard]] std::vector<std::string> depth_names();
[[nodiscard]] std::vector<Case> depth_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> code_bits_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> saturate_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> wrap_cases(const StressPoint& point);
[[nodiscard]] std::vector<Case> thread_cases(const StressPoint& point);
/// Names of this machine's SIMD targets, each on one thread and on four, from 1.
[[nodiscard]] std::vector<std::string> simd_names();
[[nodiscard]] std::vector<Case> simd_cases(const StressPoint& point);

}  // namespace ink::studies
