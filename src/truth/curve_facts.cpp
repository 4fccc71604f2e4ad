#include "truth/curve_facts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <vector>

#include "core/parallel.h"
#include "scene/box.h"
#include "truth/crossings/touching.h"
#include "truth/visibility.h"

namespace ink::truth {
namespace {

constexpr std::size_t kChunk = 64;  ///< curves a task

/// The middle of a piece on the image, in space: 1/w is linear along it, or under a parallel camera
/// w.
glm::dvec3 middle_of(const EyeView& eye, const Curve& curve, double& w) {
    const double begin = curve.begin.w, end = curve.end.w;
    w = eye.eye().is_direction ? (begin + end) / 2 : 2 * begin * end / (begin + end);
    const double x_px = (curve.begin.x_px + curve.end.x_px) / 2;
    const double y_px = (curve.begin.y_px + curve.end.y_px) / 2;
    return eye.projection.at(x_px, y_px, w);
}

/// The face that goes on across a boundary edge at `t` as another object; kNoFace if none does.
std::uint32_t continuing_face(const EyeView& eye, std::uint32_t e, double t) {
    const std::uint32_t own = eye.model.topology.faces_of(eye.model.topology.edges[e])[0];
    for (const Continuation& c : eye.model.continuations_of(e)) {
        if (t < c.t_begin || t > c.t_end || !eye.goes_on(c, t)) continue;
        if (eye.model.is_seam(own, c.face)) return c.face;
    }
    return kNoFace;
}

std::uint32_t lowest_other(std::span<const std::uint32_t> faces, std::uint32_t face) {
    for (const std::uint32_t f : faces) {  // ascending
        if (f != face) return f;
    }
    return kNoTriangle;
}

/// The angle between a line of sight and a face's normal, 0..pi/2.
float view_angle_rad(const EyeView& eye, std::uint32_t face, const glm::dvec3& to_point) {
    const glm::dvec3 normal = eye.model.topology.area_vector(face);
    return static_cast<float>(std::atan2(glm::length(glm::cross(normal, to_point)),
                                         std::abs(glm::dot(normal, to_point))));
}

/// How far behind the point a face meets the line of sight, along the view direction.
float gap_to(const EyeView& eye, const EyeScene::Hit& hit, const LinePoint& point) {
    const scene::Topology& topology = eye.model.topology;
    const glm::dvec3 normal = topology.area_vector(hit.face);
    const glm::dvec3& on_face = topology.p_world[topology.faces[hit.face].vertices[0]];
    // From the point, not from the eye: what touches the line is 0 behind it, not a rounding.
    const double beyond = glm::dot(normal, on_face - point.p_world);
    const double along = glm::dot(normal, eye.projection.sight_to(point.p_world).way_world);
    return along == 0 ? 0.0F : static_cast<float>(std::max(0.0, beyond / along * point.w));
}

/// Faces and empty side. An edge's side 1 is the left as one goes from a to b on the image: the
/// front of a face that runs along the edge lies there, counter-clockwise.
void fill_faces(const EyeView& eye, double t, Curve& curve) {
    const scene::Topology& topology = eye.model.topology;
    const scene::Edge& edge = topology.edges[curve.edge];
    const bool is_one_sided =
        curve.line_class == LineClass::contour || curve.line_class == LineClass::boundary;
    // What a box stands on is no face of the box's outline, but is one of a seam or an
    // intersection.
    SeenFaces seen = eye.seen_faces(edge);
    if (!is_one_sided && eye.model.is_touched[curve.edge] != 0) {
        const SeenSheets sheets = seen_sheets_at(eye, curve.edge, t);
        seen = {sheets.left.face, sheets.right.face};
    }
    std::uint32_t left = seen.right, right = seen.left;
    if (is_one_sided) {
        curve.empty_side = left == kNoFace ? std::int8_t{-1} : std::int8_t{1};
        curve.face0 = left == kNoFace ? right : left;
        curve.face1 = lowest_other(topology.faces_of(edge), curve.face0);
        return;
    }
    if (left == kNoFace) left = continuing_face(eye, curve.edge, t);
    if (right == kNoFace) right = continuing_face(eye, curve.edge, t);
    curve.face0 = left;
    curve.face1 = right;
}

std::size_t fill_one(const EyeView& eye, const Visibility& visibility, Curve& curve) {
    double w = 0;
    glm::dvec3 p_world = middle_of(eye, curve, w);
    std::size_t rays = 0;
    if (curve.edge != kNoEdge) {
        const scene::Topology& topology = eye.model.topology;
        const scene::Edge& edge = topology.edges[curve.edge];
        const glm::dvec3 &a = topology.p_world[edge.a], &b = topology.p_world[edge.b];
        const double t = scene::nearest_share(p_world, a, b);
        p_world = a + t * (b - a);
        fill_faces(eye, t, curve);
    }
    const glm::dvec3 to_point = eye.eye().sight(p_world);
    curve.view_angle_rad =
        curve.face0 == kNoTriangle ? 0 : view_angle_rad(eye, curve.face0, to_point);
    if (curve.empty_side == 0) {
        if (curve.face1 == kNoTriangle) return rays;
        curve.view_angle_rad =
            std::max(curve.view_angle_rad, view_angle_rad(eye, curve.face1, to_point));
        return rays;
    }
    const LinePoint point{curve.edge, p_world, w, nullptr, rounding_between(p_world, p_world)};
    const auto behind = visibility.first_behind(point, rays);
    curve.gap = behind ? gap_to(eye, *behind, point) : std::numeric_limits<float>::infinity();
    return rays;
}

}  // namespace

std::size_t fill_curve_facts(const EyeView& eye,
                             const EyeScene& scene,
                             std::span<Curve> curves,
                             int threads) {
    const Visibility visibility(eye, scene);
    const auto fill = [&](std::size_t begin, std::size_t end, std::size_t& rays) {
        for (Curve& curve : curves.subspan(begin, end - begin))
            rays += fill_one(eye, visibility, curve);
    };
    const auto rays = core::parallel_parts<std::size_t>(curves.size(), kChunk, threads, fill);
    return std::reduce(rays.begin(), rays.end());
}

ContourLengths contour_lengths(std::span<const Curve> curves) {
    ContourLengths sum;
    for (const Curve& curve : curves) {
        if (curve.line_class != LineClass::contour) continue;
        const double length_px =
            std::hypot(curve.end.x_px - curve.begin.x_px, curve.end.y_px - curve.begin.y_px);
        switch (curve.kind) {
            case ContourKind::other_object:
                sum.other_object_px += length_px;
                break;
            case ContourKind::self:
                sum.self_px += length_px;
                break;
            default:
                sum.sky_px += length_px;
        }
    }
    return sum;
}

}  // namespace ink::truth
