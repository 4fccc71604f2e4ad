#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "scene/scene.h"
#include "tests/scene/small_meshes.h"

/// Creases whose dihedral is known: roofs of two faces, seen from above.
namespace ink::linear_code {

inline constexpr double kFanDistance = 5000;  // so far that a unit is a pixel wherever it lies

/// How a roof lies before an eye on the z axis.
struct Roof {
    glm::dvec3 middle{0};      ///< of its ridge, z = 0
    double deviation_rad = 0;  ///< between its faces' normals
    double roll_rad = 0;       ///< of the ridge on the image, from +x to +y
    double tilt_rad = 0;       ///< about the ridge; 0: both faces are seen alike
    double half_length = 10;   ///< of the ridge, px
    double half_width = 8;     ///< each face's on the image, px
};

/// Adds the roof's four triangles, fronts to the eye.
inline void add_roof(const Roof& roof, scene::Mesh& mesh) {
    const glm::dvec3 to_eye = glm::normalize(glm::dvec3(0, 0, kFanDistance) - roof.middle);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), to_eye));
    const glm::dvec3 up = glm::cross(to_eye, right);
    const glm::dvec3 along = std::cos(roof.roll_rad) * right + std::sin(roof.roll_rad) * up;
    const glm::dvec3 across = glm::cross(to_eye, along);
    for (const double side : {-1.0, 1.0}) {
        // From the image's plane a face falls off by half the bend, and the tilt.
        const double fall = roof.deviation_rad / 2 + side * roof.tilt_rad;
        const glm::dvec3 down = roof.half_width * (side * across - std::tan(fall) * to_eye);
        const glm::dvec3 ridge = roof.half_length * along;
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::dvec3& p : {-ridge, ridge, ridge + down, down - ridge})
            mesh.positions.emplace_back(roof.middle + p);
        const auto add = [&](std::uint32_t b, std::uint32_t c) {
            if (side > 0) {
                mesh.triangles.push_back({first, first + b, first + c});
            } else {
                mesh.triangles.push_back({first, first + c, first + b});
            }
        };
        add(1, 2);
        add(2, 3);
    }
}

/// A scene of roofs, and the image on which they lie: a unit is a pixel, the origin its middle.
struct RoofImage {
    scene::Scene scene;
    scene::View view;
};

inline RoofImage image_of(scene::Mesh mesh, int width_px, int height_px) {
    mesh.name = "roofs";
    RoofImage image{scene::scene_of(std::move(mesh)), {}};
    const double fov_y_rad = 2 * std::atan(height_px / 2.0 / kFanDistance);
    image.view = {
        scene::look_at({0, 0, kFanDistance}, {0, 0, 0}, {0, 1, 0}, fov_y_rad), width_px, height_px};
    scene::fit_clip_range(image.view.camera, scene::bounding_sphere(image.scene));
    return image;
}

/// A row of 24 roofs for each bend of 15, 25, ... 165 degrees: eight rolls, each tilted three ways
/// as far as half of what both faces allow.
inline RoofImage crease_fan() {
    constexpr int kRows = 16, kRolls = 8, kTilts = 3, kCell = 30;
    constexpr int kColumns = kRolls * kTilts;
    scene::Mesh mesh;
    for (int row = 0; row < kRows; ++row) {
        const double deviation_rad = (15 + 10 * row) * std::numbers::pi / 180;
        for (int column = 0; column < kColumns; ++column) {
            // Not all at the same place of their pixels.
            const glm::dvec3 middle((column - kColumns / 2 + 0.5) * kCell + 0.37 * row,
                                    (kRows / 2 - row - 0.5) * kCell + 0.29 * column,
                                    0);
            const int tilt = column % kTilts - 1;
            const double most_rad = std::min(std::numbers::pi - deviation_rad, deviation_rad) / 4;
            add_roof({.middle = middle,
                      .deviation_rad = deviation_rad,
                      .roll_rad = (column / kTilts + 0.31) * std::numbers::pi / kRolls,
                      .tilt_rad = tilt * most_rad},
                     mesh);
        }
    }
    return image_of(std::move(mesh), kColumns * kCell + 40, kRows * kCell + 40);
}

}  // namespace ink::linear_code
