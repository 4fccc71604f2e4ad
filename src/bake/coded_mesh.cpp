#include "bake/coded_mesh.h"

#include <array>
#include <glm/trigonometric.hpp>
#include <utility>

#include "bake/flat_codes.h"
#include "buffers/id_pass.h"
#include "core/numbering.h"
#include "methods/surface_codes/baked_codes.h"
#include "scene/surface.h"

namespace ink::bake {
namespace {

constexpr double kCrease_deg = 40;       ///< of the methods' patches and normals
constexpr double kHullCrease_deg = 180;  ///< of inverted_hull's: it keeps together

/// Corners that share position and both normals: a vertex of the surface over patches, and one of
/// the hull's.
struct SharedCorners {
    std::vector<std::uint32_t> indices;
    std::vector<std::array<std::uint32_t, 2>> vertices;
};

SharedCorners shared_corners(const scene::Surface& patches, const scene::Surface& hull) {
    SharedCorners corners;
    corners.indices.reserve(3 * patches.triangles.size());
    core::Numbering<std::array<std::uint32_t, 2>> known(patches.p_world.size());
    for (std::size_t t = 0; t < patches.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            corners.indices.push_back(
                known.insert({patches.triangles[t][i], hull.triangles[t][i]}).first);
    corners.vertices = std::move(known.keys());
    return corners;
}

/// Numbers vertices as triangles come to them, and gives the numbers that they had.
std::vector<std::uint32_t> put_in_order(std::vector<std::uint32_t>& indices) {
    core::Numbering<std::uint32_t> order(indices.size() / 3);
    for (std::uint32_t& index : indices)
        index = order.insert(index).first;
    return std::move(order.keys());
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

    FlatCodes flat = flat_codes(corners.indices, corners.vertices.size(), codes);
    std::vector<std::uint32_t> corner_of(corners.vertices.size());
    for (std::size_t i = 0; i < corners.indices.size(); ++i)
        corner_of[corners.indices[i]] = static_cast<std::uint32_t>(i);
    CodedMesh mesh;
    mesh.added_count = flat.added_count(corners.vertices.size());
    mesh.indices = std::move(flat.indices);
    mesh.lookup = methods::lookup_table(scene, kCrease_deg);
    for (const std::uint32_t v : put_in_order(mesh.indices)) {
        mesh.corners.push_back(corner_of[flat.source_vertex[v]]);
        mesh.surface8.push_back(static_cast<std::uint8_t>(flat.codes[v] & 0xffU));
        mesh.label8.push_back(static_cast<std::uint8_t>(flat.codes[v] >> 8U & 0xffU));
        mesh.id.push_back(static_cast<std::uint32_t>(flat.codes[v] >> 16U));
    }
    static_cast<MovingVertices&>(mesh) = posed_vertices(mesh, scene);
    return mesh;
}

MovingVertices posed_vertices(const CodedMesh& mesh, const scene::PreparedScene& posed) {
    const auto patches = posed.surface(scene::NormalSource::patch, glm::radians(kCrease_deg));
    const auto hull = posed.surface(scene::NormalSource::patch, glm::radians(kHullCrease_deg));
    MovingVertices vertices;
    for (const std::uint32_t corner : mesh.corners) {
        const std::uint32_t of_patch = patches->triangles[corner / 3][corner % 3];
        vertices.p_world.emplace_back(patches->p_world[of_patch]);
        vertices.n_world.push_back(patches->n_world[of_patch]);
        vertices.hull_n_world.push_back(hull->n_world[hull->triangles[corner / 3][corner % 3]]);
    }
    return vertices;
}

}  // namespace ink::bake
