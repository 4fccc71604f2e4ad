#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "core/error.h"
#include "core/hash.h"
#include "scene/box.h"

namespace ink::scene {
namespace {

void check_mesh(const Mesh& mesh, const std::string& where) {
    const auto check_finite = [&](const std::vector<glm::vec3>& vectors, const char* what) {
        for (std::size_t i = 0; i < vectors.size(); ++i) {
            if (is_finite(vectors[i])) continue;
            throw core::Error(where, fmt::format("{} {} is not finite", what, i), "finite numbers");
        }
    };
    check_finite(mesh.positions, "vertex");
    check_finite(mesh.normals, "normal");
    const auto check_count = [&](std::size_t count,
                                 std::size_t expected,
                                 fmt::format_string<std::size_t&, std::size_t&> what,
                                 const char* accepted) {
        if (count == 0 || count == expected) return;
        throw core::Error(where, fmt::format(what, count, expected), accepted);
    };
    const std::size_t vertices = mesh.positions.size(), triangles = mesh.triangles.size();
    check_count(
        mesh.normals.size(), vertices, "{} normals for {} vertices", "none, or one per vertex");
    check_count(mesh.materials.size(),
                triangles,
                "{} materials for {} triangles",
                "none, or one per triangle");
    check_count(mesh.marked_sides.size(),
                triangles,
                "marked sides of {} triangles for {}",
                "none, or of each triangle");
    for (std::size_t t = 0; t < triangles; ++t) {
        for (const std::uint32_t v : mesh.triangles[t]) {
            if (v >= mesh.positions.size()) {
                throw core::Error(where,
                                  fmt::format("triangle {} uses vertex {}", t, v),
                                  fmt::format("0..{}", mesh.positions.size() - 1));
            }
        }
    }
}

void check_instance(const Scene& scene, std::size_t index) {
    const Instance& instance = scene.instances[index];
    const std::string where = fmt::format("{}, instance {}", scene.name, index);
    if (instance.mesh >= scene.meshes.size()) {
        throw core::Error(where,
                          fmt::format("it places mesh {}", instance.mesh),
                          fmt::format("one of {} meshes", scene.meshes.size()));
    }
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(instance.world_from_object[column][row])) {
                throw core::Error(where, "its transform is not finite", "finite numbers");
            }
        }
    }
}

void check_light(const Scene& scene, std::size_t index) {
    const OmniLight& light = scene.lights[index];
    const bool is_good = std::isfinite(glm::length(light.p_world)) && is_finite(light.color) &&
                         std::isfinite(light.range);
    if (is_good) return;
    throw core::Error(fmt::format("{}, light {}", scene.name, index),
                      "its place, colour or range is not finite",
                      "finite numbers");
}

/// Calls `visit` with the world position of every corner of every placed triangle.
template <class Visit>
void for_each_corner(const Scene& scene, Visit visit) {
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        for (const Triangle& triangle : mesh.triangles) {
            for (const std::uint32_t v : triangle)
                visit(to_world(instance, mesh.positions[v]));
        }
    }
}

}  // namespace

Sphere bounding_sphere(const Scene& scene) {
    // The box's centre, and the farthest corner from it: at most sqrt(3) too large, and stable.
    Box box;
    for_each_corner(scene, [&](const glm::dvec3& p) { box.add(p); });
    if (box.is_empty()) return {};
    Sphere sphere{(box.low + box.high) * 0.5, 0};
    for_each_corner(scene, [&](const glm::dvec3& p) {
        sphere.radius = std::max(sphere.radius, glm::length(p - sphere.center_world));
    });
    return sphere;
}

std::string_view split_name(Split split) {
    constexpr std::array<std::string_view, 3> kNames{"train", "heldout", "real"};
    return kNames.at(static_cast<std::size_t>(split));
}

bool is_mirrored(const Instance& instance) {
    return glm::determinant(glm::dmat3(instance.world_from_object)) < 0;
}

std::vector<bool> used_vertices(const Mesh& mesh) {
    std::vector<bool> is_used(mesh.positions.size(), false);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle)
            is_used[v] = true;
    return is_used;
}

std::size_t triangle_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Instance& instance : scene.instances) {
        count += scene.meshes[instance.mesh].triangles.size();
    }
    return count;
}

void check_scene(const Scene& scene) {
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        check_mesh(scene.meshes[m], fmt::format("{}, mesh {}", scene.name, m));
    }
    for (std::size_t i = 0; i < scene.instances.size(); ++i)
        check_instance(scene, i);
    for (std::size_t l = 0; l < scene.lights.size(); ++l)
        check_light(scene, l);
    if (triangle_count(scene) == 0) {
        throw core::Error(scene.name, "it has no triangle", "a scene with at least one");
    }
}

std::uint64_t scene_hash(const Scene& scene) {
    core::Hasher hasher;
    for (const Mesh& mesh : scene.meshes) {
        hasher.items(std::span(mesh.positions)).items(std::span(mesh.normals));
        hasher.items(std::span(mesh.triangles)).items(std::span(mesh.materials));
        if (mesh.rounding != 0) hasher.value(mesh.rounding);
        if (!mesh.marked_sides.empty()) hasher.items(std::span(mesh.marked_sides));
    }
    for (const Instance& instance : scene.instances) {
        hasher.value(instance.mesh).value(instance.world_from_object);
    }
    return hasher.result();
}

std::span<const NamedDirection> drawing_views() {
    static constexpr glm::dvec3 kUp{0, 1, 0};
    static constexpr double kThird = std::numbers::inv_sqrt3;
    static constexpr std::array<NamedDirection, 7> kViews{{{"front", {0, 0, 1}, kUp},
                                                           {"back", {0, 0, -1}, kUp},
                                                           {"left", {-1, 0, 0}, kUp},
                                                           {"right", {1, 0, 0}, kUp},
                                                           {"top", {0, 1, 0}, {0, 0, -1}},
                                                           {"bottom", {0, -1, 0}, {0, 0, 1}},
                                                           {"iso", {kThird, kThird, kThird}, kUp}}};
    return kViews;
}

Camera camera_round(const Sphere& bounds, const NamedDirection& view, double width_over_height) {
    const double radius = bounds.radius > 0 ? bounds.radius : 1.0;
    const double half_y_rad = Camera{}.fov_y_rad / 2;
    const double half_x_rad = std::atan(std::tan(half_y_rad) * width_over_height);
    const double distance = 1.02 * radius / std::sin(std::min(half_x_rad, half_y_rad));
    Camera camera = look_at(bounds.center_world + view.outward_world * distance,
                            bounds.center_world,
                            view.up_world,
                            Camera{}.fov_y_rad);
    camera.name = view.name;
    camera.sight_world = -view.outward_world;
    fit_clip_range(camera, bounds);
    return camera;
}

std::vector<Camera> orbit_cameras(const Sphere& bounds, int count, double width_over_height) {
    constexpr double kFirstTurn_rad = 35 * std::numbers::pi / 180;
    constexpr double kHigh_rad = 25 * std::numbers::pi / 180;
    constexpr double kLow_rad = 8 * std::numbers::pi / 180;

    std::vector<Camera> cameras;
    for (int i = 0; i < count; ++i) {
        const double turn_rad = kFirstTurn_rad + 2 * std::numbers::pi * i / count;
        const double height_rad = i % 2 == 0 ? kHigh_rad : kLow_rad;
        const glm::dvec3 outward{std::sin(turn_rad) * std::cos(height_rad),
                                 std::sin(height_rad),
                                 std::cos(turn_rad) * std::cos(height_rad)};
        const std::string name = fmt::format("view{}", i);
        cameras.push_back(camera_round(bounds, {name, outward, {0, 1, 0}}, width_over_height));
    }
    return cameras;
}

}  // namespace ink::scene
