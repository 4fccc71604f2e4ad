#include "bake/edge_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "core/error.h"
#include "core/numbering.h"
#include "scene/surface.h"
#include "scene/topology.h"

namespace ink::bake {
namespace {

using methods::SmoothMesh;

/// Normals that differ by less are those of one plane: rounded coordinates give as much.
constexpr double kFlat_rad = 1e-4;
/// How much of an edge may be left uncovered: vertices are welded, no better.
constexpr double kUncovered = 1e-3;

/// What lies on a boundary edge of others: stretches in shares of its length.
struct Cover {
    std::vector<std::pair<double, double>> stretches;
    std::uint32_t face = SmoothMesh::kNone;  ///< one that goes on there
    bool has_longer = false;                 ///< an edge that sticks out over its ends

    [[nodiscard]] bool is_whole() {
        std::sort(stretches.begin(), stretches.end());
        double end = 0;
        for (const auto& [from, to] : stretches) {
            if (from > end + kUncovered) return false;
            end = std::max(end, to);
        }
        return end >= 1 - kUncovered;
    }
};

class EdgeSorter {
  public:
    explicit EdgeSorter(const SmoothMesh& mesh) : mesh_(mesh), topology_(mesh.topology) {}

    [[nodiscard]] std::vector<KnownEdge> sorted() {
        std::vector<KnownEdge> edges(topology_.edges.size(), {.kind = EdgeKind::hard});
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            const auto faces = topology_.faces_of(topology_.edges[e]);
            if (faces.size() != 2) continue;
            const auto& face = topology_.faces[faces[0]];
            if (mesh_.across[3 * faces[0] + scene::side_at(face, e)] != faces[1]) continue;
            edges[e] =
                between(faces[0], faces[1], is_turned(e, faces[0]) == is_turned(e, faces[1]));
        }
        find_covers();
        for (auto& [e, cover] : covers_) {
            if (!cover.is_whole()) continue;
            const std::uint32_t own = topology_.faces_of(topology_.edges[e])[0];
            edges[e] = between(own, cover.face, is_inconsistent_beside(e, own, cover.face));
            // Those within it are drawn, all of its length.
            if (!cover.has_longer && cover.stretches.size() > 1) edges[e] = {};
        }
        return edges;
    }

  private:
    [[nodiscard]] bool is_turned(std::uint32_t edge, std::uint32_t face) const {
        return scene::runs_forward(topology_.faces[face], topology_.edges[edge]);
    }
    [[nodiscard]] const glm::dvec3& p(std::uint32_t vertex) const {
        return topology_.p_world[vertex];
    }
    [[nodiscard]] glm::dvec3 middle(std::uint32_t face) const {
        const auto& [a, b, c] = topology_.faces[face].vertices;
        return (p(a) + p(b) + p(c)) / 3.0;
    }

    /// Whether a face beside a boundary edge, on its other side, turns its back where the edge's
    /// own face turns its front: it then has this one in front of it, seen flat.
    [[nodiscard]] bool is_inconsistent_beside(std::uint32_t e,
                                              std::uint32_t own,
                                              std::uint32_t other) const {
        // Both turned into one plane round the edge: left of it as its face runs, and right.
        const scene::Edge& edge = topology_.edges[e];
        const glm::dvec3 along = is_turned(e, own) ? p(edge.b) - p(edge.a) : p(edge.a) - p(edge.b);
        const auto runs_along = [&](std::uint32_t face) {
            const glm::dvec3 inward = middle(face) - p(edge.a);
            return glm::dot(glm::cross(along, inward), topology_.area_vector(face)) > 0;
        };
        return runs_along(own) == runs_along(other);
    }

    [[nodiscard]] KnownEdge between(std::uint32_t f, std::uint32_t g, bool is_inconsistent) const {
        const glm::dvec3 one = topology_.area_vector(f);
        const glm::dvec3 two = topology_.area_vector(g) * (is_inconsistent ? -1.0 : 1.0);
        const double bend_rad = std::atan2(glm::length(glm::cross(one, two)), glm::dot(one, two));
        return {.kind = bend_rad > kFlat_rad ? EdgeKind::silhouette : EdgeKind::hidden,
                .triangles = {topology_.faces[f].triangle, topology_.faces[g].triangle},
                .is_inconsistent = is_inconsistent};
    }

    /// The boundary edge of a face that lies nearest to the line through another; kNone if it has
    /// none.
    [[nodiscard]] std::uint32_t nearest_boundary(std::uint32_t face, std::uint32_t line) const {
        const glm::dvec3 a = p(topology_.edges[line].a);
        const glm::dvec3 along = glm::normalize(p(topology_.edges[line].b) - a);
        std::uint32_t nearest = SmoothMesh::kNone;
        double least = 0;
        for (const std::uint32_t e : topology_.faces[face].edges) {
            const scene::Edge& edge = topology_.edges[e];
            if (edge.face_count != 1) continue;
            const double off = std::max(glm::length(glm::cross(along, p(edge.a) - a)),
                                        glm::length(glm::cross(along, p(edge.b) - a)));
            if (nearest != SmoothMesh::kNone && off >= least) continue;
            nearest = e;
            least = off;
        }
        return nearest;
    }

    /// Adds to an edge the stretch that another one covers.
    void cover(std::uint32_t e, std::uint32_t by, std::uint32_t face) {
        const glm::dvec3 a = p(topology_.edges[e].a);
        const glm::dvec3 whole = p(topology_.edges[e].b) - a;
        const auto at = [&](std::uint32_t vertex) {
            return glm::dot(p(vertex) - a, whole) / glm::dot(whole, whole);
        };
        const auto [from, to] = std::minmax({at(topology_.edges[by].a), at(topology_.edges[by].b)});
        Cover& of = covers_[e];
        of.stretches.emplace_back(std::max(from, 0.0), std::min(to, 1.0));
        of.has_longer = of.has_longer || from < -kUncovered || to > 1 + kUncovered;
        if (of.face == SmoothMesh::kNone) of.face = face;
    }

    void find_covers() {
        for (const methods::FacePair& pair : mesh_.touching) {
            // The edge is that of one of the two.
            const std::uint32_t own = topology_.faces_of(topology_.edges[pair.edge])[0];
            const std::uint32_t beside = own == pair.face0 ? pair.face1 : pair.face0;
            const std::uint32_t other = nearest_boundary(beside, pair.edge);
            if (other == SmoothMesh::kNone) continue;
            cover(pair.edge, other, beside);
            cover(other, pair.edge, own);
        }
    }

    const SmoothMesh& mesh_;
    const scene::Topology& topology_;
    std::map<std::uint32_t, Cover> covers_;
};

/// The edges of triangles that became no face, between corners where faces have some.
void find_lost(const scene::Surface& surface, const scene::Topology& topology, SceneEdges& result) {
    const auto place = [&](std::uint32_t triangle, std::size_t corner) {
        return surface.p_world[surface.triangles[triangle][corner]] + 0.0;  // -0 is 0
    };
    core::Numbering<glm::dvec3> places(topology.p_world.size());
    for (const scene::Face& face : topology.faces)
        for (std::size_t i = 0; i < 3; ++i)
            places.insert(place(face.triangle, i));
    core::Numbering<std::array<std::uint32_t, 2>> edges(topology.edges.size());
    for (const scene::Edge& edge : topology.edges)
        edges.insert({edge.a, edge.b});
    for (const auto& [triangle, vertices, face] : topology.lost) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            if (!places.find(place(triangle, i)) || !places.find(place(triangle, next))) continue;
            const auto [a, b] = std::minmax(vertices[i], vertices[next]);
            result.of_triangle[triangle][i] = edges.find({a, b}).value_or(SceneEdges::kNone);
        }
    }
}

constexpr int kFloat = 5126, kVisibilityType = 5121;  // bytes

constexpr import::AccessorRule kPosition{"POSITION", "VEC3", import::kFloat | import::kSmall};

/// Outward normals of the triangles of a file, in object space, by their places in the scene.
class FileNormals {
  public:
    explicit FileNormals(const std::vector<BakedPrimitive>& primitives) : primitives_(primitives) {}

    /// Of length 1; 0 for a triangle without area, or of no primitive.
    [[nodiscard]] glm::dvec3 of(std::size_t scene_triangle) {
        const auto next = std::ranges::upper_bound(
            primitives_, scene_triangle, {}, &BakedPrimitive::first_triangle);
        if (next == primitives_.begin()) return glm::dvec3(0);
        const BakedPrimitive& primitive = *std::prev(next);
        const std::size_t t = scene_triangle - primitive.first_triangle;
        if (t >= primitive.triangles.size()) return glm::dvec3(0);
        // As the file had it: copied vertices are not in its accessors.
        auto& known = known_[&primitive];
        if (known.numbers.empty()) {
            import::GltfPrimitive source = primitive.source;
            known.numbers = source.numbers("POSITION", kPosition, 3);
            known.triangles = source.triangles();
        }
        const auto& [a, b, c] = known.triangles[t];
        const glm::dvec3 normal =
            glm::cross(known.place(b) - known.place(a), known.place(c) - known.place(a));
        const double length = glm::length(normal);
        return length > 0 ? normal / length : glm::dvec3(0);
    }

  private:
    struct Shape {
        std::vector<double> numbers;
        std::vector<scene::Triangle> triangles;
        [[nodiscard]] glm::dvec3 place(std::size_t vertex) const {
            return {numbers[3 * vertex], numbers[3 * vertex + 1], numbers[3 * vertex + 2]};
        }
    };

    const std::vector<BakedPrimitive>& primitives_;
    std::map<const BakedPrimitive*, Shape> known_;
};

/// The edges of a primitive's triangles in the order that these have in the baked file.
std::vector<std::array<std::uint32_t, 3>> edges_of(const BakedPrimitive& primitive,
                                                   const SceneEdges& edges) {
    std::vector<std::array<std::uint32_t, 3>> turned(primitive.triangles.size());
    for (std::size_t t = 0; t < turned.size(); ++t) {
        const auto& own = edges.of_triangle[primitive.first_triangle + t];
        for (std::size_t i = 0; i < 3; ++i)
            turned[t][i] = own[(i + primitive.turns[t]) % 3];
    }
    return turned;
}

void append(const glm::dvec3& normal, std::vector<float>& to) {
    for (int axis = 0; axis < 3; ++axis)
        to.push_back(static_cast<float>(normal[axis]));
}

/// Of the silhouette edges among the values, in their order.
std::vector<float> normals_of(const BakedPrimitive& primitive,
                              const std::vector<std::array<std::uint32_t, 3>>& own,
                              const std::vector<std::uint8_t>& values,
                              const SceneEdges& edges,
                              FileNormals& normals) {
    std::vector<float> numbers;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] != kSilhouette) continue;
        const KnownEdge& edge = edges.edges[own[i / 3][i % 3]];
        // The triangle's own normal comes first.
        const std::size_t triangle = primitive.first_triangle + i / 3;
        const bool is_second = edge.triangles[1] == triangle;
        glm::dvec3 one = normals.of(edge.triangles[is_second ? 1 : 0]);
        glm::dvec3 two = normals.of(edge.triangles[is_second ? 0 : 1]);
        if (edge.is_inconsistent) two = -two;
        if (one == glm::dvec3(0)) one = two == glm::dvec3(0) ? glm::dvec3(0, 0, 1) : two;
        if (two == glm::dvec3(0)) two = one;
        append(one, numbers);
        append(two, numbers);
    }
    return numbers;
}

}  // namespace

SceneEdges find_edges(const scene::PreparedScene& scene, const SmoothMesh& mesh) {
    const scene::Topology& topology = mesh.topology;
    SceneEdges result;
    result.edges = EdgeSorter(mesh).sorted();
    result.of_triangle.assign(scene::triangle_count(scene),
                              {SceneEdges::kNone, SceneEdges::kNone, SceneEdges::kNone});
    for (const scene::Face& face : topology.faces)
        result.of_triangle[face.triangle] = face.edges;
    if (!topology.lost.empty()) find_lost(*scene.surface(), topology, result);
    // Mirrored triangles were taken with their last two corners swapped: edges the other way round.
    std::size_t t = 0;
    for (const scene::Instance& instance : scene->instances) {
        const std::size_t count = scene->meshes[instance.mesh].triangles.size();
        for (std::size_t i = 0; i < count && scene::is_mirrored(instance); ++i)
            std::swap(result.of_triangle[t + i][0], result.of_triangle[t + i][2]);
        t += count;
    }
    return result;
}

std::vector<std::uint8_t> edge_visibility(std::span<const std::array<std::uint32_t, 3>> triangles,
                                          std::span<const KnownEdge> edges) {
    std::vector<bool> is_known(edges.size(), false);
    std::vector<std::uint8_t> values;
    values.reserve(3 * triangles.size());
    for (const auto& triangle : triangles) {
        for (const std::uint32_t e : triangle) {
            if (e == SceneEdges::kNone || edges[e].kind == EdgeKind::hidden) {
                values.push_back(kHidden);
            } else if (edges[e].kind == EdgeKind::hard) {
                values.push_back(is_known[e] ? kHardAgain : kHard);
            } else {
                values.push_back(is_known[e] ? kHidden : kSilhouette);
            }
            if (e != SceneEdges::kNone) is_known[e] = true;
        }
    }
    return values;
}

std::vector<std::byte> packed_visibility(std::span<const std::uint8_t> values) {
    std::vector<std::byte> bytes((2 * values.size() + 7) / 8, std::byte{0});
    for (std::size_t i = 0; i < values.size(); ++i)
        bytes[i / 4] |= static_cast<std::byte>(values[i] << (2 * (i % 4)));
    return bytes;
}

bool has_edges(const BakedPrimitive& primitive) {
    return primitive.source.json().extension(import::kEdgeVisibility).has_value();
}

EdgeCounts add_edges(GltfEdit& edit,
                     const std::vector<BakedPrimitive>& primitives,
                     const SceneEdges& edges,
                     bool is_again) {
    EdgeCounts counts;
    FileNormals normals(primitives);
    for (const BakedPrimitive& primitive : primitives) {
        if (has_edges(primitive) && !is_again) {
            throw core::Error(
                primitive.place(),
                primitive.place() + ": it has edges of its own (" + import::kEdgeVisibility + ")",
                "a model without, or one that inkbench has baked");
        }
        const auto own = edges_of(primitive, edges);
        const std::vector<std::uint8_t> values = edge_visibility(own, edges.edges);
        counts.hard += static_cast<std::size_t>(std::ranges::count(values, kHard));
        if (std::ranges::all_of(values, [](auto value) { return value == kHidden; })) continue;
        const std::vector<std::byte> bytes = packed_visibility(values);
        Json extension = {
            {"visibility",
             edit.add_accessor({{"bufferView", edit.add_view(bytes, 0, GltfEdit::Use::other)},
                                {"componentType", kVisibilityType},
                                {"count", bytes.size()},
                                {"type", "SCALAR"}})}};
        const std::vector<float> pairs = normals_of(primitive, own, values, edges, normals);
        counts.silhouettes += pairs.size() / 6;
        if (!pairs.empty()) {
            const auto of_pairs = std::as_bytes(std::span(pairs));
            extension["silhouetteNormals"] =
                edit.add_accessor({{"bufferView", edit.add_view(of_pairs, 0, GltfEdit::Use::other)},
                                   {"componentType", kFloat},
                                   {"count", pairs.size() / 3},
                                   {"type", "VEC3"}});
        }
        edit.use_extension(import::kEdgeVisibility);
        primitive.json(edit)["extensions"][import::kEdgeVisibility] = std::move(extension);
    }
    return counts;
}

}  // namespace ink::bake
