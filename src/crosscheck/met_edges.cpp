#include "crosscheck/met_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/box.h"
#include "scene/predicates.h"

namespace ink::crosscheck::walking {
namespace {

/// By how much two faces may be apart and yet touch, as far as rounding can tell.
double touching(const ClipMesh& mesh, std::uint32_t face0, std::uint32_t face1) {
    return mesh.rounding(face0) + mesh.rounding(face1);
}

/// On which side of a face's plane a point lies as the eye sees it: 1 the far side, -1 the near
/// one, 0 where rounding may have moved it off the plane.
int side_under(const ClipMesh& mesh, std::uint32_t face, const scene::RoundedPoint& point) {
    const auto& v = mesh.topology().faces[face].vertices;
    const auto& p = mesh.topology().p_world;
    const glm::dvec3 &a = p[v[0]], &b = p[v[1]], &c = p[v[2]];
    const double volume = scene::orient3d_value(a, b, c, point.p);
    const double off = mesh.rounding(face) + point.rounding;
    if (std::abs(volume) <= off * glm::length(glm::cross(b - a, c - a))) return 0;
    return (volume > 0 ? -1 : 1) * scene::orient3d(a, b, c, mesh.projection().viewpoint());
}

/// The same of a vertex, 0 also where the rounding of the face turns its plane that far.
int sure_side_under(const ClipMesh& mesh, std::uint32_t face, std::uint32_t vertex) {
    const auto& v = mesh.topology().faces[face].vertices;
    const auto point = [&](std::uint32_t i) { return scene::rounded_point(mesh.topology(), i); };
    return -scene::sure_orient3d(point(v[0]), point(v[1]), point(v[2]), point(vertex)) *
           scene::orient3d(
               point(v[0]).p, point(v[1]).p, point(v[2]).p, mesh.projection().viewpoint());
}

/// Whether one edge runs exactly behind another, in one plane with the eye: the surface that ends
/// there hides it as a whole.
bool is_right_behind(const ClipMesh& mesh, const MetEdge& met, const MetEdge& border) {
    const scene::Topology& topology = mesh.topology();
    const auto& p = topology.p_world;
    const scene::Edge& front = topology.edges[edge_of(mesh, border)];
    const scene::Edge& behind = topology.edges[edge_of(mesh, met)];
    const scene::Viewpoint& eye = mesh.projection().viewpoint();
    const auto is_level = [&](std::uint32_t v) {
        return scene::facing(p[front.a], p[front.b], p[v], eye) == 0;
    };
    return border.w < met.w && is_level(behind.a) && is_level(behind.b);
}

}  // namespace

std::uint32_t edge_of(const ClipMesh& mesh, const MetEdge& met) {
    return mesh.topology().faces[met.face].edges[met.side];
}

scene::RoundedPoint point_of(const ClipMesh& mesh, const MetEdge& met) {
    return {met.p_world, mesh.rounding(met.face)};
}

bool is_touched(const ClipMesh& mesh, const MetEdge& end, const Sample& beyond) {
    if (beyond.sight.face == kNothing) return false;
    const Walk back = walk(mesh, beyond, mesh.px(end.p_world), Stop::at_feature);
    const std::array<std::uint32_t, 2> faces{beyond.sight.face, back.face};
    return std::ranges::any_of(faces, [&](std::uint32_t face) {
        return mesh.goes_on(end.face, face, end.p_world, {touching(mesh, end.face, face), 0});
    });
}

bool is_on_side(const ClipMesh& mesh, std::uint32_t face, const scene::RoundedPoint& point) {
    const auto& v = mesh.topology().faces[face].vertices;
    const auto& p = mesh.topology().p_world;
    const double reach = mesh.rounding(face) + point.rounding;
    for (std::size_t i = 0; i < 3; ++i) {
        if (scene::distance_to_segment(point.p, p[v[i]], p[v[(i + 1) % 3]]) <= reach) return true;
    }
    return false;
}

bool is_under(const ClipMesh& mesh, const MetEdge& end, const Sample& beyond) {
    if (beyond.sight.face == kNothing || end.w < mesh.view().camera.near) return false;
    const glm::dvec2 end_px = mesh.px(end.p_world);
    const Walk cover = walk(mesh, beyond, end_px, Stop::at_end);
    if (!cover.has_arrived) return false;
    const double w = ClipMesh::plane_depth(mesh.local_face(cover.face, end_px));
    if (w < mesh.view().camera.near) return false;
    const auto& v = mesh.topology().faces[end.face].vertices;
    const auto under = [&](std::size_t i) { return sure_side_under(mesh, cover.face, v[i % 3]); };
    const int under_a = under(end.side), under_b = under(end.side + 1);
    // An edge that begins in the plane and goes under it is under it at once.
    if (under_a * under_b >= 0 && under_a + under_b != 0) return under_a + under_b > 0;
    return side_under(mesh, cover.face, point_of(mesh, end)) > 0;
}

bool is_out(const ClipMesh& mesh, const MetEdge& met, const Sample& other) {
    if (met.w < mesh.view().camera.near) return false;
    const glm::dvec2 met_px = mesh.px(met.p_world);
    const Walk cover = walk(mesh, other, met_px, Stop::at_end);
    if (cover.has_arrived) return side_under(mesh, cover.face, point_of(mesh, met)) < 0;
    if (is_right_behind(mesh, met, cover.met)) return false;
    return !is_on_side(mesh, cover.face, point_of(mesh, met));
}

}  // namespace ink::crosscheck::walking
