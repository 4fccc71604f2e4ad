#include "crosscheck/line_names.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/box.h"
#include "scene/precision/rounding.h"
#include "scene/predicates.h"

namespace ink::crosscheck {
namespace {

using namespace walking;

// How an edge that was met lies to what is seen beside it: by heights over planes and distances in
// the world, which rounding bounds, and by exact signs where the eye lies in a plane with both.

/// The mesh edge that was met.
std::uint32_t edge_of(const ClipMesh& mesh, const MetEdge& met) {
    return mesh.topology().faces[met.face].edges[met.side];
}

/// A point of an edge that was met on the way.
scene::RoundedPoint point_of(const ClipMesh& mesh, const MetEdge& met) {
    return {met.p_world, mesh.rounding(met.face)};
}

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

/// Whether the surface that is seen beyond the end of an edge of two faces touches it there, as far
/// as rounding can tell.
bool is_touched(const ClipMesh& mesh, const MetEdge& end, const Sample& beyond) {
    if (beyond.sight.face == kNothing) return false;
    const Walk back = walk(mesh, beyond, mesh.px(end.p_world), Stop::at_feature);
    const std::array<std::uint32_t, 2> faces{beyond.sight.face, back.face};
    return std::ranges::any_of(faces, [&](std::uint32_t face) {
        return mesh.goes_on(end.face, face, end.p_world, {touching(mesh, end.face, face), 0});
    });
}

/// Whether a point lies on one of the sides of a face, as far as rounding can tell.
bool is_on_side(const ClipMesh& mesh, std::uint32_t face, const scene::RoundedPoint& point) {
    const auto& v = mesh.topology().faces[face].vertices;
    const auto& p = mesh.topology().p_world;
    const double reach = mesh.rounding(face) + point.rounding;
    for (std::size_t i = 0; i < 3; ++i) {
        if (scene::distance_to_segment(point.p, p[v[i]], p[v[(i + 1) % 3]]) <= reach) return true;
    }
    return false;
}

/// Whether the surface that is seen beyond an end already covers the end itself: then the two cross
/// just before it, and it is not seen. By the height over the plane, not by depths: an edge that a
/// modeller put into a wall lies in it to within the rounding of its floats, on either side.
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

/// Whether a feature that the way from `sample` passed comes out beyond the surface seen at
/// `other`, which neither covers nor touches it.
bool is_out(const ClipMesh& mesh, const MetEdge& met, const Sample& other) {
    if (met.w < mesh.view().camera.near) return false;
    const glm::dvec2 met_px = mesh.px(met.p_world);
    const Walk cover = walk(mesh, other, met_px, Stop::at_end);
    if (cover.has_arrived) return side_under(mesh, cover.face, point_of(mesh, met)) < 0;
    if (is_right_behind(mesh, met, cover.met)) return false;
    return !is_on_side(mesh, cover.face, point_of(mesh, met));
}

constexpr double kSameDepth = 1e-11;  ///< relative: what double leaves of equal depths

double depth_at(const ClipMesh& mesh, std::uint32_t face, const glm::dvec2& p_px) {
    return ClipMesh::depth(mesh.local_face(face, p_px));
}

/// The direction of the line in which two planes meet, as its slant.
double slant_of_planes(const ClipMesh& mesh, std::uint32_t face0, std::uint32_t face1) {
    const auto plane = [&](std::uint32_t face) {  // 1/w = plane . (x, y, 1)
        const auto& v = mesh.topology().faces[face].vertices;
        const glm::dvec3 &a = mesh.p_clip()[v[0]], &b = mesh.p_clip()[v[1]],
                         &c = mesh.p_clip()[v[2]];
        const glm::dvec3 n = glm::cross(b - a, c - a);
        return n / glm::dot(n, a);
    };
    const glm::dvec3 difference = plane(face0) - plane(face1);
    return slant_of({difference.x, difference.y});
}

/// Whether the surface goes on where one ends: in what is seen beyond, or, if that is a slit of the
/// weld tolerance behind a border, in what is seen behind the slit. An edge of two faces has no
/// such slit.
bool goes_on(const SightRays& rays, const MetEdge& end, const Sample& beyond, Sample& next) {
    const ClipMesh& mesh = rays.mesh();
    next = beyond;
    if (end.line_class != truth::LineClass::boundary) return is_touched(mesh, end, beyond);
    const double px_per_unit = mesh.projection().px_per_world(end.w);
    const double tolerance = mesh.tolerance(end.face, end.w);
    const auto touches = [&](std::uint32_t face) {
        return mesh.goes_on(end.face, face, end.p_world, {tolerance, tolerance});
    };
    // Small triangles may lie between the sample and the end: the surface is followed back to it.
    const auto continues = [&](const Sample& sample) {
        if (sample.sight.face == kNothing) return false;
        if (touches(sample.sight.face)) return true;
        return touches(walk(mesh, sample, mesh.px(end.p_world), Stop::at_feature).face);
    };
    if (continues(beyond)) return true;
    next.p_px = mesh.px(end.p_world) + end.outward * (2 * tolerance * px_per_unit + 1.0 / 512);
    next.sight = rays.look(next.p_px);
    return continues(next);
}

/// One surface's end, told: a line, a defect, or nothing where only the near plane cuts.
void add_end(const SightRays& rays, const MetEdge& end, const Sample& beyond, Between& between) {
    const ClipMesh& mesh = rays.mesh();
    if (end.w < mesh.view().camera.near) {
        between.is_near_cut = true;
        return;
    }
    truth::LineClass line_class = end.line_class;
    Sample next;
    if (goes_on(rays, end, beyond, next)) {
        between.is_defect = true;
        if (!mesh.is_seam(end.face, next.sight.face)) return;
        line_class = truth::LineClass::seam;
    }
    const bool is_known = between.count == 1 && between.lines[0].line_class == line_class;
    if (!is_known) between.lines[between.count++] = {line_class, end.slant(), edge_of(mesh, end)};
}

/// The ends of the surfaces that are seen at the two samples: of the nearer one, of both where they
/// lie on each other.
void add_ends(const SightRays& rays,
              const std::array<Sample, 2>& samples,
              const std::array<Walk, 2>& walks,
              Between& between) {
    const ClipMesh& mesh = rays.mesh();
    const auto has_ended = [&](std::size_t i) {
        return samples[i].sight.face != kNothing && !walks[i].has_arrived &&
               walks[i].met.line_class != truth::LineClass::none;
    };
    for (std::size_t i = 0; i < 2; ++i) {
        if (!has_ended(i)) continue;
        const double reach = 4 * mesh.tolerance(walks[i].met.face, walks[i].met.w);
        const bool is_behind = has_ended(1 - i) && walks[1 - i].met.w + reach < walks[i].met.w;
        if (is_behind) continue;
        if (is_under(mesh, walks[i].met, samples[1 - i])) {
            // Pieces of a cracked surface overlap as well as gape.
            Sample next;
            const bool is_border = walks[i].met.line_class == truth::LineClass::boundary;
            if (is_border && goes_on(rays, walks[i].met, samples[1 - i], next))
                between.is_defect = !mesh.is_seam(walks[i].met.face, next.sight.face);
            continue;
        }
        add_end(rays, walks[i].met, samples[1 - i], between);
    }
}

/// Whether the face that the way to a feature leads to coincides with what is seen beyond: a crease
/// there bends what is seen, whichever of the two faces that is.
bool bends_into(const ClipMesh& mesh, const Walk& walk, const Sample& beyond) {
    return walk.met.line_class == truth::LineClass::crease &&
           mesh.is_level(walk.face, beyond.sight.face);
}

/// Tells a feature that the surface seen at sample `i` passes before the other hides it: seen,
/// though by less than the distance of two samples. False if there is none.
bool add_passed(const ClipMesh& mesh,
                std::size_t i,
                const std::array<Sample, 2>& samples,
                const std::array<Walk, 2>& walks,
                Between& between) {
    const MetEdge& met = walks[i].met;
    const bool has_passed = walks[i].has_arrived && met.line_class != truth::LineClass::none;
    const Sample& other = samples[1 - i];
    if (!has_passed || other.sight.face == kNothing) return false;
    if (!is_out(mesh, met, other) && !bends_into(mesh, walks[i], other)) return false;
    between.lines[between.count++] = {met.line_class, met.slant(), edge_of(mesh, met)};
    return true;
}

/// Whether one surface, followed to the other sample, lies in what is seen there: then nothing is
/// crossed, and the line is what the way passed, or a seam of two objects in one plane.
bool add_overlap(const ClipMesh& mesh,
                 const std::array<Sample, 2>& samples,
                 const std::array<Walk, 2>& walks,
                 Between& between) {
    for (std::size_t i = 0; i < 2; ++i) {
        const std::uint32_t seen = samples[1 - i].sight.face;
        if (!walks[i].has_arrived || !mesh.is_level(walks[i].face, seen)) continue;
        const MetEdge& met = walks[i].met;
        const bool is_seam = mesh.is_seam(samples[i].sight.face, seen);
        // A seam on the way was one to a surface that the seen one covers.
        const bool is_covered = met.line_class == truth::LineClass::seam && !is_seam;
        if (met.line_class != truth::LineClass::none && !is_covered) {
            between.lines[between.count++] = {met.line_class, met.slant(), edge_of(mesh, met)};
        } else if (is_seam) {
            // The other surface is what bends here.
            between.lines[between.count++] = {truth::LineClass::seam, walks[1 - i].met.slant()};
        }
        return true;
    }
    return false;
}

/// Whether the faces that are seen to either side join where a feature is passed, both with a side
/// there, and what lies beyond either is hidden: then they bend by a crease, and cross, or are one
/// surface, with a seam where objects differ.
bool add_join(const ClipMesh& mesh,
              const std::array<Sample, 2>& samples,
              const std::array<Walk, 2>& walks,
              Between& between) {
    const std::uint32_t face0 = samples[0].sight.face, face1 = samples[1].sight.face;
    if (mesh.deviation_between(face0, face1) >= mesh.crease_rad()) return false;
    for (const Walk& walk : walks) {
        const MetEdge& met = walk.met;
        if (met.line_class == truth::LineClass::none) continue;
        const scene::RoundedPoint point = point_of(mesh, met);
        if (!is_on_side(mesh, face0, point) || !is_on_side(mesh, face1, point)) continue;
        if (mesh.is_seam(face0, face1))
            between.lines[between.count++] = {truth::LineClass::seam, met.slant()};
        return true;
    }
    return false;
}

/// Whether a border of the face passes the point within two weld tolerances, and `other` goes on
/// beyond it.
bool ends_on(const ClipMesh& mesh,
             std::uint32_t face,
             std::uint32_t other,
             const glm::dvec3& p_world,
             double w) {
    const scene::Face& f = mesh.topology().faces[face];
    const auto& p = mesh.topology().p_world;
    const double tolerance = mesh.tolerance(face, w);
    for (std::size_t i = 0; i < 3; ++i) {
        if (mesh.topology().edges[f.edges[i]].face_count != 1) continue;
        const glm::dvec3 &a = p[f.vertices[i]], &b = p[f.vertices[(i + 1) % 3]];
        const glm::dvec3 along = b - a;
        const glm::dvec3 border = a + scene::nearest_share(p_world, a, b) * along;
        if (glm::length(p_world - border) > 2 * tolerance) continue;
        const glm::dvec3 d = p[f.vertices[(i + 2) % 3]] - a;
        const glm::dvec3 inward =
            glm::normalize(d - along * (glm::dot(d, along) / glm::dot(along, along)));
        const glm::dvec3 beyond = border - 2 * tolerance * inward;
        if (mesh.goes_on(face, other, beyond, {2 * tolerance, tolerance})) return true;
    }
    return false;
}

/// Whether two pieces of a cracked surface cross where they overlap by no more than the tolerance:
/// the border of one lies there, the other goes on beyond it, and their planes are flatter to each
/// other than a crease.
bool is_slit(const ClipMesh& mesh,
             const std::array<Sample, 2>& samples,
             const std::array<std::uint32_t, 2>& faces) {
    // Where the depths of both are the same.
    const double w_beyond = depth_at(mesh, faces[0], samples[1].p_px);
    const double before = depth_at(mesh, faces[1], samples[0].p_px) - samples[0].sight.w;
    const double behind = w_beyond - samples[1].sight.w;
    const double s = before + behind != 0 ? before / (before + behind) : 0.5;
    const glm::dvec2 p_px = glm::mix(samples[0].p_px, samples[1].p_px, s);
    const double w = glm::mix(samples[0].sight.w, w_beyond, s);
    const glm::dvec3 p_world = mesh.projection().at(p_px.x, p_px.y, mesh.projection().depth_of(w));
    // Either may show its back: where the surface folds before the eye its borders are drawn.
    const double deviation = mesh.deviation_between(faces[0], faces[1]);
    return std::min(deviation, std::numbers::pi - deviation) < mesh.crease_rad() &&
           !mesh.is_seam(faces[0], faces[1]) &&
           (ends_on(mesh, faces[0], faces[1], p_world, w) ||
            ends_on(mesh, faces[1], faces[0], p_world, w));
}

/// Two surfaces that both go on at both samples: one passes through the other, or the near plane
/// takes one away, or they coincide.
void add_meeting(const ClipMesh& mesh,
                 const std::array<Sample, 2>& samples,
                 const std::array<Walk, 2>& walks,
                 Between& between) {
    const double near = mesh.view().camera.near;
    std::array<double, 2> w_beyond{};
    for (std::size_t i = 0; i < 2; ++i) {
        if (samples[i].sight.face == kNothing) continue;
        w_beyond[i] = depth_at(mesh, walks[i].face, samples[1 - i].p_px);
        between.is_near_cut = between.is_near_cut || w_beyond[i] < near;
    }
    if (between.is_near_cut) return;
    if (samples[0].sight.face == kNothing || samples[1].sight.face == kNothing) {
        between.is_explained = false;
        return;
    }
    if (add_overlap(mesh, samples, walks, between)) return;
    const auto is_same = [](double a, double b) { return std::abs(a - b) <= kSameDepth * a; };
    if (is_same(w_beyond[0], samples[1].sight.w) && is_same(w_beyond[1], samples[0].sight.w))
        return;
    if (add_join(mesh, samples, walks, between)) return;
    std::array<std::uint32_t, 2> faces{};  // where they cross
    for (std::size_t i = 0; i < 2; ++i) {
        const bool has_passed = add_passed(mesh, i, samples, walks, between);
        faces[i] = has_passed ? walks[i].face : samples[i].sight.face;
    }
    if (is_slit(mesh, samples, faces)) {
        between.is_defect = true;
        return;
    }
    between.lines[between.count++] = {truth::LineClass::intersection,
                                      slant_of_planes(mesh, faces[0], faces[1])};
}

}  // namespace

Between name_between(const SightRays& rays, const Sample& from, const Sample& to) {
    const ClipMesh& mesh = rays.mesh();
    const std::array<Sample, 2> samples{from, to};
    std::array<Walk, 2> walks;
    Between between;
    for (std::size_t i = 0; i < 2; ++i) {
        if (samples[i].sight.face == kNothing) continue;
        walks[i] = walk(mesh, samples[i], samples[1 - i].p_px, Stop::at_end);
        if (samples[1 - i].sight.face == kNothing || !arrives_at(mesh, walks[i], samples[1 - i]))
            continue;
        if (walks[i].met.line_class == truth::LineClass::none) return between;
        if (walks[i].met.w < mesh.view().camera.near) continue;
        const MetEdge& met = walks[i].met;
        between.lines[between.count++] = {met.line_class, met.slant(), edge_of(mesh, met)};
        return between;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::dvec2 d = samples[1 - i].p_px - samples[i].p_px;
        if (walks[i].has_arrived)
            walks[i] = ended_round(mesh, walks[i], samples[1 - i], d, rays.reach_px());
    }
    add_ends(rays, samples, walks, between);
    for (std::size_t i = 0; i < 2 && between.count == 1; ++i)
        add_passed(mesh, i, samples, walks, between);
    const bool is_told = between.count > 0 || between.is_defect || between.is_near_cut;
    if (!is_told) add_meeting(mesh, samples, walks, between);
    return between;
}

}  // namespace ink::crosscheck
