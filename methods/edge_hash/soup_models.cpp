#include "methods/edge_hash/soup_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "buffers/vertex_weld.h"
#include "core/hash.h"
#include "core/numbering.h"
#include "scene/box.h"
#include "scene/predicates.h"
#include "scene/surface.h"

namespace ink::methods {
namespace {

/// Lists each edge's faces beside each other; `edge_of` is per side of a face.
void list_faces(const std::vector<std::uint32_t>& edge_of, SoupEdges& soup) {
    std::uint32_t first = 0;
    for (SoupEdge& edge : soup.edges) {
        edge.first = first;
        first += edge.count;
        edge.count = 0;
    }
    soup.faces_at.resize(first);
    for (std::size_t side = 0; side < edge_of.size(); ++side) {
        const scene::Triangle& face = soup.faces[side / 3];
        const std::size_t i = side % 3;
        SoupEdge& edge = soup.edges[edge_of[side]];
        soup.faces_at[edge.first + edge.count++] = {
            static_cast<std::uint32_t>(side / 3),
            face[(i + 2) % 3],
            static_cast<std::int8_t>(face[i] == edge.a ? 1 : -1)};
    }
}

/// The direction from the edge a-b to `opposite`, orthogonal to the edge.
glm::dvec3 inward(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& opposite) {
    const glm::dvec3 along = glm::normalize(b - a);
    const glm::dvec3 across = opposite - a;
    return across - along * glm::dot(along, across);
}

/// Of several faces on one side of an edge the one that the eye sees.
class Nearest {
  public:
    Nearest(const std::vector<glm::dvec3>& p_world,
            const SoupEdge& edge,
            const scene::Viewpoint& eye)
        : p_(p_world), edge_(edge), eye_(eye) {}

    void offer(const EdgeFace& face) {
        if (face_ == nullptr || hides(face, *face_)) face_ = &face;
    }
    [[nodiscard]] const EdgeFace* face() const { return face_; }

  private:
    /// Whether the eye and face `g` lie on opposite sides of the plane of `f`.
    [[nodiscard]] bool hides(const EdgeFace& f, const EdgeFace& g) const {
        const glm::dvec3 &a = p_[edge_.a], &b = p_[edge_.b], &c = p_[f.opposite];
        return scene::orient3d(a, b, c, eye_) * scene::orient3d(a, b, c, p_[g.opposite]) < 0;
    }

    const std::vector<glm::dvec3>& p_;
    const SoupEdge& edge_;
    const scene::Viewpoint& eye_;
    const EdgeFace* face_ = nullptr;
};

}  // namespace

SoupEdges find_edges(const Soup& soup, double epsilon) {
    buffers::VertexWeld weld =
        buffers::weld_vertices(soup.points, epsilon * scene::box_of(soup.points).diagonal());
    buffers::WeldedFaces welded =
        buffers::weld_faces(weld, soup.points, soup.triangles, buffers::DoubleFaces::drop);

    SoupEdges found;
    found.vertex_of = std::move(weld.first_of);
    found.faces = std::move(welded.faces);
    // The third level of the key: edges by their two places.
    core::Numbering<std::array<std::uint32_t, 2>> numbers(found.faces.size() * 3);
    std::vector<std::uint32_t> edge_of;
    edge_of.reserve(found.faces.size() * 3);
    for (const scene::Triangle& face : found.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
            const auto [edge, is_new] = numbers.insert({a, b});
            if (is_new) found.edges.push_back({a, b, 0, 0});
            edge_of.push_back(edge);
            ++found.edges[edge].count;
        }
    }
    list_faces(edge_of, found);
    return found;
}

void EdgeCache::reset(std::size_t models) {
    models_.assign(models, {});
    counts_ = {};
}

void EdgeCache::make_room(Model& model) {
    if (model.size() < most_frames_) return;
    const auto oldest = std::ranges::min_element(model, [](const auto& a, const auto& b) {
        return a.second.last_asked < b.second.last_asked;
    });
    model.erase(oldest);
    ++counts_.dropped;
}

std::shared_ptr<const SoupEdges> EdgeCache::edges_of(std::size_t model,
                                                     const Soup& soup,
                                                     const scene::PreparedScene& scene) {
    assert(model < models_.size());
    const std::uint64_t frame = core::Hasher().items(soup.points).result();
    Model& frames = models_[model];
    ++asked_;
    const auto known = frames.find(frame);
    if (known != frames.end()) {
        ++counts_.found;
        known->second.last_asked = asked_;
        return known->second.edges;
    }
    make_room(frames);
    ++counts_.built;
    const std::uint64_t triangles = core::Hasher().items(soup.triangles).result();
    auto edges = scene.get(fmt::format("soup edges {} {} {}", frame, triangles, epsilon_),
                           [&] { return find_edges(soup, epsilon_); });
    frames[frame] = {edges, asked_};
    return edges;
}

void SoupModels::prepare(const scene::Scene& scene) {
    cache_.reset(options_.scope == ModelScope::object ? scene.meshes.size() : 1);
    placed_.clear();
}

bool SoupModels::bends(const Placed& placed,
                       const SoupEdge& edge,
                       const EdgeFace& face0,
                       const EdgeFace& face1) const {
    const glm::dvec3 &a = placed.p_world[edge.a], &b = placed.p_world[edge.b];
    const glm::dvec3 d0 = inward(a, b, placed.p_world[face0.opposite]);
    const glm::dvec3 d1 = inward(a, b, placed.p_world[face1.opposite]);
    // The dihedral deviation is pi less the angle between the two.
    return glm::dot(d0, d1) >= -std::cos(options_.crease_rad) * glm::length(d0) * glm::length(d1);
}

void SoupModels::find_creases(Placed& placed) const {
    placed.is_crease.clear();
    for (const SoupEdge& edge : placed.soup->edges) {
        const auto faces = placed.soup->faces_of(edge);
        placed.is_crease.push_back(faces.size() == 2 && bends(placed, edge, faces[0], faces[1]));
    }
}

void SoupModels::pose_objects(const scene::PreparedScene& scene) {
    std::vector<std::shared_ptr<const SoupEdges>> soups;  // objects of one mesh share its frame
    for (std::size_t m = 0; m < scene->meshes.size(); ++m) {
        const scene::Mesh& mesh = scene->meshes[m];
        const std::vector<glm::dvec3> points(mesh.positions.begin(), mesh.positions.end());
        soups.push_back(cache_.edges_of(m, {points, mesh.triangles}, scene));
    }
    placed_.resize(scene->instances.size());
    for (std::size_t i = 0; i < placed_.size(); ++i) {
        const scene::Instance& instance = scene->instances[i];
        const scene::Mesh& mesh = scene->meshes[instance.mesh];
        Placed& placed = placed_[i];
        placed.soup = soups[instance.mesh];
        placed.p_world.clear();
        for (const std::uint32_t vertex : placed.soup->vertex_of)
            placed.p_world.push_back(scene::to_world(instance, mesh.positions[vertex]));
        find_creases(placed);
    }
}

void SoupModels::pose(const scene::PreparedScene& scene) {
    if (options_.scope == ModelScope::object) return pose_objects(scene);
    const auto surface = scene.surface();
    placed_.resize(1);
    Placed& placed = placed_[0];
    placed.soup = cache_.edges_of(0, {surface->p_world, surface->triangles}, scene);
    placed.p_world.clear();
    for (const std::uint32_t vertex : placed.soup->vertex_of)
        placed.p_world.push_back(surface->p_world[vertex]);
    find_creases(placed);
}

buffers::EdgeKind SoupModels::kind_of(const Placed& placed,
                                      std::size_t edge_index,
                                      const std::vector<std::int8_t>& facings,
                                      const scene::Viewpoint& eye) const {
    const SoupEdge& edge = placed.soup->edges[edge_index];
    const auto faces = placed.soup->faces_of(edge);
    if (faces.size() == 1) return buffers::EdgeKind::boundary;
    // A face that the eye sees from the front lies on the left of a side that runs through it
    // forwards; one that is edge-on lies on neither side.
    Nearest left(placed.p_world, edge, eye), right = left;
    for (const EdgeFace& face : faces) {
        const int side = facings[face.face] * face.direction;
        if (side > 0) left.offer(face);
        if (side < 0) right.offer(face);
    }
    if (left.face() == nullptr && right.face() == nullptr) return buffers::EdgeKind::none;
    if (left.face() == nullptr || right.face() == nullptr) return buffers::EdgeKind::contour;
    const bool is_crease = faces.size() == 2 ? placed.is_crease[edge_index] != 0
                                             : bends(placed, edge, *left.face(), *right.face());
    return is_crease ? buffers::EdgeKind::crease : buffers::EdgeKind::none;
}

std::vector<buffers::KnownEdge> SoupModels::lines(const scene::Viewpoint& eye) const {
    std::vector<buffers::KnownEdge> lines;
    std::vector<std::int8_t> facings;
    for (const Placed& placed : placed_) {
        const auto& p = placed.p_world;
        facings.clear();
        for (const auto& [a, b, c] : placed.soup->faces)
            facings.push_back(static_cast<std::int8_t>(scene::facing(p[a], p[b], p[c], eye)));
        for (std::size_t e = 0; e < placed.soup->edges.size(); ++e) {
            const buffers::EdgeKind kind = kind_of(placed, e, facings, eye);
            const SoupEdge& edge = placed.soup->edges[e];
            if (kind != buffers::EdgeKind::none) lines.push_back({p[edge.a], p[edge.b], kind});
        }
    }
    return lines;
}

}  // namespace ink::methods
