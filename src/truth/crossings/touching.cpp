#include "truth/crossings/touching.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/precision/rounding.h"
#include "scene/predicates.h"

namespace ink::truth {
namespace {

/// The part of a face to one side of an edge it contains.
struct Sheet {
    std::uint32_t face = kNoFace;
    std::uint32_t vertex = 0;  ///< one of the face's that lies to that side
    bool is_own = false;       ///< the edge is one of the face's
    bool is_border = false;    ///< the face has no other side

    [[nodiscard]] bool is_there() const { return face != kNoFace; }
};

/// The sheets round one point of an edge, of which each side keeps the nearest.
class Bundle {
  public:
    Bundle(const EyeView& eye, std::uint32_t e, double t)
        : eye_(eye), p_(eye.model.topology.p_world), edge_(eye.model.topology.edges[e]) {
        for (const std::uint32_t f : eye.model.topology.faces_of(edge_))
            add(f, true);
        for (const Contact& contact : eye.model.crossings.contacts_of(e)) {
            if (contact.t_begin <= t && t <= contact.t_end) add(contact.face, false);
        }
    }

    [[nodiscard]] const Sheet& left() const { return left_; }
    [[nodiscard]] const Sheet& right() const { return right_; }

    /// How far two sheets, one on either side, deviate from flat.
    [[nodiscard]] double deviation_rad(const Sheet& s0, const Sheet& s1) const {
        const glm::dvec3 along = glm::normalize(p_[edge_.b] - p_[edge_.a]);
        const auto into = [&](const Sheet& s) {
            const glm::dvec3 d = p_[s.vertex] - p_[edge_.a];
            return d - along * glm::dot(along, d);
        };
        const glm::dvec3 d0 = into(s0), d1 = into(s1);
        return std::numbers::pi - std::atan2(glm::length(glm::cross(d0, d1)), glm::dot(d0, d1));
    }

    /// Whether two sheets, one on either side, bend by a crease or may, as far as rounding can
    /// tell.
    [[nodiscard]] bool is_crease(const Sheet& s0, const Sheet& s1) const {
        return scene::is_crease(
            deviation_rad(s0, s1), doubt_rad(s0) + doubt_rad(s1), eye_.model.crease_rad);
    }

    /// Whether two sheets, one on either side, bend by a crease whatever rounding did.
    [[nodiscard]] bool is_surely_crease(const Sheet& s0, const Sheet& s1) const {
        return deviation_rad(s0, s1) - doubt_rad(s0) - doubt_rad(s1) >= eye_.model.crease_rad;
    }

    /// Whether two sheets, one on either side, lie in one plane as far as rounding can tell.
    [[nodiscard]] bool is_level(const Sheet& s0, const Sheet& s1) const {
        return orientation(s0.vertex, s1.vertex) == 0;
    }

    /// Whether own faces go on to the side of a touching sheet, which is nearer the eye than they.
    [[nodiscard]] bool hides_own(const Sheet& sheet) const {
        const auto own = eye_.model.topology.faces_of(edge_);
        return std::ranges::any_of(own, [&](std::uint32_t f) {
            return side_of(opposite_vertex(eye_.model.topology.faces[f], edge_)) ==
                   side_of(sheet.vertex);
        });
    }

    /// Whether an own face lies right under this sheet, as far as rounding can tell.
    [[nodiscard]] bool covers_own(const Sheet& sheet) const { return covers(sheet, edge_); }

    /// Whether a face of an edge that lies here does.
    [[nodiscard]] bool covers(const Sheet& sheet, const scene::Edge& edge) const {
        const auto& faces = eye_.model.topology.faces;
        const auto all = eye_.model.topology.faces_of(edge);
        return std::ranges::any_of(all, [&](std::uint32_t f) {
            const std::uint32_t v = opposite_vertex(faces[f], edge);
            return side_of(v) == side_of(sheet.vertex) && orientation(v, sheet.vertex) == 0;
        });
    }

    /// The edge of a face of which this sheet is the whole: the one that lies on ours.
    [[nodiscard]] std::uint32_t border_of(const Sheet& sheet) const {
        if (!sheet.is_there()) return kNoEdge;
        const scene::Face& face = eye_.model.topology.faces[sheet.face];
        return face.edges[side_opposite(face, sheet.vertex)];
    }

  private:
    [[nodiscard]] scene::RoundedPoint point_of(std::uint32_t v) const {
        return scene::rounded_point(eye_.model.topology, v);
    }
    /// How far rounding may have turned a sheet about the edge.
    [[nodiscard]] double doubt_rad(const Sheet& s) const {
        return scene::turning_doubt_rad(point_of(edge_.a), point_of(edge_.b), point_of(s.vertex));
    }
    /// Which way the sheets of two vertices bend at the edge; 0 if rounding leaves it open.
    [[nodiscard]] int orientation(std::uint32_t v0, std::uint32_t v1) const {
        return scene::sure_orient3d(
            point_of(edge_.a), point_of(edge_.b), point_of(v0), point_of(v1));
    }
    /// As side_of, and 0 for a vertex that may lie on the edge as far as rounding can tell.
    [[nodiscard]] int sure_side_of(std::uint32_t v) const {
        return scene::sure_facing(point_of(edge_.a), point_of(edge_.b), point_of(v), eye_.eye());
    }
    /// As EyeView::side: 1 or -1, 0 in the plane of edge and eye.
    [[nodiscard]] int side_of(std::uint32_t v) const {
        return scene::facing(p_[edge_.a], p_[edge_.b], p_[v], eye_.eye());
    }
    [[nodiscard]] bool hides(const Sheet& s0, const Sheet& s1) const {
        const int other = orientation(s0.vertex, s1.vertex);
        if (other == 0) return s0.face < s1.face;
        const glm::dvec3 &a = p_[edge_.a], &b = p_[edge_.b], &v0 = p_[s0.vertex];
        return other != scene::orient3d(a, b, v0, eye_.eye());
    }
    /// A face seen edge-on is in the plane of edge and eye, and on neither side.
    void add(std::uint32_t f, bool is_own) {
        if (eye_.facing[f] == 0) return;
        Sheet left{f, 0, is_own, true}, right = left;
        int sides = 0;
        for (const std::uint32_t v : eye_.model.topology.faces[f].vertices) {
            if (v == edge_.a || v == edge_.b) continue;
            const int s = is_own ? side_of(v) : sure_side_of(v);
            if (s == 0) continue;
            (s < 0 ? left : right).vertex = v;
            sides |= s < 0 ? 1 : 2;
        }
        left.is_border = right.is_border = sides != 3;
        if ((sides & 1) != 0 && (!left_.is_there() || hides(left, left_))) left_ = left;
        if ((sides & 2) != 0 && (!right_.is_there() || hides(right, right_))) right_ = right;
    }

    const EyeView& eye_;
    const std::vector<glm::dvec3>& p_;
    const scene::Edge& edge_;
    Sheet left_, right_;
};

bool is_outline(LineClass c) {
    return c == LineClass::contour || c == LineClass::boundary;
}

/// The class where an own sheet is seen on one side and a touching one on the other.
LineClass class_against(const EyeView& eye,
                        const Bundle& bundle,
                        const Sheet& own,
                        const Sheet& touching,
                        LineClass own_class) {
    // A face that holds the edge inside is pierced by own faces that go on beyond it.
    const bool is_pierced = !touching.is_border && bundle.hides_own(touching) &&
                            !bundle.is_level(own, touching) && !bundle.covers_own(touching);
    if (is_pierced) return LineClass::intersection;
    if (!bundle.is_crease(own, touching)) {
        return eye.model.is_seam(own.face, touching.face) ? LineClass::seam : LineClass::none;
    }
    if (is_outline(own_class)) return own_class;
    if (own_class == LineClass::crease && bundle.covers_own(touching)) return own_class;
    if (!touching.is_border) return LineClass::intersection;
    const std::uint32_t border = bundle.border_of(touching);
    const LineClass of_border = eye.edge_class[border];
    const bool is_drawn_there =
        is_outline(of_border) ||
        (of_border == LineClass::crease && bundle.covers(own, eye.model.topology.edges[border]));
    return is_drawn_there || touching.face < own.face ? LineClass::none : LineClass::intersection;
}

}  // namespace

SeenSheets seen_sheets_at(const EyeView& eye, std::uint32_t edge, double t) {
    const Bundle bundle(eye, edge, t);
    const auto seen = [&](const Sheet& sheet) {
        return SeenSheet{sheet.face, sheet.is_border ? bundle.border_of(sheet) : kNoEdge};
    };
    return {seen(bundle.left()), seen(bundle.right())};
}

double seen_deviation_rad(const EyeView& eye, std::uint32_t edge, double t) {
    const Bundle bundle(eye, edge, t);
    const bool has_both = bundle.left().is_there() && bundle.right().is_there();
    return has_both ? bundle.deviation_rad(bundle.left(), bundle.right()) : 0;
}

LineClass touched_class(const EyeView& eye, std::uint32_t edge, double t, LineClass own_class) {
    const Bundle bundle(eye, edge, t);
    const Sheet& left = bundle.left();
    const Sheet& right = bundle.right();
    if (!left.is_own && !right.is_own) return LineClass::none;
    if (!left.is_there() || !right.is_there() || (left.is_own && right.is_own)) return own_class;
    const Sheet& own = left.is_own ? left : right;
    const Sheet& touching = left.is_own ? right : left;
    // What continues an own face beyond its border lies behind a touching one that surely leaves
    // its plane: it is not seen. One that may lie in the plane may be what goes on.
    const bool hides_rest = bundle.is_surely_crease(own, touching);
    return class_against(eye, bundle, own, touching, hides_rest ? eye.edge_class[edge] : own_class);
}

}  // namespace ink::truth
