#include "buffers/id_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <numeric>
#include <string>

#include "core/disjoint_sets.h"
#include "core/hash.h"
#include "scene/precision/rounding.h"
#include "scene/topology.h"

namespace ink::buffers {
namespace {

std::vector<std::uint32_t> patch_ids(const scene::PreparedScene& scene,
                                     bool over_objects,
                                     const PatchOptions& options) {
    const auto welded = scene.topology(options.weld_epsilon);
    const scene::Topology& topology = *welded;
    core::DisjointSets patches(topology.faces.size());
    for (const scene::Edge& edge : topology.edges) {
        if (edge.face_count != 2) continue;
        const auto faces = topology.faces_of(edge);
        if (!over_objects && topology.faces[faces[0]].object != topology.faces[faces[1]].object)
            continue;
        if (scene::is_crease(topology, edge, faces[0], faces[1], options.crease_rad)) continue;
        patches.join(faces[0], faces[1]);
    }
    std::vector<std::uint32_t> ids(scene::triangle_count(scene));
    std::iota(ids.begin(), ids.end(), 0U);
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f)
        ids[topology.faces[f].triangle] = topology.faces[patches.root(f)].triangle;
    for (const scene::LostTriangle& lost : topology.lost) {
        if (lost.face != scene::LostTriangle::kNoFace)
            ids[lost.triangle] = ids[topology.faces[lost.face].triangle];
    }
    return ids;
}

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

std::vector<std::uint32_t> surface_ids(const scene::PreparedScene& scene,
                                       IdSource source,
                                       const PatchOptions& options) {
    if (source == IdSource::patch || source == IdSource::object_and_patch) {
        return patch_ids(scene, source == IdSource::patch, options);
    }
    std::vector<std::uint32_t> ids(scene::triangle_count(scene));
    std::iota(ids.begin(), ids.end(), 0U);
    if (source == IdSource::triangle) return ids;
    std::size_t first = 0;
    for (std::uint32_t object = 0; object < scene->instances.size(); ++object) {
        const std::size_t count = scene->meshes[scene->instances[object].mesh].triangles.size();
        std::fill_n(ids.begin() + static_cast<std::ptrdiff_t>(first), count, object);
        first += count;
    }
    return ids;
}

IdPass::IdPass(const IdParams& params, int halo_px)
    : ConstantPass(constant_inputs(params),
                   constant_format(raster::Store::u32, params.depth_format, halo_px),
                   kNoId),
      params_(params) {}

std::vector<std::uint32_t> IdPass::constants_of(const scene::PreparedScene& scene) {
    const PatchOptions options{.crease_rad = glm::radians(params_.crease_deg),
                               .weld_epsilon = params_.weld_epsilon};
    const std::string name = fmt::format(
        "ids {} {} {}", static_cast<int>(params_.of), options.crease_rad, options.weld_epsilon);
    return *scene.get(name, [&] { return surface_ids(scene, params_.of, options); });
}

bool IdPass::follows(const scene::Scene& /*scene*/) const {
    return params_.of == IdSource::patch || params_.of == IdSource::object_and_patch;
}

method::Layer IdPass::layer(const method::Frame& frame) {
    return ConstantPass::layer<std::uint32_t>(frame, "ids", color_of);
}

}  // namespace ink::buffers
