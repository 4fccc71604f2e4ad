#include "import/imported_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <utility>

namespace ink::import {
namespace {

constexpr std::size_t kMostLights = 64;  // each is worked out at every vertex
// How far a distant light hangs from the scene's middle, in radii: its rays differ by less than a
// tenth of a degree.
constexpr double kFarRadii = 1000;
// As far as check_animation lets anything reach.
constexpr double kMostExtent = 1e30;

bool is_usable(double x) {
    return std::isfinite(x) && std::abs(x) < kMostExtent;
}

bool is_usable(const glm::dvec3& v) {
    return is_usable(v.x) && is_usable(v.y) && is_usable(v.z);
}

bool is_usable(const ImportedLight& light) {
    const bool has_place =
        light.kind == LightKind::distant
            ? is_usable(light.direction_world) && glm::length(light.direction_world) > 0
            : is_usable(light.p_world);
    return has_place && is_usable(glm::dvec3(light.color)) && is_usable(light.range) &&
           light.range >= 0;
}

double brightest(const glm::dvec3& color) {
    return std::max({color.r, color.g, color.b});
}

/// A lamp and how it moves; its colour as doubles until it is made a share of the brightest.
struct Lamp {
    scene::OmniLight light;
    scene::LightMotion motion;
    glm::dvec3 color{0};
};

Lamp make_lamp(const ImportedLight& from, const scene::Sphere& bounds) {
    Lamp lamp;
    lamp.color = from.color;
    lamp.light.p_world = from.p_world;
    const double radius = bounds.radius > 0 ? bounds.radius : 1;
    if (from.kind == LightKind::distant) {
        lamp.light.p_world =
            bounds.center_world - glm::normalize(from.direction_world) * (kFarRadii * radius);
        return lamp;
    }
    lamp.light.range = from.range;
    // Light thins out with the square of the way (which no lamp of the shading's does); from
    // within the scene as from its rim.
    const double way = std::max(glm::length(from.p_world - bounds.center_world), radius);
    lamp.color *= 1 / (way * way);
    return lamp;
}

/// Hangs the lamp on a node; one that is squeezed flat carries nothing.
void hang(std::uint32_t node, const std::vector<glm::dmat4>& world_from_node, Lamp& lamp) {
    const glm::dvec3 p_node =
        glm::inverse(world_from_node[node]) * glm::dvec4(lamp.light.p_world, 1);
    if (!is_usable(p_node)) return;
    lamp.motion.node = node;
    lamp.motion.p_node = p_node;
}

/// A line such as "2 spotlights shine to all sides", nothing for none.
void note(std::size_t count, const char* one, const char* many, scene::Scene& scene) {
    if (count == 0) return;
    scene.file.notes.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
}

/// Makes the brightest lamp 1.
void balance(std::vector<Lamp>& lamps) {
    double most = 0;
    for (const Lamp& lamp : lamps)
        most = std::max(most, brightest(lamp.color));
    if (!(most > 0)) return;
    for (Lamp& lamp : lamps)
        lamp.color *= 1 / most;
}

}  // namespace

void take_lights(const std::vector<ImportedLight>& lights,
                 const std::shared_ptr<scene::Animation>& animation,
                 scene::Scene& scene) {
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    const auto world_from_node =
        animation ? scene::world_from_nodes(*animation, std::nullopt) : std::vector<glm::dmat4>{};
    std::vector<Lamp> lamps;
    std::size_t unusable = 0;
    std::size_t too_many = 0;
    for (const ImportedLight& from : lights) {
        if (!is_usable(from)) {
            ++unusable;
            continue;
        }
        Lamp lamp = make_lamp(from, bounds);
        if (lamp.color == glm::dvec3{0}) continue;
        if (lamps.size() == kMostLights) {
            ++too_many;
            continue;
        }
        if (from.node < world_from_node.size() && animation->is_moving(from.node))
            hang(from.node, world_from_node, lamp);
        lamps.push_back(std::move(lamp));
    }
    balance(lamps);
    const auto spots = std::ranges::count(lights, LightKind::spot, &ImportedLight::kind);
    note(static_cast<std::size_t>(spots),
         "spotlight shines to all sides",
         "spotlights shine to all sides",
         scene);
    note(unusable,
         "light of impossible numbers is not heeded",
         "lights of impossible numbers are not heeded",
         scene);
    note(too_many,
         "light beyond the 64th is not heeded",
         "lights beyond the 64th are not heeded",
         scene);
    bool is_any_moving = false;
    std::vector<scene::LightMotion> motions;
    for (Lamp& lamp : lamps) {
        lamp.light.color = lamp.color;
        scene.lights.push_back(lamp.light);
        is_any_moving = is_any_moving || lamp.motion.node != scene::kNoNode;
        motions.push_back(lamp.motion);
    }
    if (animation && is_any_moving) animation->lights = std::move(motions);
}

}  // namespace ink::import
