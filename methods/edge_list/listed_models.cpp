#include "methods/edge_list/listed_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "buffers/vertex_weld.h"
#include "core/error.h"
#include "scene/predicates.h"
#include "scene/surface.h"

namespace ink::methods {
namespace {

/// all_pairs makes 2e10 comparisons of so many sides: half a minute.
constexpr std::size_t kMostPairedTriangles = 66'000;

void check_size(EdgeBuilder builder, std::size_t triangles) {
    if (builder != EdgeBuilder::all_pairs || triangles <= kMostPairedTriangles) return;
    throw core::Error("edge_list",
                      "builder all_pairs would compare every two sides of " +
                          std::to_string(triangles) + " triangles",
                      "at most " + std::to_string(kMostPairedTriangles) +
                          " triangles in a list, or builder = temp_list | hash");
}

std::int8_t sign(double value) {
    return static_cast<std::int8_t>((value > 0) - (value < 0));
}

buffers::EdgeKind kind_of(int facing0, int facing1, bool is_crease, EdgeOnRule edge_on) {
    const bool is_contour = facing0 * facing1 < 0 ||
                            (edge_on == EdgeOnRule::include && (facing0 == 0) != (facing1 == 0));
    if (is_contour) return buffers::EdgeKind::contour;
    return is_crease ? buffers::EdgeKind::crease : buffers::EdgeKind::none;
}

}  // namespace

std::shared_ptr<const ListedModels::List> ListedModels::build(
    const std::vector<glm::dvec3>& points, const std::vector<scene::Triangle>& triangles) const {
    buffers::VertexWeld weld = buffers::weld_vertices(points, 0);
    List list;
    list.faces = buffers::weld_faces(weld, points, triangles, buffers::DoubleFaces::keep).faces;
    check_size(builder_, list.faces.size());
    list.edges = list_edges(list.faces, builder_).edges;
    list.vertices = std::move(weld.first_of);
    return std::make_shared<const List>(std::move(list));
}

/// A list per mesh, so that one that is used twice is listed once; or one of all.
ListedModels::Lists ListedModels::build_all(const scene::PreparedScene& scene) const {
    if (scope_ == EdgeScope::scene) {
        const auto surface = scene.surface();
        return {build(surface->p_world, surface->triangles)};
    }
    Lists lists;
    for (const scene::Mesh& mesh : scene->meshes)
        lists.push_back(build({mesh.positions.begin(), mesh.positions.end()}, mesh.triangles));
    return lists;
}

void ListedModels::prepare(const scene::PreparedScene& scene) {
    const bool is_by_object = scope_ == EdgeScope::object;
    const auto lists = scene.get(
        fmt::format("edge lists {} {}", static_cast<int>(builder_), static_cast<int>(scope_)),
        [&] { return build_all(scene); });
    listed_hash_ = scene.hash();
    placed_.clear();
    for (std::uint32_t i = 0; i < (is_by_object ? scene->instances.size() : 1); ++i) {
        const std::size_t list = is_by_object ? scene->instances[i].mesh : 0;
        placed_.push_back({(*lists)[list], i, {}, {}, {}});
    }
}

void ListedModels::place(Placed& placed, const scene::PreparedScene& scene) const {
    const List& list = *placed.list;
    const auto surface = scope_ == EdgeScope::scene ? scene.surface() : nullptr;
    const scene::Instance* instance = surface ? nullptr : &scene->instances[placed.instance];
    placed.p_world.clear();
    for (const std::uint32_t v : list.vertices) {
        placed.p_world.push_back(
            surface ? surface->p_world[v]
                    : scene::to_world(*instance, scene->meshes[instance->mesh].positions[v]));
    }
    placed.normals.clear();
    for (const scene::Triangle& face : list.faces) {
        const glm::dvec3 a = placed.p_world[face[0]];
        const glm::dvec3 across =
            glm::cross(placed.p_world[face[1]] - a, placed.p_world[face[2]] - a);
        const double length = glm::length(across);
        placed.normals.push_back(length > 0 ? across / length : glm::dvec3(0));
    }
    const double least_cosine = std::cos(crease_rad_);
    placed.is_crease.clear();
    for (const ListedEdge& edge : list.edges) {
        placed.is_crease.push_back(
            !edge.is_boundary() &&
            glm::dot(placed.normals[edge.faces[0]], placed.normals[edge.faces[1]]) <= least_cosine);
    }
}

void ListedModels::pose(const scene::PreparedScene& scene) {
    // What touched may have moved apart.
    if (scope_ == EdgeScope::scene && scene.hash() != listed_hash_) prepare(scene);
    for (Placed& placed : placed_)
        place(placed, scene);
}

void ListedModels::append_lines(const Placed& placed,
                                const std::vector<std::int8_t>& facings,
                                EdgeOnRule edge_on,
                                std::vector<buffers::KnownEdge>& lines) {
    const auto& edges = placed.list->edges;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const ListedEdge& edge = edges[e];
        const buffers::EdgeKind kind = edge.is_boundary() ? buffers::EdgeKind::boundary
                                                          : kind_of(facings[edge.faces[0]],
                                                                    facings[edge.faces[1]],
                                                                    placed.is_crease[e] != 0,
                                                                    edge_on);
        if (kind != buffers::EdgeKind::none)
            lines.push_back({placed.p_world[edge.a], placed.p_world[edge.b], kind});
    }
}

std::vector<buffers::KnownEdge> ListedModels::lines(const scene::Camera& camera,
                                                    FacingRule facing,
                                                    EdgeOnRule edge_on) const {
    const glm::dvec3 back_world = glm::transpose(camera.view_from_world)[2];
    std::vector<buffers::KnownEdge> lines;
    std::vector<std::int8_t> facings;
    for (const Placed& placed : placed_) {
        facings.clear();
        for (std::size_t f = 0; f < placed.list->faces.size(); ++f) {
            const auto& [a, b, c] = placed.list->faces[f];
            const auto& p = placed.p_world;
            facings.push_back(
                facing == FacingRule::position
                    ? static_cast<std::int8_t>(scene::facing(p[a], p[b], p[c], camera.viewpoint()))
                    : sign(glm::dot(placed.normals[f], back_world)));
        }
        append_lines(placed, facings, edge_on, lines);
    }
    return lines;
}

}  // namespace ink::methods
