#include "buffers/id_pass.h"

#include <glm/trigonometric.hpp>

#include "core/hash.h"

namespace ink::buffers {
namespace {

/// Each byte 64..255, so that every colour stands out from the sky.
glm::u8vec3 color_of(std::uint32_t id) {
    glm::u8vec3 color{0};
    if (id == kNoId) return color;
    const std::uint64_t bits = core::Hasher().value(id).result();
    for (int i = 0; i < 3; ++i)
        color[i] = static_cast<std::uint8_t>(64 + (bits >> (8 * i + 32) & 0xff) * 191 / 255);
    return color;
}

}  // namespace

IdPass::IdPass(const IdParams& params, int halo_px)
    : ConstantPass(constant_inputs(params),
                   constant_format(raster::Store::u32, params.depth_format, halo_px),
                   kNoId),
      params_(params) {}

std::vector<std::uint32_t> IdPass::constants_of(const scene::Scene& scene) {
    return surface_ids(
        scene,
        params_.of,
        {.crease_rad = glm::radians(params_.crease_deg), .weld_epsilon = params_.weld_epsilon});
}

bool IdPass::follows(const scene::Scene& /*scene*/) const {
    return params_.of == IdSource::patch || params_.of == IdSource::object_and_patch;
}

bool IdPass::prepare_like(const IdPass& other, const scene::Scene& scene) {
    const bool has_same_ids = params_.of == other.params_.of &&
                              params_.crease_deg == other.params_.crease_deg &&
                              params_.weld_epsilon == other.params_.weld_epsilon;
    return ConstantPass::prepare_like(other, scene, has_same_ids);
}

method::Layer IdPass::layer(const method::Frame& frame) {
    return ConstantPass::layer<std::uint32_t>(frame, "ids", color_of);
}

}  // namespace ink::buffers
