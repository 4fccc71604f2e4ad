#include "shade/lamps.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ink::shade {

double reach(const scene::OmniLight& lamp, double distance) {
    if (!(lamp.range > 0) || distance <= lamp.inner_range) return 1;
    if (distance >= lamp.range) return 0;
    return 1 - (distance - lamp.inner_range) / (lamp.range - lamp.inner_range);
}

glm::vec3 light_at(const glm::dvec3& p_world,
                   const glm::dvec3& n_world,
                   std::span<const scene::OmniLight> lamps,
                   const glm::vec3& ambient) {
    glm::vec3 light = ambient;
    for (const scene::OmniLight& lamp : lamps) {
        const glm::dvec3 to_lamp = lamp.p_world - p_world;
        const double distance = glm::length(to_lamp);
        if (distance == 0) continue;  // it shines from within the surface, in no direction
        const double cosine = std::max(0.0, glm::dot(n_world, to_lamp) / distance);
        light += lamp.color * static_cast<float>(cosine * reach(lamp, distance));
    }
    return light;
}

std::vector<scene::OmniLight> studio_lamps(const scene::Camera& camera,
                                           const scene::Sphere& bounds) {
    const glm::dmat3 world_from_view = glm::transpose(camera.view_from_world);
    const double r = bounds.radius > 0 ? bounds.radius : 1;
    const auto beside = [&](double right, double up, double back) {
        return bounds.center_world + world_from_view * (r * glm::dvec3(right, up, back));
    };
    return {{.p_world = beside(-1.5, 2, 2.5), .color = {0.75F, 0.74F, 0.7F}, .range = 0},
            {.p_world = beside(1.8, 0.3, 0.8), .color = {0.3F, 0.45F, 0.7F}, .range = 2.4 * r},
            {.p_world = beside(-0.4, -1.6, 0.6), .color = {0.7F, 0.4F, 0.3F}, .range = 2 * r}};
}

}  // namespace ink::shade
