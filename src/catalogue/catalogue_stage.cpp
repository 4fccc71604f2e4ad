// Machined parts. A fillet meets its faces without a crease, so a part's creases can be counted.

#include "catalogue/catalogue_stage.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "catalogue/shapes.h"
#include "scene/views/framing.h"

namespace ink::catalogue {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

/// `count` steps along the quarter circle about `centre` from `from_rad` to `to_rad`, its first
/// point left out if `is_begun`.
void add_arc(std::vector<glm::dvec2>& outline,
             const glm::dvec2& centre,
             double radius,
             glm::dvec2 from_to_rad,
             int count,
             bool is_begun = false) {
    for (int i = is_begun ? 1 : 0; i <= count; ++i) {
        const double angle_rad = glm::mix(from_to_rad.x, from_to_rad.y, double(i) / count);
        outline.push_back(centre + glm::dvec2(std::cos(angle_rad), std::sin(angle_rad)) * radius);
    }
}

/// A rectangle of 2 `half`, its corners rounded by `radius`, at `height`: counter-clockwise seen
/// from above, from the middle of the side at +x.
Ring rounded_rectangle(const glm::dvec2& half, double radius, double height) {
    constexpr int kArc = 12;
    constexpr int kSide = 8;
    std::vector<glm::dvec2> outline;
    const glm::dvec2 inner = half - radius;
    for (int corner = 0; corner < 4; ++corner) {
        const glm::dvec2 centre{corner == 0 || corner == 3 ? inner.x : -inner.x,
                                corner < 2 ? inner.y : -inner.y};
        add_arc(outline, centre, radius, glm::dvec2(corner, corner + 1) * kQuarter, kArc);
        const glm::dvec2 from = outline.back();
        const glm::dvec2 to = corner == 0   ? glm::dvec2(-inner.x, half.y)
                              : corner == 1 ? glm::dvec2(-half.x, -inner.y)
                              : corner == 2 ? glm::dvec2(inner.x, -half.y)
                                            : glm::dvec2(half.x, inner.y);
        for (int i = 1; i < kSide; ++i)
            outline.push_back(glm::mix(from, to, double(i) / kSide));
    }
    Ring ring;
    for (const glm::dvec2& p : outline)
        ring.emplace_back(p.x, height, -p.y);
    return ring;
}

/// A circle at `height` with a point for each of `ring`'s, in the same directions from the middle.
Ring circle_like(const Ring& ring, double radius, double height) {
    Ring circle;
    for (const glm::dvec3& p : ring)
        circle.push_back(glm::normalize(glm::dvec3(p.x, 0, p.z)) * radius +
                         glm::dvec3(0, height, 0));
    return circle;
}

/// A plate with a bored boss: rounded along its upper edge, filleted round the boss. Its creases
/// are four: the plate's lower outline, the boss's rim, and the bore's two.
scene::Mesh flange() {
    constexpr double kThick = 0.5;
    constexpr double kRound = 0.15;
    constexpr double kFillet = 0.3;
    constexpr double kBoss = 0.6;
    constexpr double kHeight = 1.3;
    constexpr double kBore = 0.35;
    constexpr int kSteps = 8;
    const glm::dvec2 half{1.6, 1.1};
    const Ring lowest = rounded_rectangle(half, 0.4, 0);
    std::vector<Ring> rings{circle_like(lowest, kBore, 0), lowest};
    for (int i = 0; i <= kSteps; ++i) {
        const double angle_rad = kQuarter * i / kSteps;
        const double in = kRound * (1 - std::cos(angle_rad));
        const double height = kThick - kRound * (1 - std::sin(angle_rad));
        rings.push_back(rounded_rectangle(half - in, 0.4 - in, height));
    }
    for (int i = 0; i <= kSteps; ++i) {
        const double angle_rad = kQuarter * i / kSteps;
        rings.push_back(circle_like(lowest,
                                    kBoss + kFillet * (1 - std::sin(angle_rad)),
                                    kThick + kFillet * (1 - std::cos(angle_rad))));
    }
    rings.push_back(circle_like(lowest, kBoss, kHeight));
    rings.push_back(circle_like(lowest, kBore, kHeight));
    return loft(rings, {.along = true});
}

/// An angle of sheet metal, bent round a radius, its free ends rounded: two creases run round it.
scene::Mesh angle() {
    constexpr double kThick = 0.22;
    constexpr double kBend = 0.3;  // of the inner side
    constexpr int kSteps = 16;
    const glm::dvec2 bend{kThick + kBend, kThick + kBend};
    std::vector<glm::dvec2> outline;
    add_arc(outline, bend, kThick + kBend, {2 * kQuarter, 3 * kQuarter}, kSteps);
    add_arc(outline, {2 - kThick / 2, kThick / 2}, kThick / 2, {-kQuarter, kQuarter}, kSteps);
    add_arc(outline, bend, kBend, {3 * kQuarter, 2 * kQuarter}, kSteps);
    add_arc(outline, {kThick / 2, 1.6 - kThick / 2}, kThick / 2, {0, 2 * kQuarter}, kSteps);
    return extrude(outline, {-0.7, 0.7});
}

constexpr double kWidthOverHeight = 16.0 / 9.0;
constexpr double kFill = 0.92;  ///< of the frame, by the scene

glm::dmat4 snapped_columns(const glm::dmat4& m) {
    glm::dmat4 result(1);
    for (int column = 0; column < 4; ++column) {
        result[column] = glm::dvec4(snapped(glm::dvec3(m[column])), m[column].w);
    }
    return result;
}

void add_default_lights(scene::Scene& scene, const scene::Sphere& bounds) {
    const auto around = [&](const glm::dvec3& direction) {
        return snapped(bounds.center_world + direction * bounds.radius);
    };
    scene.lights.push_back({around({-1.25, 2, 2}), glm::vec3(0.875F), 0});
    scene.lights.push_back({around({2, 0.5, 1}), {0.75F, 0.5F, 0.25F}, 2.5 * bounds.radius});
}

}  // namespace

scene::Scene make_bracket_scene() {
    Stage stage;
    stage.add("flange", flange(), {{-1.1, 0, 0}, {0, 14, 0}});
    stage.add("angle", angle(), {{1.25, 0, 0.2}, {0, -22, 0}});
    return stage.finish({{"front", 0, 16}, {"three_quarter", 32, 32}, {"behind", 150, 24}});
}

glm::dmat4 placed(const Pose& pose) {
    const glm::dvec3 turn_rad = glm::radians(pose.turn_deg);
    glm::dmat4 m = glm::translate(glm::dmat4(1), pose.at);
    m = glm::rotate(m, turn_rad.y, glm::dvec3(0, 1, 0));
    m = glm::rotate(m, turn_rad.x, glm::dvec3(1, 0, 0));
    m = glm::rotate(m, turn_rad.z, glm::dvec3(0, 0, 1));
    return snapped_columns(glm::scale(m, pose.scale));
}

std::uint32_t Stage::mesh(std::string name, scene::Mesh mesh) {
    mesh.name = std::move(name);
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<std::uint32_t>(scene_.meshes.size() - 1);
}

void Stage::place(std::uint32_t mesh, std::string name, const glm::dmat4& world_from_object) {
    scene_.instances.push_back({mesh, snapped_columns(world_from_object), std::move(name)});
}

void Stage::place(std::uint32_t mesh, std::string name, const Pose& pose) {
    place(mesh, std::move(name), placed(pose));
}

void Stage::add_at(const glm::dmat4& world_from_object, std::string name, scene::Mesh mesh) {
    const auto number = this->mesh(name, std::move(mesh));
    place(number, std::move(name), world_from_object);
}

void Stage::view(const Shot& shot) {
    const double turn_rad = glm::radians(shot.turn_deg);
    const double height_rad = glm::radians(shot.height_deg);
    const glm::dvec3 back = snapped({std::sin(turn_rad) * std::cos(height_rad),
                                     std::sin(height_rad),
                                     std::cos(turn_rad) * std::cos(height_rad)});
    const double fov_rad = glm::radians(shot.fov_deg);
    scene::Camera camera = scene::look_at(back, glm::dvec3(0), {0, 1, 0}, fov_rad);
    camera.name = shot.name;
    camera.eye_world = snapped(scene::fitted_eye(
        scene::placed_points(scene_), camera.view_from_world, {fov_rad, kWidthOverHeight, kFill}));
    scene_.cameras.push_back(camera);
    nears_.push_back(0);
}

void Stage::view(const EyeShot& shot) {
    scene::Camera camera = scene::look_at(
        shot.eye_world, shot.target_world, glm::dvec3(0, 1, 0), glm::radians(shot.fov_deg));
    camera.name = shot.name;
    scene_.cameras.push_back(camera);
    nears_.push_back(shot.near);
}

scene::Scene Stage::finish(std::initializer_list<Shot> shots,
                           std::initializer_list<EyeShot> eye_shots) {
    for (const Shot& shot : shots)
        view(shot);
    for (const EyeShot& shot : eye_shots)
        view(shot);
    const scene::Sphere bounds = scene::bounding_sphere(scene_);
    for (std::size_t i = 0; i < scene_.cameras.size(); ++i) {
        scene::fit_clip_range(scene_.cameras[i], bounds);
        if (nears_[i] > 0) scene_.cameras[i].near = nears_[i];
    }
    if (scene_.lights.empty()) add_default_lights(scene_, bounds);
    return std::move(scene_);
}

}  // namespace ink::catalogue
