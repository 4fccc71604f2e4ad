#include "truth/eye_view.h"

#include <glm/geometric.hpp>

#include "core/parallel.h"
#include "scene/precision/rounding.h"
#include "scene/predicates.h"
#include "truth/crossings/touching.h"

namespace ink::truth {
namespace {

constexpr std::size_t kChunk = 4096;  ///< vertices, faces or edges a task
constexpr double kShortestSlit = 4;   ///< weld tolerances

/// Of two faces on the same side of an edge, whether the first hides the second there. Where
/// rounding leaves open which is nearer they lie on each other.
bool hides(const EyeView& eye, const scene::Edge& edge, std::uint32_t f0, std::uint32_t f1) {
    const scene::Topology& topology = eye.model.topology;
    const auto& p = topology.p_world;
    const auto point = [&](std::uint32_t vertex) { return scene::rounded_point(topology, vertex); };
    const std::uint32_t v0 = scene::opposite_vertex(topology.faces[f0], edge);
    const std::uint32_t v1 = scene::opposite_vertex(topology.faces[f1], edge);
    const int other = scene::sure_orient3d(point(edge.a), point(edge.b), point(v0), point(v1));
    if (other == 0) return f0 < f1;
    return other != scene::orient3d(p[edge.a], p[edge.b], p[v0], eye.eye());
}

LineClass class_of(const EyeView& eye, std::uint32_t e) {
    const scene::Edge& edge = eye.model.topology.edges[e];
    if (edge.face_count == 1) {
        return eye.side(edge, 0) == 0 ? LineClass::none : LineClass::boundary;
    }
    if (edge.face_count == 2) {
        const int side0 = eye.side(edge, 0), side1 = eye.side(edge, 1);
        if (side0 * side1 < 0) return eye.model.flat_class[e];
        return side0 == 0 && side1 == 0 ? LineClass::none : LineClass::contour;
    }
    const SeenFaces seen = eye.seen_faces(edge);
    if (seen.left == kNoFace && seen.right == kNoFace) return LineClass::none;
    if (seen.left == kNoFace || seen.right == kNoFace) return LineClass::contour;
    return eye.model.class_across(edge, seen.left, seen.right);
}

double gap_at(const Continuation& c, double t) {
    const double along = (t - c.t_begin) / (c.t_end - c.t_begin);
    return c.gap_begin_world + along * (c.gap_end_world - c.gap_begin_world);
}

/// Where the gap becomes too small for the image or large enough, on the way along a stretch;
/// outside 0..1 if it nowhere does.
double change_of_sight(const EyeView& eye, const Continuation& c) {
    const scene::Edge& edge = eye.model.topology.edges[c.edge];
    const auto excess = [&](double t) {
        return gap_at(c, t) * eye.projection.focal_px() -
               scene::kUnseen_px * eye.clip_at(edge, t).z;
    };
    const double at_begin = excess(c.t_begin), at_end = excess(c.t_end);
    if ((at_begin < 0) == (at_end < 0)) return -1;
    return c.t_begin + at_begin / (at_begin - at_end) * (c.t_end - c.t_begin);
}

/// Boundary, seam or none (defect) for one stretch between neighbouring ends of continuations.
LineClass class_between(const EyeView& eye,
                        std::uint32_t own_face,
                        std::span<const Continuation> goes_on,
                        double t) {
    LineClass result = LineClass::boundary;
    for (const Continuation& c : goes_on) {
        if (t < c.t_begin || t > c.t_end || !eye.goes_on(c, t)) continue;
        if (!eye.model.is_seam(own_face, c.face)) return LineClass::none;
        result = LineClass::seam;
    }
    return result;
}

/// The class of a point of an edge by its own faces and what continues them, touching faces left
/// out.
LineClass own_class_at(const EyeView& eye, std::uint32_t e, double t) {
    if (eye.edge_class[e] != LineClass::boundary) return eye.edge_class[e];
    const auto continuations = eye.model.continuations_of(e);
    if (continuations.empty()) return LineClass::boundary;
    const std::uint32_t own = eye.model.topology.faces_of(eye.model.topology.edges[e])[0];
    return class_between(eye, own, continuations, t);
}

void append(std::vector<ClassStretch>& stretches, const ClassStretch& next) {
    if (!stretches.empty() && stretches.back().line_class == next.line_class) {
        stretches.back().t_end = next.t_end;
    } else {
        stretches.push_back(next);
    }
}

}  // namespace

EyeView::EyeView(const Model& model_, const scene::View& view, int threads)
    : model(model_),
      projection(view),
      view_from_world(view.camera.view_from_world),
      width_px(view.width_px),
      height_px(view.height_px),
      near(view.camera.near) {
    const scene::Topology& topology = model.topology;
    p_clip.resize(topology.p_world.size());
    core::parallel_for_chunks(p_clip.size(), kChunk, threads, [&](std::size_t v) {
        p_clip[v] = projection.to_homogeneous(topology.p_world[v]);
    });
    facing.resize(topology.faces.size());
    core::parallel_for_chunks(facing.size(), kChunk, threads, [&](std::size_t f) {
        const auto& [a, b, c] = topology.faces[f].vertices;
        const auto& p = topology.p_world;
        facing[f] = static_cast<std::int8_t>(scene::facing(p[a], p[b], p[c], eye()));
    });
    edge_class.resize(topology.edges.size());
    core::parallel_for_chunks(edge_class.size(), kChunk, threads, [&](std::size_t e) {
        edge_class[e] = class_of(*this, static_cast<std::uint32_t>(e));
    });
}

SeenFaces EyeView::seen_faces(const scene::Edge& edge) const {
    SeenFaces seen;
    const auto faces = model.topology.faces_of(edge);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const int s = side(edge, i);
        if (s == 0) continue;
        std::uint32_t& nearest = s < 0 ? seen.left : seen.right;
        if (nearest == kNoFace || hides(*this, edge, faces[i], nearest)) nearest = faces[i];
    }
    return seen;
}

bool EyeView::goes_on(const Continuation& continuation, double t) const {
    const scene::Topology& topology = model.topology;
    const scene::Edge& edge = topology.edges[continuation.edge];
    if (!is_unseen(gap_at(continuation, t), clip_at(edge, t))) return false;
    const glm::dvec3 plane = eye().plane(topology.p_world[edge.a], topology.p_world[edge.b]);
    // orient3d(a, b, eye, v) has the sign of -(a x b).(v - a), where v is beyond the edge.
    const double across = -glm::dot(plane, continuation.into_world);
    return side(edge, 0) * across < 0;
}

LineClass EyeView::class_at(std::uint32_t edge, double t) const {
    const LineClass own_class = own_class_at(*this, edge, t);
    return model.is_touched[edge] != 0 ? touched_class(*this, edge, t, own_class) : own_class;
}

std::vector<ClassStretch> line_stretches(const EyeView& eye, std::uint32_t e) {
    const LineClass whole = eye.edge_class[e];
    const bool is_touched = eye.model.is_touched[e] != 0;
    if (whole == LineClass::none && !is_touched) return {};
    const auto continuations = whole == LineClass::boundary ? eye.model.continuations_of(e)
                                                            : std::span<const Continuation>();
    if (continuations.empty() && !is_touched) return {{whole, 0, 1}};

    const scene::Topology& topology = eye.model.topology;
    const scene::Edge& edge = topology.edges[e];
    const double length = glm::length(topology.p_world[edge.b] - topology.p_world[edge.a]);
    const std::uint32_t object = topology.faces[topology.faces_of(edge)[0]].object;
    const double slit = kShortestSlit * eye.model.tolerances[object] / length;
    std::vector<double> ends = {0, 1};
    for (const Continuation& c : continuations) {
        ends.push_back(c.t_begin);
        ends.push_back(c.t_end);
        const double change = change_of_sight(eye, c);
        if (change > c.t_begin && change < c.t_end) ends.push_back(change);
    }
    for (const Contact& c : eye.model.crossings.contacts_of(e)) {
        ends.push_back(c.t_begin);
        ends.push_back(c.t_end);
    }
    std::ranges::sort(ends);

    std::vector<ClassStretch> all;
    double begin = 0;
    for (const double end : ends) {
        // A slit is what rounding left between two neighbours; it goes to the stretch after it, the
        // last one to the stretch before it.
        if (end - begin < slit && end < 1) continue;
        if (end - begin < slit && !all.empty()) {
            all.back().t_end = end;
            continue;
        }
        append(all, {eye.class_at(e, begin + (end - begin) / 2), begin, end});
        begin = end;
    }
    std::erase_if(all, [](const ClassStretch& s) { return s.line_class == LineClass::none; });
    return all;
}

}  // namespace ink::truth
