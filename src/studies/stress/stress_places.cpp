#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <utility>

#include "catalogue/shapes.h"
#include "scene/camera_path.h"
#include "studies/roll_axis.h"
#include "studies/stress/stress_cases.h"

namespace ink::studies {
namespace {

/// Moves scene, cameras and lights by a matrix that only moves and scales evenly.
void transform(Case& stress, const glm::dmat4& moved, double scale) {
    for (scene::Instance& instance : stress.scene_views.scene.instances)
        instance.world_from_object = moved * instance.world_from_object;
    scene::Camera& camera = stress.scene_views.views.front().camera;
    camera.eye_world = glm::dvec3(moved * glm::dvec4(camera.eye_world, 1));
    camera.near *= scale;
    camera.far *= scale;
    stress.scene_views.scene.cameras.clear();
    stress.scene_views.scene.lights.clear();
}

/// A way from the origin that is about 1 long, in sixteenths: whole distances along it are exact.
constexpr glm::dvec3 kAway{0.75, 0.5, 0.4375};

std::vector<Case> moved_away(const StressPoint& point) {
    std::vector<Case> cases = base_cases(point);
    for (Case& stress : cases)
        transform(stress, glm::translate(glm::dmat4(1), kAway * point.value), 1);
    return cases;
}

/// The scene with world positions in floats, as a renderer holds it that knows no others.
scene::Scene in_floats(const scene::Scene& scene) {
    scene::Scene rounded;
    rounded.name = scene.name;
    rounded.split = scene.split;
    for (const scene::Instance& instance : scene.instances) {
        scene::Mesh mesh = scene.meshes[instance.mesh];
        mesh.normals.clear();
        for (glm::vec3& p : mesh.positions)
            p = glm::vec3(scene::to_world(instance, p));
        if (scene::is_mirrored(instance)) {
            for (scene::Triangle& triangle : mesh.triangles)
                std::swap(triangle[1], triangle[2]);
        }
        const auto number = static_cast<std::uint32_t>(rounded.meshes.size());
        rounded.meshes.push_back(std::move(mesh));
        rounded.instances.push_back({number, glm::dmat4(1), instance.name});
    }
    return rounded;
}

/// A pyramid of a quarter of the near distance, two and a half of it before the eye, lower left.
void add_near_thing(scene::Scene& scene, const scene::Camera& camera) {
    const glm::dmat3 world_from_view = glm::transpose(camera.view_from_world);
    const glm::dvec3 at =
        camera.eye_world + world_from_view * (camera.near * glm::dvec3(-0.75, -0.5, -2.5));
    glm::dmat4 placed = glm::translate(glm::dmat4(1), at) * glm::dmat4(world_from_view);
    placed = glm::scale(placed, glm::dvec3(camera.near / 4));
    placed = glm::rotate(placed, 0.4, glm::dvec3(0, 1, 0));
    const auto number = static_cast<std::uint32_t>(scene.meshes.size());
    scene.meshes.push_back(catalogue::make_cone(0.75, 1.5, 5));
    scene.instances.push_back({number, placed, "near"});
}

/// A floor 60 wide and 800 long, and things on it near its middle.
scene::Scene floor_scene(std::string name) {
    return scene_of(std::move(name),
                    catalogue::make_sheet({-30, 0, -400}, {0, 0, 800}, {60, 0, 0}, {40, 4}));
}

void put(scene::Scene& scene, const scene::Mesh& mesh, const glm::dvec3& at, double turn_deg) {
    const auto number = static_cast<std::uint32_t>(scene.meshes.size());
    scene.meshes.push_back(mesh);
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), at);
    scene.instances.push_back(
        {number, glm::rotate(moved, glm::radians(turn_deg), glm::dvec3(0, 1, 0)), "thing"});
}

/// The vertex that is nearest the eye: seen, and mostly a corner.
glm::dvec3 nearest_vertex(const scene::Scene& scene, const glm::dvec3& eye_world) {
    glm::dvec3 nearest{0};
    double least = std::numeric_limits<double>::infinity();
    for (const scene::Instance& instance : scene.instances) {
        for (const glm::vec3& p : scene.meshes[instance.mesh].positions) {
            const glm::dvec3 p_world = scene::to_world(instance, p);
            const double distance = glm::distance(p_world, eye_world);
            if (distance >= least) continue;
            least = distance;
            nearest = p_world;
        }
    }
    return nearest;
}

Case rolled(const StressPoint& point, scene::Scene scene) {
    const scene::Camera camera = rolled_camera(scene, point.value);
    return make_case(point, std::move(scene), camera);
}

}  // namespace

std::vector<Case> near_far_cases(const StressPoint& point) {
    std::vector<Case> cases = base_cases(point);
    for (Case& stress : cases) {
        scene::Camera& camera = stress.scene_views.views.front().camera;
        camera.near = camera.far / point.value;
        add_near_thing(stress.scene_views.scene, camera);
        stress.settings = {"depth_range=camera"};
    }
    return cases;
}

std::vector<Case> grazing_cases(const StressPoint& point) {
    const double angle_rad = glm::radians(point.value);
    const StressLook look{
        1000.0 * glm::dvec3(0, std::sin(angle_rad), std::cos(angle_rad)), glm::dvec3(0), 0.2};
    scene::Scene boxes = floor_scene("floor_boxes");
    put(boxes, catalogue::make_box({-0.5, -0.25, -0.5}, {0.5, 0.75, 0.5}), {-1.75, 0, -2}, 30);
    put(boxes, catalogue::make_box({-0.375, -0.25, -0.5}, {0.375, 0.5, 0.5}), {0, 0, 1}, -15);
    put(boxes, catalogue::make_box({-0.5, -0.25, -0.25}, {0.5, 1, 0.25}), {1.75, 0, -1}, 50);
    scene::Scene steps = floor_scene("floor_steps");
    put(steps, catalogue::make_box({-2.5, -0.125, -3}, {2.5, 0.0625, 3}), {0, 0, 0}, 12);
    put(steps, catalogue::make_box({-1.5, -0.125, -1.5}, {1.5, 0.25, 1.5}), {0.25, 0, -0.5}, -20);
    scene::Scene balls = floor_scene("floor_balls");
    put(balls, catalogue::make_sphere(0.5, 48, 24), {-1.5, 0.25, 0}, 0);
    put(balls, catalogue::make_cylinder(0.5, 0.75, 32), {0.125, -0.125, -2}, 0);
    put(balls, catalogue::make_cone(0.625, 1, 24), {1.75, -0.125, 1}, 0);
    std::vector<Case> cases;
    for (scene::Scene* scene : {&boxes, &steps, &balls})
        cases.push_back(make_case(point, std::move(*scene), look));
    return cases;
}

std::vector<Case> grazing_linear_cases(const StressPoint& point) {
    std::vector<Case> cases = grazing_cases(point);
    for (Case& stress : cases)
        stress.settings = {"depth_encoding=linear", "guard=none"};
    return cases;
}

std::vector<Case> origin_cases(const StressPoint& point) {
    return moved_away(point);
}

std::vector<Case> fp32_cases(const StressPoint& point) {
    std::vector<Case> cases = moved_away(point);
    for (Case& stress : cases)
        stress.drawn = in_floats(stress.scene_views.scene);
    return cases;
}

std::vector<Case> scale_cases(const StressPoint& point) {
    std::vector<Case> cases = base_cases(point);
    for (Case& stress : cases) {
        transform(stress, glm::scale(glm::dmat4(1), glm::dvec3(point.value)), point.value);
    }
    return cases;
}

std::vector<Case> zoom_cases(const StressPoint& point) {
    std::vector<Case> cases = catalogue_cases(point, {"blocks", "gear", "rocket", "crystals"});
    for (Case& stress : cases) {
        scene::Camera& camera = stress.scene_views.views.front().camera;
        const double slope = std::tan(camera.fov_y_rad / 2) / point.value;
        scene::Camera aimed =
            scene::look_at(camera.eye_world,
                           nearest_vertex(stress.scene_views.scene, camera.eye_world),
                           {0, 1, 0},
                           2 * std::atan(slope));
        aimed.name = camera.name;
        scene::fit_clip_range(aimed, scene::bounding_sphere(stress.scene_views.scene));
        camera = aimed;
    }
    return cases;
}

std::vector<Case> roll_cases(const StressPoint& point) {
    const std::vector<glm::dvec2> wedge = {{-1, -1}, {1.25, -1}, {-0.25, 1}};
    std::vector<Case> cases;
    cases.push_back(rolled(point, roll_scene()));
    cases.push_back(rolled(point, scene_of("wedge", catalogue::extrude(wedge, {-1, 1}))));
    cases.push_back(rolled(point, scene_of("twenty_faces", catalogue::make_icosphere(1.5, 0))));
    cases.front().scene_views.scene.name = "cube";
    return cases;
}

}  // namespace ink::studies
