#include "shade/tones.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "shade/lamps.h"

namespace ink::shade {

Tone tone_at(const glm::dvec3& p_world,
             const glm::dvec3& n_world,
             std::span<const scene::OmniLight> lamps,
             const glm::vec3& ambient) {
    Tone tone{light_at(p_world, n_world, lamps, ambient), 0};
    if (lamps.empty()) return tone;
    const glm::dvec3 to_key = lamps.front().p_world - p_world;
    const double distance = glm::length(to_key);
    if (distance > 0) tone.cosine = static_cast<float>(glm::dot(n_world, to_key) / distance);
    return tone;
}

float brightness(const glm::vec3& light) {
    return std::clamp(0.299F * light.r + 0.587F * light.g + 0.114F * light.b, 0.0F, 1.0F);
}

SurfaceTones make_tones(const scene::Surface& surface,
                        const UniformSpots& spots,
                        std::span<const scene::OmniLight> lamps,
                        const glm::vec3& ambient) {
    SurfaceTones tones;
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1 : -1;
        tones.vertices[side].reserve(surface.p_world.size());
        for (std::size_t i = 0; i < surface.p_world.size(); ++i) {
            tones.vertices[side].push_back(
                tone_at(surface.p_world[i], sign * glm::dvec3(surface.n_world[i]), lamps, ambient));
        }
        tones.spots[side].reserve(spots.spots.size());
        for (const UniformSpots::Spot& spot : spots.spots)
            tones.spots[side].push_back(tone_at(spot.p_world, sign * spot.n_world, lamps, ambient));
    }
    return tones;
}

}  // namespace ink::shade
