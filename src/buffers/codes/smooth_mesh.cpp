#include "buffers/codes/smooth_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "core/disjoint_sets.h"
#include "core/hash.h"
#include "scene/rounding.h"
#include "scene/sharing/shared_work.h"
#include "scene/surface.h"

namespace ink::buffers {
namespace {

/// Numbers sets in the order of their first members; returns how many there are.
std::uint32_t number_sets(core::DisjointSets& sets, std::vector<std::uint32_t>& numbers) {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < numbers.size(); ++i) {
        const std::uint32_t root = sets.root(i);  // the lowest: numbered before the others
        numbers[i] = root == i ? count++ : numbers[root];
    }
    return count;
}

/// Which edge of a face.
std::uint32_t side_of(const scene::Face& face, std::uint32_t edge) {
    return face.edges[0] == edge ? 0U : face.edges[1] == edge ? 1U : 2U;
}

struct PlaceHash {
    std::size_t operator()(const glm::dvec3& p) const { return core::Hasher().value(p).result(); }
};

SmoothMesh cut_into_patches(const scene::Scene& scene, const PatchOptions& options) {
    SmoothMesh mesh;
    mesh.topology = scene::weld(scene, {.epsilon = options.weld_epsilon});
    const scene::Topology& topology = mesh.topology;
    const auto count = static_cast<std::uint32_t>(topology.faces.size());
    mesh.across.assign(std::size_t{3} * count, SmoothMesh::kNone);
    core::DisjointSets patches(count);
    core::DisjointSets fans(std::size_t{3} * count);
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
        const scene::Edge& edge = topology.edges[e];
        const auto faces = topology.faces_of(edge);
        const bool is_smooth =
            edge.face_count == 2 &&
            topology.faces[faces[0]].object == topology.faces[faces[1]].object &&
            !scene::is_crease(topology, edge, faces[0], faces[1], options.crease_rad);
        if (!is_smooth) {
            for (std::size_t i = 1; i < faces.size(); ++i)
                mesh.borders.push_back({faces[i - 1], faces[i], e});
            continue;
        }
        const std::uint32_t f = faces[0], g = faces[1];
        patches.join(f, g);
        fans.join(mesh.corner_at(f, edge.a), mesh.corner_at(g, edge.a));
        fans.join(mesh.corner_at(f, edge.b), mesh.corner_at(g, edge.b));
        mesh.across[3 * f + side_of(topology.faces[f], e)] = g;
        mesh.across[3 * g + side_of(topology.faces[g], e)] = f;
    }
    mesh.patch_of.resize(count);
    mesh.patch_count = number_sets(patches, mesh.patch_of);
    mesh.fan_of.resize(std::size_t{3} * count);
    mesh.fan_count = number_sets(fans, mesh.fan_of);
    return mesh;
}

}  // namespace

SmoothMesh make_smooth_mesh(const scene::Scene& scene, const PatchOptions& options) {
    const std::string name =
        fmt::format("smooth mesh {} {}", options.crease_rad, options.weld_epsilon);
    return scene::shared(scene, name, [&] { return cut_into_patches(scene, options); });
}

std::vector<std::uint32_t> faces_of_triangles(const scene::Scene& scene,
                                              const scene::Topology& topology) {
    std::vector<std::uint32_t> face_of(scene::triangle_count(scene), SmoothMesh::kNone);
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f)
        face_of[topology.faces[f].triangle] = f;
    if (topology.faces.size() == face_of.size()) return face_of;
    const scene::Surface surface = scene::flatten(scene);
    const auto places = [&](std::uint32_t triangle) {
        std::array<glm::dvec3, 3> p{};
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = surface.p_world[surface.triangles[triangle][i]] + 0.0;  // -0 is 0
        return p;
    };
    // Only places of triangles that became no face: they are few. Which faces have a corner there?
    std::unordered_map<glm::dvec3, std::vector<std::uint32_t>, PlaceHash> faces_at;
    for (std::uint32_t t = 0; t < face_of.size(); ++t) {
        if (face_of[t] != SmoothMesh::kNone) continue;
        for (const glm::dvec3& p : places(t))
            faces_at.try_emplace(p);
    }
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
        for (const glm::dvec3& p : places(topology.faces[f].triangle)) {
            const auto found = faces_at.find(p);
            if (found != faces_at.end()) found->second.push_back(f);
        }
    }
    for (std::uint32_t t = 0; t < face_of.size(); ++t) {
        if (face_of[t] != SmoothMesh::kNone) continue;
        // The face that shares most corners with it, the first of those that share as many.
        std::vector<std::uint32_t> met;
        for (const glm::dvec3& p : places(t)) {
            const auto& faces = faces_at[p];
            met.insert(met.end(), faces.begin(), faces.end());
        }
        std::sort(met.begin(), met.end());
        std::ptrdiff_t most = 0;
        for (auto run = met.begin(); run != met.end();) {
            const auto end = std::upper_bound(run, met.end(), *run);
            if (end - run > most) {
                most = end - run;
                face_of[t] = *run;
            }
            run = end;
        }
    }
    return face_of;
}

}  // namespace ink::buffers
