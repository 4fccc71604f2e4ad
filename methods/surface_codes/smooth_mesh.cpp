#include "methods/surface_codes/smooth_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "core/disjoint_sets.h"
#include "core/hash.h"
#include "scene/precision/rounding.h"
#include "scene/sharing/shared_work.h"
#include "scene/surface.h"

namespace ink::methods {
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

/// Edges of more faces than this part all of them.
constexpr std::size_t kMostPaired = 16;

/// Whether a surface goes on over an edge: from one object to the same, and no crease.
bool is_smooth(const scene::Topology& topology,
               const scene::Edge& edge,
               const FacePair& pair,
               double crease_rad) {
    return topology.faces[pair.face0].object == topology.faces[pair.face1].object &&
           !scene::is_crease(topology, edge, pair.face0, pair.face1, crease_rad);
}

/// Which faces of an edge of more than two go on over it: those that do so with each other alone. A
/// wall goes on behind another that meets it; where three sheets part, none does.
std::vector<FacePair> pairs_of_many(const scene::Topology& topology,
                                    std::uint32_t e,
                                    double crease_rad) {
    const scene::Edge& edge = topology.edges[e];
    const auto faces = topology.faces_of(edge);
    if (faces.size() > kMostPaired) return {};
    std::vector<FacePair> smooth;
    std::vector<int> ways(faces.size(), 0);
    for (std::size_t i = 1; i < faces.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (!is_smooth(topology, edge, {faces[k], faces[i], e}, crease_rad)) continue;
            smooth.push_back({static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(i), e});
            ++ways[k];
            ++ways[i];
        }
    }
    std::erase_if(
        smooth, [&](const FacePair& pair) { return ways[pair.face0] > 1 || ways[pair.face1] > 1; });
    for (FacePair& pair : smooth)
        pair = {faces[pair.face0], faces[pair.face1], e};
    return smooth;
}

struct PlaceHash {
    std::size_t operator()(const glm::dvec3& p) const { return core::Hasher().value(p).result(); }
};

/// The number that is there most often, the lowest of those; kNone of none.
std::uint32_t most_frequent(std::vector<std::uint32_t> numbers) {
    std::sort(numbers.begin(), numbers.end());
    std::uint32_t best = SmoothMesh::kNone;
    std::ptrdiff_t most = 0;
    for (auto run = numbers.begin(); run != numbers.end();) {
        const auto end = std::upper_bound(run, numbers.end(), *run);
        if (end - run > most) {
            most = end - run;
            best = *run;
        }
        run = end;
    }
    return best;
}

SmoothMesh cut_into_patches(const scene::Scene& scene, const buffers::PatchOptions& options) {
    SmoothMesh mesh;
    mesh.topology = scene::weld(scene, {.epsilon = options.weld_epsilon});
    const scene::Topology& topology = mesh.topology;
    const auto count = static_cast<std::uint32_t>(topology.faces.size());
    mesh.across.assign(std::size_t{3} * count, SmoothMesh::kNone);
    core::DisjointSets patches(count);
    core::DisjointSets fans(std::size_t{3} * count);
    const auto join = [&](const FacePair& pair) {
        const auto [f, g, e] = pair;
        const scene::Edge& edge = topology.edges[e];
        patches.join(f, g);
        fans.join(mesh.corner_at(f, edge.a), mesh.corner_at(g, edge.a));
        fans.join(mesh.corner_at(f, edge.b), mesh.corner_at(g, edge.b));
        mesh.across[3 * f + side_of(topology.faces[f], e)] = g;
        mesh.across[3 * g + side_of(topology.faces[g], e)] = f;
    };
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
        const scene::Edge& edge = topology.edges[e];
        const auto faces = topology.faces_of(edge);
        if (faces.size() == 2) {
            const FacePair pair{faces[0], faces[1], e};
            if (is_smooth(topology, edge, pair, options.crease_rad)) {
                join(pair);
            } else {
                mesh.borders.push_back(pair);
            }
        } else if (faces.size() > 2) {
            for (const FacePair& pair : pairs_of_many(topology, e, options.crease_rad))
                join(pair);
            for (std::size_t i = 1; i < faces.size(); ++i) {
                for (std::size_t k = i < kMostPaired ? 0 : i - 1; k < i; ++k) {
                    const auto& f = topology.faces[faces[k]];
                    if (mesh.across[3 * faces[k] + side_of(f, e)] != faces[i])
                        mesh.borders.push_back({faces[k], faces[i], e});
                }
            }
        }
    }
    mesh.touching = touching_boundaries(topology, options);
    for (const FacePair& pair : mesh.touching)
        patches.join(pair.face0, pair.face1);
    mesh.patch_of.resize(count);
    mesh.patch_count = number_sets(patches, mesh.patch_of);
    mesh.fan_of.resize(std::size_t{3} * count);
    mesh.fan_count = number_sets(fans, mesh.fan_of);
    return mesh;
}

}  // namespace

SmoothMesh make_smooth_mesh(const scene::Scene& scene, const buffers::PatchOptions& options) {
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
    std::vector<std::uint32_t> left;
    for (std::uint32_t t = 0; t < face_of.size(); ++t)
        if (face_of[t] == SmoothMesh::kNone) left.push_back(t);
    // Where welding left no area of many triangles together, those inside follow those round them.
    while (!left.empty()) {
        std::vector<std::uint32_t> found, still;
        for (const std::uint32_t t : left) {
            // The face that shares most corners with it, the first of those that share as many.
            std::vector<std::uint32_t> met;
            for (const glm::dvec3& p : places(t)) {
                const auto& faces = faces_at[p];
                met.insert(met.end(), faces.begin(), faces.end());
            }
            face_of[t] = most_frequent(std::move(met));
            (face_of[t] == SmoothMesh::kNone ? still : found).push_back(t);
        }
        if (found.empty()) break;
        for (const std::uint32_t t : found) {
            for (const glm::dvec3& p : places(t))
                faces_at[p].push_back(face_of[t]);
        }
        left = std::move(still);
    }
    return face_of;
}

}  // namespace ink::methods
