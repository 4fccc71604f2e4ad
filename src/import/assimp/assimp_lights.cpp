#include "import/assimp/assimp_lights.h"

#include <assimp/light.h>

#include <cmath>
#include <glm/matrix.hpp>

namespace ink::import {
namespace {

LightKind kind_of(aiLightSourceType type) {
    switch (type) {
        case aiLightSource_DIRECTIONAL:
            return LightKind::distant;
        case aiLightSource_SPOT:
            return LightKind::spot;
        case aiLightSource_AREA:
            return LightKind::area;
        case aiLightSource_AMBIENT:
            return LightKind::ambient;
        default:
            return LightKind::point;
    }
}

/// The range at which a lamp of ours has lost half of its light where the file's has; 0 for one
/// that loses none. The file's, 1 / (c + l d + q d^2), has no end. Its full light is what it has at
/// d = 0, or 1 where that is without bounds.
double range_of(const aiLight& light) {
    const double c = light.mAttenuationConstant;
    const double l = light.mAttenuationLinear;
    const double q = light.mAttenuationQuadratic;
    const bool is_unset = c == 0 && l == 1 && q == 0;  // as Assimp makes a light
    const double half = 2 * (c > 0 ? c : 1) - c;
    if (is_unset || !(l >= 0 && q >= 0 && l + q > 0)) return 0;
    const double half_way = q > 0 ? (std::sqrt(l * l + 4 * q * half) - l) / (2 * q) : half / l;
    return std::isfinite(half_way) ? 2 * half_way : 0;
}

}  // namespace

std::vector<ImportedLight> convert_lights(const aiScene& scene,
                                          const std::vector<PlacedNode>& nodes) {
    std::vector<ImportedLight> lights;
    if (nodes.empty()) return lights;
    // Ways are in the file's units, which the root makes the world's.
    const glm::dmat3 root(nodes.front().world_from_node);
    const double stretch = std::cbrt(std::abs(glm::determinant(root)));
    const NodeNumbers numbers = numbers_of(nodes);
    for (unsigned i = 0; i < scene.mNumLights; ++i) {
        const aiLight& from = *scene.mLights[i];
        const auto home = numbers.find(from.mName.C_Str());
        const bool is_placed = home != numbers.end();
        const glm::dmat4 world = is_placed ? nodes[home->second].world_from_node : glm::dmat4{1};
        ImportedLight& light = lights.emplace_back();
        light.kind = kind_of(from.mType);
        light.p_world = world * glm::dvec4(to_glm(from.mPosition), 1);
        light.direction_world = glm::dmat3(world) * to_glm(from.mDirection);
        light.color = {from.mColorDiffuse.r, from.mColorDiffuse.g, from.mColorDiffuse.b};
        light.range = range_of(from) * stretch;
        light.node = is_placed ? home->second : scene::kNoNode;
    }
    return lights;
}

}  // namespace ink::import
