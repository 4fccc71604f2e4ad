#include "studies/stress/stress_cases.h"

#include <fmt/format.h>

#include <glm/trigonometric.hpp>
#include <utility>

#include "catalogue/catalogue.h"

namespace ink::studies {
namespace {

/// The 16 corners where the cuts of one face cross, and their quads.
void add_face(scene::Mesh& mesh, const std::vector<double>& cuts, int axis, bool is_high) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto count = static_cast<std::uint32_t>(cuts.size());
    for (const double v : cuts) {
        for (const double u : cuts) {
            glm::dvec3 p{0};
            p[axis] = is_high ? cuts.back() : cuts.front();
            p[(axis + 1) % 3] = u;
            p[(axis + 2) % 3] = v;
            mesh.positions.emplace_back(p);
        }
    }
    for (std::uint32_t j = 0; j + 1 < count; ++j) {
        for (std::uint32_t i = 0; i + 1 < count; ++i) {
            const std::uint32_t a = first + j * count + i;
            const std::uint32_t b = a + 1;
            const std::uint32_t c = b + count;
            const std::uint32_t d = a + count;
            if (is_high) {
                mesh.triangles.push_back({a, b, c});
                mesh.triangles.push_back({a, c, d});
            } else {
                mesh.triangles.push_back({a, c, b});
                mesh.triangles.push_back({a, d, c});
            }
        }
    }
}

}  // namespace

Case make_case(const StressPoint& point, scene::Scene scene, const scene::Camera& camera) {
    Case stress{std::string(point.axis), point.value, {std::move(scene), {}}};
    stress.scene_views.views.push_back({camera, point.size.width_px, point.size.height_px});
    stress.scene_views.views.front().camera.name = fmt::format("{}={:g}", point.axis, point.value);
    return stress;
}

Case make_case(const StressPoint& point, scene::Scene scene, const StressLook& look) {
    scene::Camera camera =
        scene::look_at(look.eye_world, look.target_world, {0, 1, 0}, glm::radians(look.fov_deg));
    scene::fit_clip_range(camera, scene::bounding_sphere(scene));
    return make_case(point, std::move(scene), camera);
}

std::vector<Case> catalogue_cases(const StressPoint& point,
                                  std::initializer_list<const char*> scenes) {
    std::vector<Case> cases;
    for (const char* name : scenes) {
        scene::Scene scene = catalogue::make_catalogue_scene(name);
        scene.animation = nullptr;
        const scene::Camera camera = scene.cameras.front();
        cases.push_back(make_case(point, std::move(scene), camera));
    }
    return cases;
}

std::vector<Case> base_cases(const StressPoint& point) {
    return catalogue_cases(point, {"blocks", "gear", "torus", "rocket"});
}

scene::Scene scene_of(std::string name, scene::Mesh mesh, const glm::dmat4& world_from_object) {
    scene::Scene scene;
    scene.name = std::move(name);
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back({0, world_from_object, scene.name});
    return scene;
}

scene::Mesh cut_cube(const std::vector<double>& cuts) {
    scene::Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        add_face(mesh, cuts, axis, false);
        add_face(mesh, cuts, axis, true);
    }
    return mesh;
}

}  // namespace ink::studies
