#include "crosscheck/clip_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/parallel.h"
#include "scene/precision/rounding.h"
#include "scene/precision/weld_tolerance.h"
#include "scene/predicates.h"

namespace ink::crosscheck {
namespace {

constexpr double kEdgeOn = 1e-13;  ///< relative; what double leaves of an exact zero
constexpr std::size_t kTrianglesOfChunk = 4096;

double cross_xy(const glm::dvec3& a, const glm::dvec3& b) {
    return a.x * b.y - a.y * b.x;
}

}  // namespace

ClipMesh::ClipMesh(const scene::Topology& topology,
                   const scene::View& view,
                   const SamplingOptions& options)
    : topology_(topology),
      view_(view),
      projection_(view),
      crease_rad_(options.crease_rad),
      creases_(options.creases),
      tolerances_(scene::weld_tolerances(topology)),
      p_clip_(topology.p_world.size()),
      orientation_(topology.faces.size()),
      kinds_(topology.edges.size()) {
    const auto in_chunks = [&](std::size_t count, const auto& body) {
        core::parallel_for_chunks(count, kTrianglesOfChunk, options.threads, body);
    };
    in_chunks(p_clip_.size(),
              [&](std::size_t i) { p_clip_[i] = projection_.to_clip(topology.p_world[i]); });
    in_chunks(orientation_.size(), [&](std::size_t i) {
        const auto& v = topology.faces[i].vertices;
        const auto& p = topology.p_world;
        orientation_[i] = static_cast<std::int8_t>(
            scene::orient3d(p[v[0]], p[v[1]], p[v[2]], projection_.viewpoint()));
    });
    in_chunks(kinds_.size(), [&](std::size_t i) { kinds_[i] = kind_of(topology.edges[i]); });
}

LocalFace ClipMesh::local_face(std::uint32_t face, const glm::dvec2& p_px) const {
    LocalFace local;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3& p = p_clip_[topology_.faces[face].vertices[i]];
        local.p[i] = {p.x - p_px.x * p.z, p.y - p_px.y * p.z, p.z};
    }
    for (std::size_t i = 0; i < 3; ++i)
        local.area[i] = cross_xy(local.p[i], local.p[(i + 1) % 3]);
    local.orientation = orientation_[face];
    return local;
}

double ClipMesh::depth(const LocalFace& face) {
    double weight = 0, weighted = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double share = std::max(0.0, face.orientation * face.area[i]);
        weight += share;
        weighted += share * face.p[(i + 2) % 3].z;
    }
    return weight > 0 ? weighted / weight : 0;
}

double ClipMesh::plane_depth(const LocalFace& face) {
    double weight = 0, weighted = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        weight += face.area[i];
        weighted += face.area[i] * face.p[(i + 2) % 3].z;
    }
    return weight != 0 ? weighted / weight : 0;
}

bool ClipMesh::is_edge_near(const LocalFace& face, std::size_t side, double reach_px) {
    const glm::dvec3 &a = face.p[side], &b = face.p[(side + 1) % 3];
    const double slope = std::hypot(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z);
    return std::abs(face.area[side]) <= reach_px * slope;
}

bool ClipMesh::holds(const LocalFace& face, double reach_px) {
    if (face.orientation == 0) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (face.orientation * face.area[i] >= 0) continue;
        if (reach_px == 0 || !is_edge_near(face, i, reach_px)) return false;
    }
    return true;
}

int ClipMesh::side_of(const scene::Edge& edge, std::uint32_t face) const {
    return runs_forward(topology_.faces[face], edge) ? orientation_[face] : -orientation_[face];
}

bool ClipMesh::is_seam(std::uint32_t face0, std::uint32_t face1) const {
    return topology_.faces[face0].object != topology_.faces[face1].object;
}

truth::LineClass ClipMesh::class_between(const scene::Edge& edge,
                                         std::uint32_t face0,
                                         std::uint32_t face1) const {
    if (scene::is_crease(topology_, edge, face0, face1, {crease_rad_, creases_}))
        return truth::LineClass::crease;
    return is_seam(face0, face1) ? truth::LineClass::seam : truth::LineClass::none;
}

ClipMesh::EdgeKind ClipMesh::kind_of(const scene::Edge& edge) const {
    if (edge.face_count == 1) return truth::LineClass::boundary;
    if (edge.face_count > 2) return std::nullopt;
    const auto faces = topology_.faces_of(edge);
    if (side_of(edge, faces[0]) * side_of(edge, faces[1]) >= 0) return truth::LineClass::contour;
    return class_between(edge, faces[0], faces[1]);
}

std::uint32_t ClipMesh::nearest_on(const scene::Edge& edge, int side) const {
    std::uint32_t nearest = kNothing;
    const auto point = [&](std::uint32_t vertex) {
        return scene::rounded_point(topology_, vertex);
    };
    const auto corner = [&](std::uint32_t face) {
        return point(opposite_vertex(topology_.faces[face], edge));
    };
    for (const std::uint32_t face : topology_.faces_of(edge)) {
        if (side_of(edge, face) != side) continue;
        if (nearest == kNothing) {
            nearest = face;
            continue;
        }
        // Nearer is what surely lies on the eye's side of the plane of the nearest so far.
        const scene::RoundedPoint a = point(edge.a), b = point(edge.b), c = corner(nearest);
        const int of_face = scene::sure_orient3d(a, b, c, corner(face));
        const int of_eye = scene::orient3d(a.p, b.p, c.p, projection_.viewpoint());
        if (of_face == of_eye || (of_face == 0 && face < nearest)) nearest = face;
    }
    return nearest;
}

Across ClipMesh::across(std::uint32_t face, std::size_t side) const {
    const std::uint32_t index = topology_.faces[face].edges[side];
    const scene::Edge& edge = topology_.edges[index];
    if (const EdgeKind kind = kinds_[index]) {
        if (*kind == truth::LineClass::boundary || *kind == truth::LineClass::contour)
            return {*kind, kNothing};
        const auto faces = topology_.faces_of(edge);
        return {*kind, faces[0] == face ? faces[1] : faces[0]};
    }
    const int from = side_of(edge, face);
    const std::uint32_t beyond = from == 0 ? kNothing : nearest_on(edge, -from);
    if (beyond == kNothing) return {truth::LineClass::contour, kNothing};
    return {class_between(edge, face, beyond), beyond};
}

double ClipMesh::deviation_between(std::uint32_t face0, std::uint32_t face1) const {
    const auto to_eye = [&](std::uint32_t face) {
        const glm::dvec3 a = topology_.p_world[topology_.faces[face].vertices[0]];
        const glm::dvec3 n = topology_.area_vector(face);
        return glm::dot(n, projection_.viewpoint().sight(a)) > 0 ? -n : n;
    };
    const glm::dvec3 one = to_eye(face0), other = to_eye(face1);
    return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

bool ClipMesh::is_level(std::uint32_t face0, std::uint32_t face1) const {
    const auto point = [&](std::uint32_t face, std::size_t i) {
        return scene::rounded_point(topology_, topology_.faces[face].vertices[i]);
    };
    const scene::RoundedPoint a = point(face0, 0), b = point(face0, 1), c = point(face0, 2);
    const glm::dvec3 u0 = b.p - a.p, u1 = c.p - a.p;
    const glm::dvec3 n = glm::cross(u0, u1);
    for (std::size_t i = 0; i < 3; ++i) {
        const scene::RoundedPoint corner = point(face1, i);
        const glm::dvec3 d = corner.p - a.p;
        const double noise = kEdgeOn * glm::length(u0) * glm::length(u1) * glm::length(d);
        if (std::abs(glm::dot(n, d)) > noise + scene::orient3d_doubt(a, b, c, corner)) return false;
    }
    return true;
}

double ClipMesh::tolerance(std::uint32_t face, double w) const {
    const double unseen =
        scene::kUnseen_px / projection_.px_per_world(std::max(w, view_.camera.near));
    return std::min(tolerances_[topology_.faces[face].object], unseen);
}

bool ClipMesh::is_near(std::uint32_t face,
                       const glm::dvec3& p_world,
                       const Closeness& close) const {
    const auto& v = topology_.faces[face].vertices;
    std::array<glm::dvec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
        p[i] = topology_.p_world[v[i]] - p_world;
    const glm::dvec3 n = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    if (!(std::abs(glm::dot(n, p[0])) <= close.height)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 along = glm::normalize(p[(i + 1) % 3] - p[i]);
        const double outside = glm::dot(glm::cross(along, n), -p[i]);
        if (outside > close.height + close.slack) return false;
    }
    return true;
}

bool ClipMesh::goes_on(std::uint32_t from,
                       std::uint32_t face,
                       const glm::dvec3& p_world,
                       const Closeness& close) const {
    return is_near(face, p_world, close) && deviation_between(from, face) < crease_rad_;
}

}  // namespace ink::crosscheck
