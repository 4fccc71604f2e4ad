#include "truth/sampled.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "truth/touching.h"
#include "truth/truth.h"

namespace ink::truth {
namespace {

constexpr double kAtHit_px = 1e-3;  ///< design, section 5: an end triangle this near counts as hit
constexpr double kSameDepth = 1e-10;  ///< relative: rounding between two ways to reach one depth
constexpr int kMostSteps = 100000;    ///< faces a walk may cross; against endless loops only

/// The segment from one pixel centre to its neighbour: s = 0 at the one, 1 at the other.
struct Segment {
    double x_px = 0, y_px = 0;  ///< of s = 0
    double dx = 0, dy = 0;      ///< one of them 1 or -1, the other 0
};

/// A point of the mesh above the segment's line, in the plane of that line and the eye: s = u / w.
struct PlanePoint {
    double u = 0;
    double w = 0;
    [[nodiscard]] double s() const { return u / w; }
};

/// Above zero if p lies further along the segment than o on a face that holds both, as far as the
/// face is before the eye; holds for w of either sign.
double ahead(const PlanePoint& p, const PlanePoint& o) {
    return p.u * o.w - o.u * p.w;
}

/// Where a walk passes over an edge.
struct Passage {
    std::uint32_t edge = 0;
    double t = 0;  ///< on the edge, from a to b
    PlanePoint point;
};

/// A face that a walk ran over: q = 1/w there is slope * s + offset, from s_begin to s_end.
struct Piece {
    double s_begin = 0, s_end = 0;
    double slope = 0, offset = 0;
};

struct Feature {
    std::uint32_t edge = 0;
    double s = 0;
    double q = 0;
};

/// What a walk met.
struct Walk {
    bool reached = false;            ///< the other face, without crossing a feature edge
    std::optional<Feature> feature;  ///< the first feature edge it crossed
    std::vector<Piece> pieces;

    /// 1/w of the walked surface at s, nothing where the walk did not come.
    [[nodiscard]] std::optional<double> q_at(double s) const {
        for (const Piece& piece : pieces) {
            if (s <= piece.s_end) return piece.slope * s + piece.offset;
        }
        return std::nullopt;
    }
    /// How far it came.
    [[nodiscard]] double end() const {
        if (feature) return feature->s;
        return pieces.empty() ? 0 : std::min(pieces.back().s_end, 1.0);
    }
};

class Walker {
  public:
    explicit Walker(const EyeView& eye) : eye_(eye) {}

    /// Walks from `face` at s = 0 towards s = 1 until `goal`, a feature edge, or the end.
    void walk(const Segment& segment, std::uint32_t face, std::uint32_t goal, Walk& out) {
        segment_ = segment;
        out.reached = false;
        out.feature.reset();
        out.pieces.clear();
        std::uint32_t entered = kNoEdge;
        double s = -std::numeric_limits<double>::infinity();
        for (int step = 0; step < kMostSteps && face != kNoFace; ++step) {
            if (face == goal) {
                out.reached = true;
                return;
            }
            const auto exit = leave(face, entered, s, out);
            if (!exit || exit->point.w < eye_.near || exit->point.s() < s - kAtHit_px) return;
            if (exit->point.s() > 1 + kAtHit_px) {
                look_round(face, goal, out);
                return;
            }
            s = exit->point.s();
            if (eye_.class_at(exit->edge, exit->t) != LineClass::none) {
                out.feature = {exit->edge, s, 1 / exit->point.w};
                return;
            }
            const SeenSheet next = across(*exit, face);
            if (next.face == kNoFace && next.border != kNoEdge) {
                out.feature = {next.border, s, 1 / exit->point.w};
                return;
            }
            face = next.face;
            entered = face != kNoFace && has_edge(face, exit->edge) ? exit->edge : kNoEdge;
        }
    }

  private:
    [[nodiscard]] double height(const glm::dvec3& p) const {
        return segment_.dx != 0 ? p.y - segment_.y_px * p.z : p.x - segment_.x_px * p.z;
    }
    [[nodiscard]] double along(const glm::dvec3& p) const {
        return segment_.dx != 0 ? (p.x - segment_.x_px * p.z) * segment_.dx
                                : (p.y - segment_.y_px * p.z) * segment_.dy;
    }

    /// Where the segment's line crosses an edge. Zero height counts as above, always, so a face is
    /// crossed at two of its edges or none, and both its neighbours agree.
    [[nodiscard]] std::optional<Passage> crossing(std::uint32_t e) const {
        const scene::Edge& edge = eye_.model.topology.edges[e];
        const glm::dvec3& a = eye_.p_clip[edge.a];
        const glm::dvec3& b = eye_.p_clip[edge.b];
        const double height_a = height(a), height_b = height(b);
        if ((height_a >= 0) == (height_b >= 0)) return std::nullopt;
        const double t = height_a / (height_a - height_b);
        return Passage{e, t, {along(a) + t * (along(b) - along(a)), a.z + t * (b.z - a.z)}};
    }

    /// The crossing through which the walk leaves a face; notes the face's piece of the profile.
    std::optional<Passage> leave(std::uint32_t f, std::uint32_t entered, double s, Walk& out) {
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
            const double end = o.w < eye_.near ? std::numeric_limits<double>::infinity() : o.s();
            out.pieces.push_back({s, end, (p.w - o.w) / scale, (o.u - p.u) / scale});
        }
        return exit;
    }

    [[nodiscard]] bool has_edge(std::uint32_t face, std::uint32_t edge) const {
        const auto& edges = eye_.model.topology.faces[face].edges;
        return std::find(edges.begin(), edges.end(), edge) != edges.end();
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

    [[nodiscard]] int side_of(const scene::Edge& edge, std::uint32_t face) const {
        const auto faces = eye_.model.topology.faces_of(edge);
        const auto at = std::find(faces.begin(), faces.end(), face);
        return eye_.side(edge, static_cast<std::size_t>(at - faces.begin()));
    }

    /// What continues the face of a boundary edge.
    [[nodiscard]] std::uint32_t continued(const Passage& at) const {
        for (const Continuation& c : eye_.model.continuations_of(at.edge)) {
            if (at.t >= c.t_begin && at.t <= c.t_end && eye_.goes_on(c)) return c.face;
        }
        return kNoFace;
    }

    /// The walk ended in a face that holds the far centre, which is not the one that the ray met:
    /// the ray may have been a hair beside. Looks over the edges within 1e-3 px for the goal.
    void look_round(std::uint32_t f, std::uint32_t goal, Walk& out) const {
        if (goal == kNoFace) return;
        for (const std::uint32_t e : eye_.model.topology.faces[f].edges) {
            const scene::Edge& edge = eye_.model.topology.edges[e];
            const auto faces = eye_.model.topology.faces_of(edge);
            if (std::find(faces.begin(), faces.end(), goal) == faces.end()) continue;
            const auto t = near_end(edge);
            if (!t) continue;
            if (eye_.class_at(e, *t) == LineClass::none) {
                out.reached = true;
            } else {
                const double w =
                    eye_.p_clip[edge.a].z + *t * (eye_.p_clip[edge.b].z - eye_.p_clip[edge.a].z);
                out.feature = {e, 1, 1 / w};
            }
            return;
        }
    }

    /// The parameter of the edge's point nearest to s = 1 on the screen, if it is within 1e-3 px.
    [[nodiscard]] std::optional<double> near_end(const scene::Edge& edge) const {
        const glm::dvec3& a = eye_.p_clip[edge.a];
        const glm::dvec3& b = eye_.p_clip[edge.b];
        if (a.z <= 0 || b.z <= 0) return std::nullopt;
        const double ax = along(a) / a.z - 1, ay = height(a) / a.z;
        const double dx = along(b) / b.z - 1 - ax, dy = height(b) / b.z - ay;
        const double length2 = dx * dx + dy * dy;
        const double s = length2 > 0 ? std::clamp(-(ax * dx + ay * dy) / length2, 0.0, 1.0) : 0.0;
        if (std::hypot(ax + s * dx, ay + s * dy) > kAtHit_px) return std::nullopt;
        return s * a.z / ((1 - s) * b.z + s * a.z);
    }

    const EyeView& eye_;
    Segment segment_;
};

/// Whether a feature that one walk crossed is in front of what the walk from the other end ran
/// over.
bool is_in_front(const Feature& feature, const Walk& other, double near) {
    if (other.feature && other.feature->edge == feature.edge) return true;
    const auto q = other.q_at(1 - feature.s);
    if (!q || *q * near > 1 + kSameDepth) return true;
    return feature.q >= *q * (1 - kSameDepth);
}

/// A point between the two centres where the surface of one walk comes out of that of the other.
struct Emergence {
    double s = 0;
    double q = 0;
};

/// Where the surface walked from the first centre, until then the nearer, goes under that walked
/// from the second: there the two pierce each other.
class Profiles {
  public:
    Profiles(const Walk& there, const Walk& back, double near)
        : there_(there), back_(back), near_(near) {}

    [[nodiscard]] std::optional<Emergence> crossing() {
        list_breaks();
        std::optional<Gap> above;
        for (const double s : breaks_) {
            const auto gap = gap_at(s);
            if (!gap) continue;
            if (gap->difference > kSameDepth * gap->q) {
                above = gap;
            } else if (above && gap->difference < -kSameDepth * gap->q) {
                // Linear in between; a break between may have been a tie, and is as good.
                const double part = above->difference / (above->difference - gap->difference);
                return Emergence{above->s + part * (gap->s - above->s),
                                 above->q + part * (gap->q - above->q)};
            }
        }
        return std::nullopt;
    }

  private:
    struct Gap {
        double s, q, difference;
    };

    /// 1/w of the first surface less that of the second, if both are there.
    [[nodiscard]] std::optional<Gap> gap_at(double s) const {
        const auto q0 = there_.q_at(s), q1 = back_.q_at(1 - s);
        if (!q0 || !q1 || *q0 * near_ > 1 || *q1 * near_ > 1) return std::nullopt;
        return Gap{s, *q0, *q0 - *q1};
    }

    /// Where either profile may bend, in the part that both walks ran over, ascending.
    void list_breaks() {
        const double low = std::max(0.0, 1 - back_.end()), high = std::min(1.0, there_.end());
        if (low >= high) return;
        breaks_ = {low, high};
        const auto keep = [&](double s) {
            if (s > low && s < high) breaks_.push_back(s);
        };
        for (const Piece& piece : there_.pieces)
            keep(piece.s_end);
        for (const Piece& piece : back_.pieces)
            keep(1 - piece.s_end);
        std::sort(breaks_.begin(), breaks_.end());
    }

    const Walk& there_;
    const Walk& back_;
    double near_;
    std::vector<double> breaks_;
};

/// At which of two neighbours the line between them is drawn.
enum class Mark : std::uint8_t { none, first, second };

class PairRule {
  public:
    explicit PairRule(const EyeView& eye) : near_(eye.near), walker_(eye) {}

    Mark mark(const Segment& forward, std::uint32_t first, std::uint32_t second) {
        const Segment back{
            forward.x_px + forward.dx, forward.y_px + forward.dy, -forward.dx, -forward.dy};
        walker_.walk(forward, first, second, there_);
        if (there_.reached) return Mark::none;
        walker_.walk(back, second, first, back_);
        if (back_.reached) return Mark::none;
        const bool at_first = there_.feature && is_in_front(*there_.feature, back_, near_);
        const bool at_second = back_.feature && is_in_front(*back_.feature, there_, near_);
        const auto emergence = Profiles(there_, back_, near_).crossing();
        if (!at_first && !at_second) {
            if (!emergence) return Mark::none;
            return emergence->s < 0.5 ? Mark::first : Mark::second;
        }
        const bool is_second_nearer =
            !at_first || (at_second && there_.feature->edge != back_.feature->edge &&
                          back_.feature->q > there_.feature->q * (1 + kSameDepth));
        double s = is_second_nearer ? 1 - back_.feature->s : there_.feature->s;
        const double q = is_second_nearer ? back_.feature->q : there_.feature->q;
        if (emergence && emergence->q > q * (1 + kSameDepth)) s = emergence->s;
        return s < 0.5 ? Mark::first : Mark::second;
    }

  private:
    double near_;
    Walker walker_;
    Walk there_, back_;
};

}  // namespace

edge::EdgeImage draw_sampled(const EyeView& eye,
                             const core::Image<std::uint32_t>& face,
                             int threads) {
    const int width = face.width_px(), height = face.height_px();
    edge::EdgeImage image(width, height);
    // Rows are walked side by side, so a vertical pair only notes which of its two pixels is drawn.
    core::Image<Mark> below(width, height, Mark::none);
    core::parallel_for(static_cast<std::size_t>(height), threads, [&](std::size_t row) {
        PairRule rule(eye);
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) {
            const std::uint32_t here = face.at(x, y);
            if (x + 1 < width && face.at(x + 1, y) != here) {
                const Mark mark = rule.mark({x + 0.5, y + 0.5, 1, 0}, here, face.at(x + 1, y));
                if (mark == Mark::first) image.at(x, y) = 255;
                if (mark == Mark::second) image.at(x + 1, y) = 255;
            }
            if (y + 1 < height && face.at(x, y + 1) != here) {
                below.at(x, y) = rule.mark({x + 0.5, y + 0.5, 0, 1}, here, face.at(x, y + 1));
            }
        }
    });
    for (int y = 0; y + 1 < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (below.at(x, y) == Mark::first) image.at(x, y) = 255;
            if (below.at(x, y) == Mark::second) image.at(x, y + 1) = 255;
        }
    }
    return image;
}

}  // namespace ink::truth
