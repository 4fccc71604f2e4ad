#include "methods/id_lookup/lookup_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "buffers/repeated_faces.h"
#include "core/disjoint_sets.h"
#include "scene/box.h"
#include "scene/near_points.h"
#include "scene/precision/rounding.h"
#include "scene/topology.h"

namespace ink::methods {
namespace {

/// Edge i of a face.
struct Border {
    std::uint32_t face = 0;
    std::size_t i = 0;
};

glm::dvec3 inward(const std::array<glm::dvec3, 3>& face) {
    const glm::dvec3 along = glm::normalize(face[1] - face[0]);
    const glm::dvec3 to_third = face[2] - face[0];
    return to_third - along * glm::dot(along, to_third);
}

class Builder {
  public:
    Builder(const scene::PreparedScene& scene, const LookupOptions& options)
        : prepared_(scene), options_(options), welded_(scene.topology()) {}

    LookupMesh build() {
        mesh_.p_world = topology_.p_world;
        list_faces();
        measure_objects();
        join_over_edges();
        if (options_.weld_epsilon > 0) join_over_cracks();
        name_patches();
        map_triangles();
        return std::move(mesh_);
    }

  private:
    void list_faces() {
        mesh_.faces.reserve(topology_.faces.size());
        for (const scene::Face& face : topology_.faces) {
            LookupFace& added = mesh_.faces.emplace_back();
            added.vertices = face.vertices;
            added.beyond.fill(kNoNeighbour);
            added.kinds.fill(LineKind::boundary);
            added.object = face.object;
        }
    }

    /// Per object the share of its diagonal that counts as no distance, and the rounding.
    void measure_objects() {
        std::vector<scene::Box> boxes(scene_.instances.size());
        mesh_.rounding_world.assign(scene_.instances.size(), 0);
        for (const LookupFace& face : mesh_.faces) {
            scene::Box& box = boxes[face.object];
            double& rounding = mesh_.rounding_world[face.object];
            for (const std::uint32_t v : face.vertices) {
                rounding = std::max(rounding, topology_.rounding_world[v]);
                box.add(mesh_.p_world[v]);
            }
        }
        for (const scene::Box& box : boxes)
            mesh_.crack_world.push_back(options_.weld_epsilon * box.diagonal());
    }

    [[nodiscard]] Border border(std::uint32_t face, std::uint32_t edge) const {
        const auto& edges = topology_.faces[face].edges;
        return {
            face,
            static_cast<std::size_t>(std::find(edges.begin(), edges.end(), edge) - edges.begin())};
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
                mesh_.faces[f].beyond[border(f, e).i] = LookupFace::kMany;
                mesh_.many.push_back({std::min(edge.a, edge.b), std::max(edge.a, edge.b), f});
            }
        }
        std::sort(mesh_.many.begin(), mesh_.many.end());
    }

    void join(const Border& one, const Border& other, bool is_crease) {
        LookupFace& f = mesh_.faces[one.face];
        LookupFace& g = mesh_.faces[other.face];
        LineKind kind = f.object == g.object ? LineKind::none : LineKind::seam;
        if (is_crease) kind = LineKind::crease;
        f.beyond[one.i] = other.face;
        g.beyond[other.i] = one.face;
        f.kinds[one.i] = g.kinds[other.i] = kind;
    }

    /// Where each vertex on a boundary of one object goes; others stay themselves.
    [[nodiscard]] std::vector<glm::dvec3> near_places() const {
        std::vector<std::vector<std::uint32_t>> parts(scene_.instances.size());
        for (const LookupFace& face : mesh_.faces) {
            for (std::size_t i = 0; i < 3; ++i) {
                if (face.beyond[i] != kNoNeighbour) continue;
                auto& part = parts[face.object];
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
                if (face.beyond[i] != kNoNeighbour) continue;
                const glm::dvec3 &a = place[face.vertices[i]],
                                 &b = place[face.vertices[(i + 1) % 3]];
                if (a == b) continue;
                Point low{a.x, a.y, a.z}, high{b.x, b.y, b.z};
                if (high < low) std::swap(low, high);
                meeting[{face.object, low, high}].push_back({f, i});
            }
        }
        for (const auto& [where, borders] : meeting) {
            if (borders.size() != 2 || borders[0].face == borders[1].face) continue;
            const double deviation = deviation_rad(corners(borders[0]), corners(borders[1]));
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
                if (face.kinds[i] == LineKind::none) sets.join(f, face.beyond[i]);
            }
        }
        for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f)
            mesh_.faces[f].patch = sets.root(f);
    }

    void map_triangles() {
        mesh_.face_of_triangle.assign(scene::triangle_count(scene_), kNoNeighbour);
        for (std::uint32_t f = 0; f < topology_.faces.size(); ++f)
            mesh_.face_of_triangle[topology_.faces[f].triangle] = f;
        for (const auto& [triangle, face] : buffers::repeated_faces(prepared_, topology_))
            mesh_.face_of_triangle[triangle] = face;
    }

    const scene::PreparedScene& prepared_;
    const scene::Scene& scene_ = prepared_;
    LookupOptions options_;
    std::shared_ptr<const scene::Topology> welded_;
    const scene::Topology& topology_ = *welded_;
    LookupMesh mesh_;
};

}  // namespace

double deviation_rad(const std::array<glm::dvec3, 3>& one, const std::array<glm::dvec3, 3>& other) {
    const glm::dvec3 a = inward(one), b = inward(other);
    return std::numbers::pi - std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

LookupMesh make_lookup_mesh(const scene::PreparedScene& scene, const LookupOptions& options) {
    return Builder(scene, options).build();
}

}  // namespace ink::methods
