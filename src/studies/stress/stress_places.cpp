#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "catalogue/shapes.h"
#include "scene/views/camera_path.h"
#include "studies/stress/stress_cases.h"

namespace ink::studies {
namespace {

/// Moves scene, cameras and lights by a matrix that only moves and scales evenly.
void transform(Case& stress, const glm::dmat4& by, double scale) {
    for (scene::Instance& instance : stress.scene_views.scene.instances)
        instance.world_from_object = by * instance.world_from_object;
    scene::Camera& camera = stress.scene_views.views.front().camera;
    camera.eye_world = glm::dvec3(by * glm::dvec4(camera.eye_world, 1));
    camera.near *= scale;
    camera.far *= scale;
    stress.scene_views.scene.cameras.clear();
    stress.scene_views.scene.lights.clear();
}

/// A way from the origin that is about 1 long, in sixteenths: whole distances along it are exact.
constexpr glm::dvec3 kAway{0.75, 0.5, 0.4375};

void move_away(const StressPoint& point, Case& stress) {
    transform(stress, moved(kAway * point.value), 1);
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
        put(rounded, std::move(mesh), glm::dmat4(1));
    }
    return rounded;
}

/// A pyramid of a quarter of the near distance, two and a half of it before the eye, lower left.
void add_near_thing(scene::Scene& scene, const scene::Camera& camera) {
    const glm::dmat3 world_from_view = glm::transpose(camera.view_from_world);
    const glm::dvec3 at =
        camera.eye_world + world_from_view * (camera.near * glm::dvec3(-0.75, -0.5, -2.5));
    glm::dmat4 placed = moved(at) * glm::dmat4(world_from_view);
    placed = glm::scale(placed, glm::dvec3(camera.near / 4));
    placed = glm::rotate(placed, 0.4, glm::dvec3(0, 1, 0));
    put(scene, catalogue::make_cone(0.75, 1.5, 5), placed);
}

/// A floor 60 wide and 800 long, and things on it near its middle.
scene::Scene floor_scene(std::string name) {
    return scene_of(std::move(name),
                    catalogue::make_sheet({-30, 0, -400}, {0, 0, 800}, {60, 0, 0}, {40, 4}));
}

void stand(scene::Scene& scene, const scene::Mesh& mesh, const glm::dvec3& at, double turn_deg) {
    put(scene, mesh, glm::rotate(moved(at), glm::radians(turn_deg), glm::dvec3(0, 1, 0)));
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

/// The scene before a camera that has rolled by the point's degrees.
Case rolled(const StressPoint& point, scene::Scene scene) {
    scene::View view{
        scene::look_at(
            {4, 3.375, 6.4375}, glm::dvec3(0), {0, 1, 0}, scene::Camera{}.fov_y_rad / 1.5),
        1,
        1};
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    scene::fit_clip_range(view.camera, bounds);
    scene::CameraPath path = scene::make_path(scene::PathKind::roll, view, bounds, 0);
    path.turn_rad = point.value * (std::numbers::pi / 180);
    return make_case(point, std::move(scene), scene::frame_at(path, 1).view.camera);
}

void move_near(const StressPoint& point, Case& stress) {
    scene::Camera& camera = stress.scene_views.views.front().camera;
    camera.near = camera.far / point.value;
    add_near_thing(stress.scene_views.scene, camera);
    stress.settings = {"depth_range=camera"};
}

std::vector<Case> grazing_cases(const StressPoint& point) {
    const double angle_rad = glm::radians(point.value);
    const StressLook look{
        1000.0 * glm::dvec3(0, std::sin(angle_rad), std::cos(angle_rad)), glm::dvec3(0), 0.2};
    scene::Scene boxes = floor_scene("floor_boxes");
    stand(boxes, catalogue::make_box({-0.5, -0.25, -0.5}, {0.5, 0.75, 0.5}), {-1.75, 0, -2}, 30);
    stand(boxes, catalogue::make_box({-0.375, -0.25, -0.5}, {0.375, 0.5, 0.5}), {0, 0, 1}, -15);
    stand(boxes, catalogue::make_box({-0.5, -0.25, -0.25}, {0.5, 1, 0.25}), {1.75, 0, -1}, 50);
    scene::Scene steps = floor_scene("floor_steps");
    stand(steps, catalogue::make_box({-2.5, -0.125, -3}, {2.5, 0.0625, 3}), {0, 0, 0}, 12);
    stand(steps, catalogue::make_box({-1.5, -0.125, -1.5}, {1.5, 0.25, 1.5}), {0.25, 0, -0.5}, -20);
    scene::Scene balls = floor_scene("floor_balls");
    stand(balls, catalogue::make_sphere(0.5, 48, 24), {-1.5, 0.25, 0}, 0);
    stand(balls, catalogue::make_cylinder(0.5, 0.75, 32), {0.125, -0.125, -2}, 0);
    stand(balls, catalogue::make_cone(0.625, 1, 24), {1.75, -0.125, 1}, 0);
    return make_cases(point, {std::move(boxes), std::move(steps), std::move(balls)}, look);
}

void zoom(const StressPoint& point, Case& stress) {
    scene::Camera& camera = stress.scene_views.views.front().camera;
    const double slope = std::tan(camera.fov_y_rad / 2) / point.value;
    scene::Camera aimed = scene::look_at(camera.eye_world,
                                         nearest_vertex(stress.scene_views.scene, camera.eye_world),
                                         {0, 1, 0},
                                         2 * std::atan(slope));
    aimed.name = camera.name;
    scene::fit_clip_range(aimed, scene::bounding_sphere(stress.scene_views.scene));
    camera = aimed;
}

/// The eye comes nearer or goes away until the angle shows as much of the scene's middle.
void change_view_angle(const StressPoint& point, Case& stress) {
    scene::Camera& camera = stress.scene_views.views.front().camera;
    const scene::Sphere bounds = scene::bounding_sphere(stress.scene_views.scene);
    const double depth = -(camera.view_from_world * (bounds.center_world - camera.eye_world)).z;
    const double height = 2 * depth * std::tan(camera.fov_y_rad / 2);
    camera.fov_y_rad = glm::radians(point.value);
    const double wanted = height / (2 * std::tan(camera.fov_y_rad / 2));
    camera.eye_world += (wanted - depth) * glm::transpose(camera.view_from_world)[2];
    scene::fit_clip_range(camera, bounds);
}

std::vector<Case> roll_cases(const StressPoint& point) {
    const std::vector<glm::dvec2> wedge = {{-1, -1}, {1.25, -1}, {-0.25, 1}};
    std::vector<Case> cases;
    cases.push_back(rolled(point, scene_of("cube", catalogue::make_box({-1, -1, -1}, {1, 1, 1}))));
    cases.push_back(rolled(point, scene_of("wedge", catalogue::extrude(wedge, {-1, 1}))));
    cases.push_back(rolled(point, scene_of("twenty_faces", catalogue::make_icosphere(1.5, 0))));
    return cases;
}

std::vector<double> powers_of_two(int low, int high, int step) {
    std::vector<double> values;
    for (int exponent = low; exponent <= high; exponent += step)
        values.push_back(std::ldexp(1, exponent));
    return values;
}

}  // namespace

void add_place_axes(std::vector<Axis>& axes) {
    axes.push_back(make_axis(
        {"near_far", "far distance over near distance"},
        decades(1, 9),
        "The camera's near plane moves towards the eye while far stays behind the scene; a small "
        "pyramid is 2.5 near distances before the eye, so that the range is used, and depth is "
        "scaled to near and far (depth_range = camera).",
        changed(base_cases(), move_near)));
    axes.push_back(make_axis(
        {"grazing", "angle at which the view direction meets a floor", "deg"},
        {0.1, 0.2, 0.5, 1, 2, 5, 10, 20},
        "A flat floor fills the frame of a long lens (0.2 degrees, 1000 units away); things stand "
        "on it. The eye sinks; below 0.2 degrees the floor's far end comes into the image.",
        grazing_cases));
    axes.push_back(make_axis(
        {"grazing_linear", "angle at which the view direction meets a floor", "deg"},
        {0.1, 0.2, 0.5, 1, 2, 5, 10, 20},
        "The same floor, but depth is written as distance itself (depth_encoding = linear) and "
        "nothing guards against slopes (guard = none), for methods that have these parameters.",
        changed(grazing_cases, [](const StressPoint&, Case& stress) {
            stress.settings = {"depth_encoding=linear", "guard=none"};
        })));
    axes.push_back(
        make_axis({"origin", "distance of scene and camera from the origin", "units"},
                  decades(0, 8),
                  "Scene and camera move together away from the origin, by transforms in double.",
                  changed(base_cases(), move_away)));
    axes.push_back(
        make_axis({"fp32", "distance of scene and camera from the origin", "units"},
                  decades(0, 8),
                  "As the axis before, but methods are given world positions rounded to floats, as "
                  "in a renderer that works in fp32 throughout; the truth is of the exact scene.",
                  changed(base_cases(), [](const StressPoint& point, Case& stress) {
                      move_away(point, stress);
                      stress.drawn = in_floats(stress.scene_views.scene);
                  })));
    axes.push_back(
        make_axis({"scale", "size of the model over its own"},
                  powers_of_two(-30, 30, 6),
                  "Scene, camera, near and far grow together by powers of two, 9e-10 to 1e9.",
                  changed(base_cases(), [](const StressPoint& point, Case& stress) {
                      const glm::dmat4 grown = glm::scale(glm::dmat4(1), glm::dvec3(point.value));
                      transform(stress, grown, point.value);
                  })));
    axes.push_back(
        make_axis({"zoom", "magnification"},
                  powers_of_two(-5, 6, 1),
                  "The focal length grows, aimed at the vertex nearest the eye: from a "
                  "scene of a few pixels to one of its corners.",
                  changed(catalogue_cases({"blocks", "gear", "rocket", "crystals"}), zoom)));
    const std::vector<double> angles_deg = {1, 2, 5, 10, 20, 40, 60, 80};
    const StressMaker seen_at_angles =
        changed(catalogue_cases({"gear", "rocket", "teapot", "crystals"}), change_view_angle);
    axes.push_back(
        make_axis({"view_angle", "vertical angle of view", "deg"},
                  angles_deg,
                  "The angle of view grows, and the eye comes nearer, so that the middle "
                  "of the scene stays as large.",
                  seen_at_angles));
    axes.push_back(make_axis({"view_angle_direction", "vertical angle of view", "deg"},
                             angles_deg,
                             "As the axis before, but facing is judged by the view direction alone "
                             "(facing = direction), "
                             "for methods that have this parameter, as CoRgi has it.",
                             changed(seen_at_angles, [](const StressPoint&, Case& stress) {
                                 stress.settings = {"facing=direction"};
                             })));
    axes.push_back(make_axis({"cube_roll", "roll of the camera", "deg", AxisScale::linear},
                             evenly(0, 350, 10),
                             "The camera turns about its view direction before a cube, a wedge and "
                             "a solid of twenty faces.",
                             roll_cases));
}

}  // namespace ink::studies
