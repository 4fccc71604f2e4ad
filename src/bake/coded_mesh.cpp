#include "bake/coded_mesh.h"

#include <glm/trigonometric.hpp>
#include <unordered_map>

#include "bake/flat_codes.h"
#include "buffers/id_pass.h"
#include "methods/surface_codes/baked_codes.h"
#include "scene/surface.h"

namespace ink::bake {
namespace {

constexpr double kCrease_deg = 40;       ///< of the methods' patches and normals
constexpr double kHullCrease_deg = 180;  ///< of inverted_hull's: it keeps together

/// Corners that share position and both normals.
struct SharedCorners {
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> of_patch;  ///< per vertex, into the surface over patches
    std::vector<std::uint32_t> of_hull;   ///< per vertex, into the surface of the hull
};

SharedCorners shared_corners(const scene::Surface& patches, const scene::Surface& hull) {
    SharedCorners corners;
    corners.indices.reserve(3 * patches.triangles.size());
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    known.reserve(patches.p_world.size());
    for (std::size_t t = 0; t < patches.triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t patch = patches.triangles[t][i];
            const std::uint32_t whole = hull.triangles[t][i];
            const auto next = static_cast<std::uint32_t>(corners.of_patch.size());
            const auto [place, is_new] =
                known.try_emplace(std::uint64_t{patch} << 32U | whole, next);
            if (is_new) {
                corners.of_patch.push_back(patch);
                corners.of_hull.push_back(whole);
            }
            corners.indices.push_back(place->second);
        }
    }
    return corners;
}

}  // namespace

CodedMesh coded_mesh(const scene::PreparedScene& scene) {
    const auto patches = scene.surface(scene::NormalSource::patch, glm::radians(kCrease_deg));
    const auto hull = scene.surface(scene::NormalSource::patch, glm::radians(kHullCrease_deg));
    const SharedCorners corners = shared_corners(*patches, *hull);

    const buffers::IdParams id_params;
    const std::vector<std::uint32_t> ids = buffers::surface_ids(
        scene, id_params.of, {glm::radians(id_params.crease_deg), id_params.weld_epsilon});
    const std::vector<std::uint32_t> surface8 =
        methods::baked_codes(scene, methods::BakedMethod::surface8, kCrease_deg);
    const std::vector<std::uint32_t> label8 =
        methods::baked_codes(scene, methods::BakedMethod::label8, kCrease_deg);
    std::vector<std::uint64_t> codes(ids.size());
    for (std::size_t t = 0; t < codes.size(); ++t)
        codes[t] = std::uint64_t{ids[t]} << 16U | std::uint64_t{label8[t]} << 8U | surface8[t];

    FlatCodes flat = flat_codes(corners.indices, corners.of_patch.size(), codes);
    CodedMesh mesh;
    mesh.added_count = flat.added_count(corners.of_patch.size());
    mesh.indices = std::move(flat.indices);
    for (std::size_t v = 0; v < flat.source_vertex.size(); ++v) {
        const std::uint32_t source = flat.source_vertex[v];
        mesh.p_world.emplace_back(patches->p_world[corners.of_patch[source]]);
        mesh.n_world.push_back(patches->n_world[corners.of_patch[source]]);
        mesh.hull_n_world.push_back(hull->n_world[corners.of_hull[source]]);
        mesh.surface8.push_back(static_cast<std::uint8_t>(flat.codes[v] & 0xffU));
        mesh.label8.push_back(static_cast<std::uint8_t>(flat.codes[v] >> 8U & 0xffU));
        mesh.id.push_back(static_cast<std::uint32_t>(flat.codes[v] >> 16U));
    }
    return mesh;
}

}  // namespace ink::bake
