#include "methods/mesh_lookup/lookup_mesh.h"

#include <fmt/format.h>
#include <meshoptimizer.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>

#include "core/disjoint_sets.h"
#include "core/error.h"
#include "scene/box.h"
#include "scene/near_points.h"
#include "scene/precision/rounding.h"
#include "scene/precision/weld_tolerance.h"
#include "scene/topology.h"

namespace ink::methods {
namespace {

/// Edge i of a face.
struct Border {
    std::uint32_t face = 0;
    std::size_t i = 0;
};

static_assert(kNoNeighbour == scene::LostTriangle::kNoFace);

class Builder {
  public:
    Builder(const scene::PreparedScene& scene, const LookupOptions& options)
        : scene_(scene), options_(options), welded_(scene.topology()) {}

    LookupMesh build() {
        if (topology_.faces.size() > Twin::kMostFaces) {
            throw core::Error("id_lookup",
                              fmt::format("{} triangles", topology_.faces.size()),
                              fmt::format("at most {}", Twin::kMostFaces));
        }
        mesh_.p_world = topology_.p_world;
        list_faces();
        measure_objects();
        join_over_edges();
        if (options_.weld_epsilon > 0) join_over_cracks();
        name_patches();
        map_triangles();
        put_in_order();
        add_planes();
        return std::move(mesh_);
    }

  private:
    void list_faces() {
        mesh_.faces.reserve(topology_.faces.size());
        for (const scene::Face& face : topology_.faces) {
            LookupFace& added = mesh_.faces.emplace_back();
            added.vertices = face.vertices;
            added.kinds.fill(LineKind::boundary);
            mesh_.objects.push_back(face.object);
        }
    }

    /// Per object the share of its diagonal that counts as no distance, and the weld tolerance.
    void measure_objects() {
        for (const scene::Box& box : scene::object_boxes(topology_))
            mesh_.crack_world.push_back(options_.weld_epsilon * box.diagonal());
        mesh_.tolerance_world = scene::weld_tolerances(topology_);
    }

    [[nodiscard]] Border border(std::uint32_t face, std::uint32_t edge) const {
        return {face, scene::side_at(topology_.faces[face], edge)};
    }

    void join_over_edges() {
        for (std::uint32_t e = 0; e < topology_.edges.size(); ++e) {
            const scene::Edge& edge = topology_.edges[e];
            const auto faces = topology_.faces_of(edge);
            if (faces.size() == 2) {
                const bool is_crease =
                    scene::is_crease(topology_, edge, faces[0], faces[1], options_.crease_rad);
                join(border(faces[0], e), border(faces[1], e), is_crease);
            }
            if (faces.size() <= 2) continue;
            for (const std::uint32_t f : faces) {
                mesh_.faces[f].twins[border(f, e).i] = Twin::of_many();
                mesh_.many.push_back({std::min(edge.a, edge.b), std::max(edge.a, edge.b), f});
            }
        }
        std::sort(mesh_.many.begin(), mesh_.many.end());
    }

    void join(const Border& one, const Border& other, bool is_crease) {
        LookupFace& f = mesh_.faces[one.face];
        LookupFace& g = mesh_.faces[other.face];
        const bool is_one = mesh_.objects[one.face] == mesh_.objects[other.face];
        LineKind kind = is_one ? LineKind::none : LineKind::seam;
        if (is_crease) kind = LineKind::crease;
        const std::uint32_t a = f.vertices[one.i], b = f.vertices[(one.i + 1) % 3];
        const std::uint32_t c = g.vertices[other.i], d = g.vertices[(other.i + 1) % 3];
        const bool is_crack = !(a == c && b == d) && !(a == d && b == c);
        const auto& p = mesh_.p_world;
        const bool is_turned = is_crack ? glm::dot(p[d] - p[c], p[b] - p[a]) >= 0 : a == c;
        const std::uint32_t flags = (is_turned ? Twin::kTurned : 0) |
                                    (is_crack || kind != LineKind::none ? Twin::kClosed : 0);
        f.twins[one.i].word = Twin::of(other.face, other.i).word | flags;
        g.twins[other.i].word = Twin::of(one.face, one.i).word | flags;
        f.kinds[one.i] = g.kinds[other.i] = kind;
    }

    /// Where each vertex on a boundary of one object goes; others stay themselves.
    [[nodiscard]] std::vector<glm::dvec3> near_places() const {
        std::vector<std::vector<std::uint32_t>> parts(mesh_.crack_world.size());
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
            const LookupFace& face = mesh_.faces[f];
            for (std::size_t i = 0; i < 3; ++i) {
                if (!face.twins[i].is_nothing()) continue;
                auto& part = parts[mesh_.objects[f]];
                part.insert(part.end(), {face.vertices[i], face.vertices[(i + 1) % 3]});
            }
        }
        scene::NearPoints near(mesh_.p_world);
        for (std::size_t object = 0; object < parts.size(); ++object) {
            auto& part = parts[object];
            std::sort(part.begin(), part.end());
            part.erase(std::unique(part.begin(), part.end()), part.end());
            near.add(part, mesh_.crack_world[object]);
        }
        return near.representatives();
    }

    void join_over_cracks() {
        const std::vector<glm::dvec3> place = near_places();
        using Point = std::array<double, 3>;
        std::map<std::tuple<std::uint32_t, Point, Point>, std::vector<Border>> meeting;
        for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
            const LookupFace& face = mesh_.faces[f];
            for (std::size_t i = 0; i < 3; ++i) {
                if (!face.twins[i].is_nothing()) continue;
                const glm::dvec3 &a = place[face.vertices[i]],
                                 &b = place[face.vertices[(i + 1) % 3]];
                if (a == b) continue;
                Point low{a.x, a.y, a.z}, high{b.x, b.y, b.z};
                if (high < low) std::swap(low, high);
                meeting[{mesh_.objects[f], low, high}].push_back({f, i});
            }
        }
        for (const auto& [where, borders] : meeting) {
            if (borders.size() != 2 || borders[0].face == borders[1].face) continue;
            const double deviation = scene::deviation_rad(corners(borders[0]), corners(borders[1]));
            join(borders[0], borders[1], deviation >= options_.crease_rad);
        }
    }

    /// The ends of an edge and the face's third corner; the ends of a crack may come in either
    /// order, which the deviation does not depend on.
    [[nodiscard]] std::array<glm::dvec3, 3> corners(const Border& at) const {
        const auto& v = mesh_.faces[at.face].vertices;
        const auto& p = mesh_.p_world;
        return {p[v[at.i]], p[v[(at.i + 1) % 3]], p[v[(at.i + 2) % 3]]};
    }

    void name_patches() {
        core::DisjointSets sets(mesh_.faces.size());
        for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
            const LookupFace& face = mesh_.faces[f];
            for (std::size_t i = 0; i < 3; ++i) {
                if (face.kinds[i] == LineKind::none) sets.join(f, face.twins[i].face());
            }
        }
        for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f)
            mesh_.faces[f].patch = sets.root(f);
    }

    void map_triangles() {
        mesh_.face_of_triangle.assign(scene::triangle_count(scene_), kNoNeighbour);
        for (std::uint32_t f = 0; f < topology_.faces.size(); ++f)
            mesh_.face_of_triangle[topology_.faces[f].triangle] = f;
        for (const scene::LostTriangle& lost : topology_.lost)
            mesh_.face_of_triangle[lost.triangle] = lost.face;
    }

    /// Faces along a Morton curve of their centres, vertices as faces come by them: what is seen
    /// together then lies together.
    void put_in_order() {
        const std::size_t count = mesh_.faces.size();
        if (count == 0) return;
        std::vector<glm::vec3> centers(count);
        std::vector<std::uint32_t> face_to(count);
        const glm::dvec3 origin = mesh_.p_world[mesh_.faces[0].vertices[0]];
        for (std::size_t f = 0; f < count; ++f) {
            for (const std::uint32_t v : mesh_.faces[f].vertices)
                centers[f] += glm::vec3(mesh_.p_world[v] - origin);
        }
        meshopt_spatialSortRemap(face_to.data(), &centers[0].x, count, sizeof(glm::vec3));
        std::vector<LookupFace> faces(count);
        std::vector<std::uint32_t> objects(count);
        for (std::size_t f = 0; f < count; ++f) {
            LookupFace& face = faces[face_to[f]] = mesh_.faces[f];
            for (Twin& twin : face.twins) {
                if (twin.is_nothing() || twin.is_many()) continue;
                twin.word = (twin.word & ~Twin::kFace) | face_to[twin.face()] << 2;
            }
            face.patch = face_to[face.patch];
            objects[face_to[f]] = mesh_.objects[f];
        }
        mesh_.faces = std::move(faces);
        mesh_.objects = std::move(objects);
        renumber_vertices();
        for (ManyFaces& many : mesh_.many)
            many.face = face_to[many.face];
        std::sort(mesh_.many.begin(), mesh_.many.end());
        for (std::uint32_t& face : mesh_.face_of_triangle)
            if (face != kNoNeighbour) face = face_to[face];
    }

    void renumber_vertices() {
        std::vector<std::uint32_t> vertex_to(mesh_.p_world.size(), kNoNeighbour);
        std::vector<glm::dvec3> p_world;
        p_world.reserve(mesh_.p_world.size());
        for (LookupFace& face : mesh_.faces) {
            for (std::uint32_t& v : face.vertices) {
                if (vertex_to[v] == kNoNeighbour) {
                    vertex_to[v] = static_cast<std::uint32_t>(p_world.size());
                    p_world.push_back(mesh_.p_world[v]);
                }
                v = vertex_to[v];
            }
        }
        mesh_.p_world = std::move(p_world);
        for (ManyFaces& many : mesh_.many)
            std::tie(many.a, many.b) = std::minmax({vertex_to[many.a], vertex_to[many.b]});
    }

    void add_planes() {
        const auto& p = mesh_.p_world;
        if (p.empty()) return;
        const scene::Box box = scene::box_of(p);
        mesh_.origin_world = box.center();
        mesh_.reach_world = static_cast<float>(2 * box.diagonal());
        for (std::vector<float>& part : mesh_.planes)
            part.resize(mesh_.faces.size());
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
            const auto& [a, b, c] = mesh_.faces[f].vertices;
            const glm::dvec3 one = p[b] - p[a], other = p[c] - p[a];
            const glm::dvec3 n = glm::cross(one, other);
            const double size = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
            // Of slivers nothing but rounding is left.
            if (!(size > 1e-6 * glm::length(one) * glm::length(other))) continue;
            const double distance = glm::dot(n / size, p[a] - mesh_.origin_world);
            const std::array<double, 4> plane = {n.x / size, n.y / size, n.z / size, distance};
            for (std::size_t i = 0; i < 4; ++i)
                mesh_.planes[i][f] = static_cast<float>(plane[i]);
        }
    }

    const scene::Scene& scene_;
    LookupOptions options_;
    std::shared_ptr<const scene::Topology> welded_;
    const scene::Topology& topology_ = *welded_;
    LookupMesh mesh_;
};

}  // namespace

LookupMesh make_lookup_mesh(const scene::PreparedScene& scene, const LookupOptions& options) {
    return Builder(scene, options).build();
}

}  // namespace ink::methods
