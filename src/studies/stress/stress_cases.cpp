#include "studies/stress/stress_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "catalogue/catalogue.h"
#include "core/error.h"
#include "core/named.h"

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

std::vector<Case> make_cases(const StressPoint& point,
                             std::vector<scene::Scene> scenes,
                             const StressLook& look) {
    std::vector<Case> cases;
    for (scene::Scene& scene : scenes) {
        scene::Camera camera = scene::look_at(
            look.eye_world, look.target_world, {0, 1, 0}, glm::radians(look.fov_deg));
        scene::fit_clip_range(camera, scene::bounding_sphere(scene));
        cases.push_back(make_case(point, std::move(scene), camera));
    }
    return cases;
}

StressMaker catalogue_cases(std::vector<std::string> scenes) {
    return [scenes = std::move(scenes)](const StressPoint& point) {
        std::vector<Case> cases;
        for (const std::string& name : scenes) {
            scene::Scene scene = catalogue::make_catalogue_scene(name);
            scene.animation = nullptr;
            const scene::Camera camera = scene.cameras.front();
            cases.push_back(make_case(point, std::move(scene), camera));
        }
        return cases;
    };
}

StressMaker base_cases() {
    return catalogue_cases({"blocks", "gear", "torus", "rocket"});
}

StressMaker changed(StressMaker make, CaseChange change) {
    return [make = std::move(make), change = std::move(change)](const StressPoint& point) {
        std::vector<Case> cases = make(point);
        for (Case& stress : cases)
            change(point, stress);
        return cases;
    };
}

Axis make_axis(StressHeading heading,
               std::vector<double> values,
               std::string sentence,
               StressMaker make) {
    Axis axis;
    axis.name = std::move(heading.name);
    axis.title = std::move(heading.title);
    axis.unit = std::move(heading.unit);
    axis.scale = heading.scale;
    axis.values = std::move(values);
    axis.sentence = std::move(sentence);
    axis.cases = [name = axis.name, make = std::move(make)](double value, const CaseSize& size) {
        return make({name, value, size});
    };
    return axis;
}

std::vector<double> evenly(double low, double high, double step) {
    std::vector<double> values;
    for (int i = 0; low + i * step <= high; ++i)
        values.push_back(low + i * step);
    return values;
}

std::vector<double> decades(int low, int high) {
    std::vector<double> values;
    for (int exponent = low; exponent <= high; ++exponent)
        values.push_back(std::pow(10, exponent));
    return values;
}

glm::dmat4 moved(const glm::dvec3& by) {
    return glm::translate(glm::dmat4(1), by);
}

void put(scene::Scene& scene, scene::Mesh mesh, const glm::dmat4& world_from_object) {
    const auto number = static_cast<std::uint32_t>(scene.meshes.size());
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back({number, world_from_object, "part"});
}

scene::Scene scene_of(std::string name, scene::Mesh mesh, const glm::dmat4& world_from_object) {
    scene::Scene scene;
    scene.name = std::move(name);
    put(scene, std::move(mesh), world_from_object);
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

const Axis& find_stress_axis(const std::string& name) {
    if (const Axis* axis = core::find_named(stress_axes(), name)) return *axis;
    throw core::Error("--axes",
                      fmt::format("there is no axis '{}'", name),
                      core::known_names(core::names_of(stress_axes()), name));
}

const std::vector<Axis>& stress_axes() {
    static const std::vector<Axis> axes = [] {
        std::vector<Axis> made;
        add_place_axes(made);
        add_shape_axes(made);
        add_parameter_axes(made);
        add_defect_axes(made);
        return made;
    }();
    return axes;
}

}  // namespace ink::studies
