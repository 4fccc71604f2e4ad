#include "scene/topology.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/numbering.h"
#include "scene/box.h"
#include "scene/near_points.h"
#include "scene/precision/rounding.h"
#include "scene/precision/written_digits.h"
#include "scene/predicates.h"

namespace ink::scene {
namespace {

constexpr std::uint32_t kFree = 0xffffffffU;

using EdgeKey = std::array<std::uint32_t, 2>;
using FaceKey = std::array<std::uint32_t, 3>;

/// -0 and 0 are one place, and must hash alike.
glm::dvec3 without_negative_zero(const glm::dvec3& p) {
    return p + 0.0;
}

FaceKey sorted(FaceKey key) {
    std::ranges::sort(key);
    return key;
}

glm::dvec3 place(const Instance& instance, const glm::vec3& p_object) {
    return without_negative_zero(to_world(instance, p_object));
}

/// How far a move of one unit along each axis of the object moves a point of the world, at most.
double most_stretched(const Instance& instance) {
    const glm::dmat4& m = instance.world_from_object;
    return glm::length(glm::dvec3(m[0])) + glm::length(glm::dvec3(m[1])) +
           glm::length(glm::dvec3(m[2]));
}

/// Where epsilon moves each place of the scene.
class Moves {
  public:
    /// Nothing moves.
    Moves() : places_(0) {}

    Moves(const Scene& scene, double epsilon) : places_(triangle_count(scene) / 2) {
        std::vector<std::vector<std::uint32_t>> parts;
        for (const Instance& instance : scene.instances)
            parts.push_back(places_of(instance, scene.meshes[instance.mesh]));
        NearPoints near(places_.keys());
        for (const std::vector<std::uint32_t>& part : parts)
            near.add(part, epsilon * diagonal(part));
        moved_ = near.representatives();
        for (std::size_t i = 0; i < moved_.size(); ++i)
            joined_ += moved_[i] != places_.keys()[i];
    }

    [[nodiscard]] bool has_any() const { return joined_ > 0; }
    [[nodiscard]] std::size_t joined() const { return joined_; }
    /// Where a place of the scene goes.
    [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& p) {
        return has_any() ? moved_[places_.insert(p).first] : p;
    }
    /// Whether they leave the corners of a triangle where they are.
    [[nodiscard]] bool leave(const Instance& instance, const Mesh& mesh, const Triangle& t) {
        return std::ranges::all_of(t, [&](std::uint32_t v) {
            const glm::dvec3 p = place(instance, mesh.positions[v]);
            return (*this)(p) == p;
        });
    }

  private:
    /// The places that the triangles of an instance use, each once.
    std::vector<std::uint32_t> places_of(const Instance& instance, const Mesh& mesh) {
        const std::vector<bool> is_used = used_vertices(mesh);
        std::vector<std::uint32_t> part;
        for (std::size_t v = 0; v < is_used.size(); ++v) {
            if (is_used[v])
                part.push_back(places_.insert(place(instance, mesh.positions[v])).first);
        }
        std::ranges::sort(part);
        part.erase(std::unique(part.begin(), part.end()), part.end());
        return part;
    }

    [[nodiscard]] double diagonal(const std::vector<std::uint32_t>& part) {
        Box box;
        for (const std::uint32_t i : part)
            box.add(places_.keys()[i]);
        return box.diagonal();
    }

    core::Numbering<glm::dvec3> places_;
    std::vector<glm::dvec3> moved_;
    std::size_t joined_ = 0;
};

/// The marks of a triangle whose corners 1 and 2 change places: sides 0 and 2 do.
std::uint8_t with_ends_swapped(unsigned sides) {
    return static_cast<std::uint8_t>((sides & 2U) | (sides & 1U) << 2 | (sides >> 2 & 1U));
}

/// Whether the triangle has an area before anything is moved.
bool has_area(const Instance& instance, const Mesh& mesh, const Triangle& t) {
    return !is_collinear(place(instance, mesh.positions[t[0]]),
                         place(instance, mesh.positions[t[1]]),
                         place(instance, mesh.positions[t[2]]));
}

/// Places, welds and filters the triangles; fills p_world, faces, lost and the counts of what was
/// dropped.
void weld_faces(const Scene& scene, Moves& moves, Topology& topology) {
    const std::size_t count = triangle_count(scene);
    core::Numbering<glm::dvec3> points(count / 2);
    core::Numbering<FaceKey> seen(count);
    topology.counts.triangles = count;

    std::uint32_t triangle_index = 0;
    for (std::uint32_t object = 0; object < scene.instances.size(); ++object) {
        const Instance& instance = scene.instances[object];
        const Mesh& mesh = scene.meshes[instance.mesh];
        const bool mirrored = is_mirrored(instance);
        const double stretch = most_stretched(instance);
        std::vector<std::uint32_t> welded(mesh.positions.size(), kFree);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t, ++triangle_index) {
            Face face;
            face.object = object;
            face.material = mesh.materials.empty() ? 0 : mesh.materials[t];
            face.triangle = triangle_index;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t v = mesh.triangles[t][i];
                if (welded[v] == kFree) {
                    welded[v] = points.insert(moves(place(instance, mesh.positions[v]))).first;
                    topology.rounding_world.resize(points.keys().size(), 0);
                    double& rounding = topology.rounding_world[welded[v]];
                    rounding = std::max(
                        {rounding, stretch * half_ulp(mesh.positions[v]), stretch * mesh.rounding});
                }
                face.vertices[i] = welded[v];
            }
            if (!mesh.marked_sides.empty()) face.marked_sides = mesh.marked_sides[t];
            if (mirrored) {
                std::swap(face.vertices[1], face.vertices[2]);
                face.marked_sides = with_ends_swapped(face.marked_sides);
            }

            const auto& [a, b, c] = face.vertices;
            const auto& p = points.keys();
            if (a == b || b == c || c == a || is_collinear(p[a], p[b], p[c])) {
                ++topology.counts.degenerate;
                if (moves.has_any() && has_area(instance, mesh, mesh.triangles[t])) {
                    ++topology.counts.collapsed;
                }
                topology.lost.push_back({triangle_index, face.vertices});
                continue;
            }
            const auto [same, is_new] = seen.insert(sorted(face.vertices));
            if (is_new) {
                topology.faces.push_back(face);
                continue;
            }
            ++topology.counts.duplicate;
            topology.lost.push_back({triangle_index, face.vertices});
            if (moves.leave(instance, mesh, mesh.triangles[t])) topology.lost.back().face = same;
        }
    }
    topology.p_world = std::move(points.keys());
    topology.written_rounding_world = written_roundings(scene, topology.p_world);
}

/// Numbers the edges in the order in which the faces meet them and lists each edge's faces.
void build_edges(Topology& topology) {
    core::Numbering<EdgeKey> keys(topology.faces.size() * 3 / 2);
    for (Face& face : topology.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [a, b] = std::minmax(face.vertices[i], face.vertices[(i + 1) % 3]);
            face.edges[i] = keys.insert({a, b}).first;
        }
    }
    topology.edges.reserve(keys.keys().size());
    for (const EdgeKey& key : keys.keys())
        topology.edges.push_back({key[0], key[1]});
    for (const Face& face : topology.faces) {
        for (const std::uint32_t e : face.edges)
            ++topology.edges[e].face_count;
    }
    std::uint32_t first = 0;
    for (Edge& edge : topology.edges) {
        edge.first_face = first;
        first += edge.face_count;
    }
    topology.edge_faces.resize(first);
    std::vector<std::uint32_t> filled(topology.edges.size(), 0);
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
        for (const std::uint32_t e : topology.faces[f].edges) {
            topology.edge_faces[topology.edges[e].first_face + filled[e]++] = f;
        }
    }
}

/// The direction from the edge into a face, orthogonal to the edge; not normalised.
glm::dvec3 inward(const std::array<glm::dvec3, 3>& face) {
    const glm::dvec3 along = glm::normalize(face[1] - face[0]);
    const glm::dvec3 to_opposite = face[2] - face[0];
    return to_opposite - along * glm::dot(along, to_opposite);
}

double deviation_between(const Topology& topology,
                         const Edge& edge,
                         std::uint32_t face0,
                         std::uint32_t face1) {
    const auto& p = topology.p_world;
    const auto corners = [&](std::uint32_t face) -> std::array<glm::dvec3, 3> {
        return {p[edge.a], p[edge.b], p[opposite_vertex(topology.faces[face], edge)]};
    };
    return deviation_rad(corners(face0), corners(face1));
}

/// Once, since many ask for them.
void measure_deviations(Topology& topology) {
    for (Edge& edge : topology.edges) {
        if (edge.face_count != 2) continue;
        const auto faces = topology.faces_of(edge);
        edge.deviation_rad = deviation_between(topology, edge, faces[0], faces[1]);
    }
}

}  // namespace

Topology weld(const Scene& scene, const WeldOptions& options) {
    Topology topology;
    Moves moves = options.epsilon > 0 ? Moves(scene, options.epsilon) : Moves();
    topology.counts.joined_vertices = moves.joined();
    weld_faces(scene, moves, topology);
    build_edges(topology);
    measure_deviations(topology);
    return topology;
}

bool runs_forward(const Face& face, const Edge& edge) {
    return face.vertices[(corner_at(face, edge.a) + 1) % 3] == edge.b;
}

bool is_consistent(const Topology& topology, const Edge& edge) {
    const auto faces = topology.faces_of(edge);
    return runs_forward(topology.faces[faces[0]], edge) !=
           runs_forward(topology.faces[faces[1]], edge);
}

std::uint32_t opposite_vertex(const Face& face, const Edge& edge) {
    const auto& vertices = face.vertices;
    const auto found =
        std::ranges::find_if(vertices, [&](std::uint32_t v) { return v != edge.a && v != edge.b; });
    assert(found != vertices.end());
    return *found;
}

double deviation_rad(const Topology& topology,
                     const Edge& edge,
                     std::uint32_t face0,
                     std::uint32_t face1) {
    if (edge.face_count == 2) return edge.deviation_rad;
    return deviation_between(topology, edge, face0, face1);
}

double deviation_rad(const std::array<glm::dvec3, 3>& one, const std::array<glm::dvec3, 3>& other) {
    const glm::dvec3 a = inward(one), b = inward(other);
    return std::numbers::pi - std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace ink::scene
