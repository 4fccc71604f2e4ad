#include "truth/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "truth/crossings/touching.h"

namespace ink::truth {
namespace {

constexpr double kAtHit_px = 1e-3;  ///< design, section 5: an end triangle this near counts as hit
constexpr double kCrack_px = 1.0 / 64;  ///< ends of two borders this near are the same to any eye
constexpr int kMostSteps = 100000;      ///< faces a walk may cross; against endless loops only

/// A point of the mesh above the segment's line, in the plane of that line and the eye: s = u / h,
/// 1/w = q / h.
struct PlanePoint {
    double u = 0;
    double h = 0;
    double q = 0;
    [[nodiscard]] double s() const { return u / h; }
    [[nodiscard]] double inverse_w() const { return q / h; }
};

/// Above zero if p lies further along the segment than o on a face that holds both, as far as the
/// face is before the eye; holds for h of either sign.
double ahead(const PlanePoint& p, const PlanePoint& o) {
    return p.u * o.h - o.u * p.h;
}

/// Where a walk passes over an edge.
struct Passage {
    std::uint32_t edge = 0;
    double t = 0;  ///< on the edge, from a to b
    PlanePoint point;
};

class Walker {
  public:
    Walker(const EyeView& eye, const CentrePair& pair) : eye_(eye), pair_(pair) {}

    void walk(SurfaceWalk& out) {
        std::uint32_t face = pair_.from;
        const std::uint32_t goal = pair_.to;
        out.reached = false;
        out.has_left_patch = false;
        out.feature.reset();
        out.pieces.clear();
        std::uint32_t entered = kNoEdge;
        double s = -std::numeric_limits<double>::infinity();
        for (int step = 0; step < kMostSteps && face != kNoFace; ++step) {
            if (face == goal) {
                out.reached = true;
                return;
            }
            const auto exit = leave(face, entered, out);
            if (!exit || is_near(exit->point) || exit->point.s() < s - kAtHit_px) return;
            if (exit->point.s() > 1 + kAtHit_px) {
                look_round(face, goal, out);
                return;
            }
            s = exit->point.s();
            if (eye_.class_at(exit->edge, exit->t) != LineClass::none) {
                out.feature = {exit->edge, s, exit->point.inverse_w()};
                return;
            }
            const SeenSheet next = across(*exit, face);
            if (next.face == kNoFace && next.border != kNoEdge) {
                out.feature = {next.border, s, exit->point.inverse_w()};
                return;
            }
            if (next.face != kNoFace && is_break(exit->edge, face, next.face))
                out.has_left_patch = true;
            face = next.face;
            entered = face != kNoFace && has_edge(face, exit->edge) ? exit->edge : kNoEdge;
        }
    }

  private:
    [[nodiscard]] bool is_near(const PlanePoint& p) const { return p.h < eye_.near * p.q; }
    [[nodiscard]] double height(const glm::dvec4& p) const {
        return pair_.dx != 0 ? p.y - pair_.y_px * p.z : p.x - pair_.x_px * p.z;
    }
    [[nodiscard]] double along(const glm::dvec4& p) const {
        return pair_.dx != 0 ? (p.x - pair_.x_px * p.z) * pair_.dx
                             : (p.y - pair_.y_px * p.z) * pair_.dy;
    }

    /// Where the segment's line crosses an edge. Zero height counts as above, always, so a face is
    /// crossed at two of its edges or none, and both its neighbours agree.
    [[nodiscard]] std::optional<Passage> crossing(std::uint32_t e) const {
        const scene::Edge& edge = eye_.model.topology.edges[e];
        const glm::dvec4& a = eye_.p_clip[edge.a];
        const glm::dvec4& b = eye_.p_clip[edge.b];
        const double height_a = height(a), height_b = height(b);
        if ((height_a >= 0) == (height_b >= 0)) return std::nullopt;
        const double t = height_a / (height_a - height_b);
        const double u = along(a) + t * (along(b) - along(a));
        return Passage{e, t, {u, a.z + t * (b.z - a.z), a.w + t * (b.w - a.w)}};
    }

    /// The crossing through which the walk leaves a face; notes the face's piece of the profile.
    std::optional<Passage> leave(std::uint32_t f, std::uint32_t entered, SurfaceWalk& out) {
        std::optional<Passage> in, exit;
        for (const std::uint32_t e : eye_.model.topology.faces[f].edges) {
            const auto c = crossing(e);
            if (!c) continue;
            if (!in) {
                in = c;
            } else {
                exit = c;
            }
        }
        if (!exit) return std::nullopt;
        const bool is_backwards =
            entered == kNoEdge ? ahead(exit->point, in->point) < 0 : exit->edge == entered;
        if (is_backwards) std::swap(in, exit);
        const PlanePoint& p = in->point;
        const PlanePoint& o = exit->point;
        const double scale = ahead(o, p);
        if (scale != 0) {
            const double end = is_near(o) ? std::numeric_limits<double>::infinity() : o.s();
            out.pieces.push_back(
                {end, (p.h * o.q - o.h * p.q) / scale, (o.u * p.q - p.u * o.q) / scale});
        }
        return exit;
    }

    [[nodiscard]] bool has_edge(std::uint32_t face, std::uint32_t edge) const {
        const auto& edges = eye_.model.topology.faces[face].edges;
        return std::ranges::find(edges, edge) != edges.end();
    }

    /// The face seen beyond an edge that is no line. Where there is none because another face
    /// covers this one and ends here too, the line is that one's border: then `border` alone is
    /// set.
    [[nodiscard]] SeenSheet across(const Passage& at, std::uint32_t from) const {
        const scene::Edge& edge = eye_.model.topology.edges[at.edge];
        if (eye_.model.is_touched[at.edge] != 0) {
            const SeenSheets seen = seen_sheets_at(eye_, at.edge, at.t);
            const bool is_left = side_of(edge, from) < 0;
            const SeenSheet& beyond = is_left ? seen.right : seen.left;
            if (beyond.face != kNoFace) return {beyond.face, kNoEdge};
            const SeenSheet& here = is_left ? seen.left : seen.right;
            if (here.face != from && here.border != kNoEdge) return {kNoFace, here.border};
        }
        const auto faces = eye_.model.topology.faces_of(edge);
        if (faces.size() == 2) return {faces[0] == from ? faces[1] : faces[0], kNoEdge};
        if (faces.size() == 1) return {continued(at), kNoEdge};
        const SeenFaces seen = eye_.seen_faces(edge);
        return {side_of(edge, from) < 0 ? seen.right : seen.left, kNoEdge};
    }

    /// Whether a step over an edge leaves the patch for one that ids tell from it: not over a
    /// crack, where both have the same border, nor between faces that coincide.
    [[nodiscard]] bool is_break(std::uint32_t e, std::uint32_t from, std::uint32_t to) const {
        const Model& model = eye_.model;
        if (model.patch[from] == model.patch[to]) return false;
        const auto coplanar = eye_.model.crossings.coplanar_with(std::max(from, to));
        const auto is_pair = [&](const CoplanarPair& pair) {
            return pair.lower_face == std::min(from, to);
        };
        const scene::Edge& edge = model.topology.edges[e];
        if (std::ranges::any_of(coplanar, is_pair) && overlap(edge, from, to)) return false;
        const auto& borders = model.topology.faces[to].edges;
        return std::ranges::none_of(borders, [&](std::uint32_t other) {
            const scene::Edge& border = model.topology.edges[other];
            return (is_near(edge.a, border.a) && is_near(edge.b, border.b)) ||
                   (is_near(edge.a, border.b) && is_near(edge.b, border.a));
        });
    }

    /// Whether a face that goes on over an edge of another also lies on this one's side of it.
    [[nodiscard]] bool overlap(const scene::Edge& edge,
                               std::uint32_t from,
                               std::uint32_t to) const {
        const auto px = [&](std::uint32_t v) {
            const glm::dvec4& p = eye_.p_clip[v];
            return glm::dvec2(p) / std::max(p.z, eye_.near * p.w);
        };
        const glm::dvec2 a = px(edge.a), along = px(edge.b) - a;
        const auto height = [&](std::uint32_t v) {
            const glm::dvec2 p = px(v) - a;
            return (along.x * p.y - along.y * p.x) / std::hypot(along.x, along.y);
        };
        const double inside = height(opposite_vertex(eye_.model.topology.faces[from], edge));
        const auto& corners = eye_.model.topology.faces[to].vertices;
        return std::ranges::any_of(corners, [&](std::uint32_t v) {
            return height(v) * (inside < 0 ? -1 : 1) > kCrack_px;
        });
    }

    [[nodiscard]] bool is_near(std::uint32_t v, std::uint32_t other) const {
        const glm::dvec4 &a = eye_.p_clip[v], &b = eye_.p_clip[other];
        if (eye_.is_before_near(a) || eye_.is_before_near(b)) return v == other;
        return std::hypot(a.x / a.z - b.x / b.z, a.y / a.z - b.y / b.z) <= kCrack_px;
    }

    [[nodiscard]] int side_of(const scene::Edge& edge, std::uint32_t face) const {
        const auto faces = eye_.model.topology.faces_of(edge);
        const auto at = std::ranges::find(faces, face);
        return eye_.side(edge, static_cast<std::size_t>(at - faces.begin()));
    }

    /// What continues the face of a boundary edge.
    [[nodiscard]] std::uint32_t continued(const Passage& at) const {
        for (const Continuation& c : eye_.model.continuations_of(at.edge)) {
            if (at.t >= c.t_begin && at.t <= c.t_end && eye_.goes_on(c, at.t)) return c.face;
        }
        return kNoFace;
    }

    /// The walk ended in a face that holds the far centre, which is not the one that the ray met:
    /// the ray may have been a hair beside. Looks over the edges within 1e-3 px for the goal.
    void look_round(std::uint32_t f, std::uint32_t goal, SurfaceWalk& out) const {
        if (goal == kNoFace) return;
        for (const std::uint32_t e : eye_.model.topology.faces[f].edges) {
            const scene::Edge& edge = eye_.model.topology.edges[e];
            const auto faces = eye_.model.topology.faces_of(edge);
            if (std::ranges::find(faces, goal) == faces.end()) continue;
            const auto t = near_end(edge);
            if (!t) continue;
            if (eye_.class_at(e, *t) == LineClass::none) {
                out.reached = true;
            } else {
                const glm::dvec4 p = eye_.clip_at(edge, *t);
                out.feature = {e, 1, p.w / p.z};
            }
            return;
        }
    }

    /// The parameter of the edge's point nearest to s = 1 on the screen, if it is within 1e-3 px.
    [[nodiscard]] std::optional<double> near_end(const scene::Edge& edge) const {
        const glm::dvec4& a = eye_.p_clip[edge.a];
        const glm::dvec4& b = eye_.p_clip[edge.b];
        if (a.z <= 0 || b.z <= 0) return std::nullopt;
        const double ax = along(a) / a.z - 1, ay = height(a) / a.z;
        const double dx = along(b) / b.z - 1 - ax, dy = height(b) / b.z - ay;
        const double length2 = dx * dx + dy * dy;
        const double s = length2 > 0 ? std::clamp(-(ax * dx + ay * dy) / length2, 0.0, 1.0) : 0.0;
        if (std::hypot(ax + s * dx, ay + s * dy) > kAtHit_px) return std::nullopt;
        return s * a.z / ((1 - s) * b.z + s * a.z);
    }

    const EyeView& eye_;
    const CentrePair& pair_;
};

}  // namespace

std::optional<double> SurfaceWalk::q_at(double s) const {
    for (const WalkedPiece& piece : pieces) {
        if (s <= piece.s_end) return piece.slope * s + piece.offset;
    }
    return std::nullopt;
}

double SurfaceWalk::end() const {
    if (feature) return feature->s;
    return pieces.empty() ? 0 : std::min(pieces.back().s_end, 1.0);
}

void walk_surface(const EyeView& eye, const CentrePair& pair, SurfaceWalk& out) {
    Walker(eye, pair).walk(out);
}

}  // namespace ink::truth
