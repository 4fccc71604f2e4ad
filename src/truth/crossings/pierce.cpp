#include "truth/crossings/pierce.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/box.h"
#include "scene/precision/rounding.h"
#include "scene/predicates.h"

namespace ink::truth {
namespace {

constexpr double kShortest = 1e-12;  ///< of an edge in a coplanar triangle: below, a point

/// Of orient3d_value's quotients, with room: of an edge's length.
constexpr double kRelativeError = 1e-12;

using Signs = std::array<int, 3>;
using Side = std::size_t;  ///< of a triangle: joins its vertices i and (i+1)%3, as Face::edges[i]

/// A corner or an inner point of one side of a triangle.
struct End {
    Side side = 0;
    int corner = -1;  ///< its vertex, or -1
};

/// Where a triangle meets the line in which its plane crosses another's: between where the signed
/// height over that plane increases along its counter-clockwise border and where it decreases.
struct Span {
    End rise, fall;
    bool is_point = false;
};

class Pair {
  public:
    Pair(const scene::Topology& topology, std::uint32_t f, std::uint32_t g)
        : p_(topology.p_world), topology_(topology), index_{f, g} {
        for (std::size_t i = 0; i < 2; ++i)
            face_[i] = &topology.faces[index_[i]];
    }

    /// First with every sign that rounding leaves open taken as 0. Where that puts an edge into the
    /// other triangle's plane farther from the triangle itself than rounding can have taken it (a
    /// plane is the more open the farther it is followed), the two are taken as they are.
    Meeting meet() {
        const Meeting meeting = attempt();
        if (!is_too_far_) return meeting;
        is_as_given_ = true;
        return attempt();
    }

  private:
    Meeting attempt() {
        Meeting meeting;
        const std::array<Signs, 2> signs = {signs_of(0), signs_of(1)};
        // A needle's plane is open to rounding; whether the needle lies in the other's is not.
        const std::size_t thin = height(0) < height(1) ? 0 : 1;
        if (is_zero(signs[thin])) {
            meet_in_plane(meeting);
            return meeting;
        }
        if (is_zero(signs[1 - thin])) {
            is_too_far_ = true;
            return meeting;
        }
        if (is_apart(signs[0]) || is_apart(signs[1])) return meeting;
        for (std::size_t i = 0; i < 2; ++i)
            span_[i] = span_of(signs[i]);
        if (span_[0].is_point || span_[1].is_point) return meeting;
        meet_on_line(signs, meeting);
        return meeting;
    }

    /// The sides of the other triangle's plane on which the corners of the i-th lie.
    [[nodiscard]] Signs signs_of(std::size_t i) const {
        const auto& w = face_[1 - i]->vertices;
        Signs signs{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = face_[i]->vertices[k];
            const bool is_shared = v == w[0] || v == w[1] || v == w[2];
            if (!is_shared) {
                signs[k] = -scene::sure_orient3d(
                    point_of(w[0]), point_of(w[1]), point_of(w[2]), point_of(v));
            }
        }
        return signs;
    }
    /// Over the longest side.
    [[nodiscard]] double height(std::size_t i) const {
        const auto& v = face_[i]->vertices;
        const glm::dvec3 a = p_[v[1]] - p_[v[0]], b = p_[v[2]] - p_[v[0]];
        const double longest = std::max({glm::length(a), glm::length(b), glm::length(b - a)});
        return glm::length(glm::cross(a, b)) / longest;
    }
    [[nodiscard]] static bool is_zero(const Signs& s) {
        return s[0] == 0 && s[1] == 0 && s[2] == 0;
    }
    [[nodiscard]] static bool is_apart(const Signs& s) {
        return s[0] * s[1] > 0 && s[1] * s[2] > 0;
    }

    [[nodiscard]] bool is_shared(std::size_t i, Side side) const {
        const auto& others = face_[1 - i]->edges;
        return std::ranges::find(others, face_[i]->edges[side]) != others.end();
    }

    [[nodiscard]] static Span span_of(const Signs& s) {
        Span span;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            const int corner = s[i] == 0      ? static_cast<int>(i)
                               : s[next] == 0 ? static_cast<int>(next)
                                              : -1;
            if (s[i] <= 0 && s[next] >= 0 && s[i] < s[next]) span.rise = {i, corner};
            if (s[i] >= 0 && s[next] <= 0 && s[i] > s[next]) span.fall = {i, corner};
        }
        span.is_point = span.rise.corner >= 0 && span.rise.corner == span.fall.corner;
        return span;
    }

    [[nodiscard]] scene::RoundedPoint point_of(std::uint32_t vertex) const {
        return {p_[vertex], is_as_given_ ? 0 : topology_.rounding_world[vertex]};
    }

    [[nodiscard]] std::array<std::uint32_t, 2> side_vertices(std::size_t i, Side side) const {
        return {face_[i]->vertices[side], face_[i]->vertices[(side + 1) % 3]};
    }

    /// On which side of the first triangle's directed side `a` the end of the second's span on its
    /// side `b` lies, in the first's plane: 1 left (inwards), -1 right, 0 on its line. `slope` says
    /// whether the second's height rises (1) or falls (-1) along b.
    ///
    /// For R where r-s meets the plane of p, q: volume(p, q, r, s) = area(p, q, R) (h(s) - h(r)).
    [[nodiscard]] int left_of(Side a, Side b, int slope) const {
        const auto [p, q] = side_vertices(0, a);
        const auto [r, s] = side_vertices(1, b);
        if (p == r || p == s || q == r || q == s) return 0;
        return -scene::sure_orient3d(point_of(p), point_of(q), point_of(r), point_of(s)) * slope;
    }

    /// Along the cross product of both normals, the first triangle's span runs from its rise to its
    /// fall, the second's from its fall to its rise.
    void meet_on_line(const std::array<Signs, 2>& signs, Meeting& meeting) {
        const Span& f = span_[0];
        const Span& g = span_[1];
        if (left_of(f.rise.side, g.rise.side, 1) <= 0) return;
        if (left_of(f.fall.side, g.fall.side, -1) <= 0) return;
        const bool g_begins_later = left_of(f.rise.side, g.fall.side, -1) > 0;
        const bool g_ends_earlier = left_of(f.fall.side, g.rise.side, 1) > 0;
        Crossing crossing;
        crossing.face0 = index_[0];
        crossing.face1 = index_[1];
        crossing.begin_world =
            g_begins_later ? point(1, g.fall, crossing.error) : point(0, f.rise, crossing.error);
        crossing.end_world =
            g_ends_earlier ? point(1, g.rise, crossing.error) : point(0, f.fall, crossing.error);
        bool is_on_edge = false;
        for (std::size_t i = 0; i < 2; ++i) {
            for (Side side = 0; side < 3; ++side) {
                if (signs[i][side] != 0 || signs[i][(side + 1) % 3] != 0) continue;
                is_on_edge = true;
                if (!is_shared(i, side)) add_contact(i, side, crossing, meeting);
            }
        }
        if (!is_on_edge) meeting.crossing = crossing;
    }

    /// Where an end lies; raises `error` to that of its coordinates.
    [[nodiscard]] glm::dvec3 point(std::size_t i, const End& end, double& error) const {
        if (end.corner >= 0) return p_[face_[i]->vertices[static_cast<std::size_t>(end.corner)]];
        const auto& w = face_[1 - i]->vertices;
        auto [a, b] = side_vertices(i, end.side);
        if (a > b) std::swap(a, b);  // both faces of an edge then round alike
        const double at_a = scene::orient3d_value(p_[w[0]], p_[w[1]], p_[w[2]], p_[a]);
        const double at_b = scene::orient3d_value(p_[w[0]], p_[w[1]], p_[w[2]], p_[b]);
        const glm::dvec3 along = p_[b] - p_[a];
        const glm::dvec3 size = glm::abs(p_[a]) + glm::abs(p_[b]);
        error = std::max(error,
                         kRelativeError * glm::length(along) +
                             4 * std::numeric_limits<double>::epsilon() * glm::length(size));
        return p_[a] + at_a / (at_a - at_b) * along;
    }

    void add_contact(std::size_t i, Side side, const Crossing& crossing, Meeting& meeting) {
        const scene::Edge& edge = topology_.edges[face_[i]->edges[side]];
        const auto parameter = [&](const glm::dvec3& p) {
            if (p == p_[edge.a]) return 0.0;
            if (p == p_[edge.b]) return 1.0;
            return scene::nearest_share(p, p_[edge.a], p_[edge.b]);
        };
        const auto [begin, end] =
            std::minmax({parameter(crossing.begin_world), parameter(crossing.end_world)});
        if (begin < end) keep(i, {face_[i]->edges[side], begin, end, index_[1 - i]}, meeting);
    }

    /// Keeps a contact of an edge of the i-th triangle if its ends are as near to the other one as
    /// rounding may have taken them from it.
    void keep(std::size_t i, const Contact& contact, Meeting& meeting) {
        if (is_as_given_ || touches(i, contact)) {
            meeting.contacts[meeting.contact_count++] = contact;
        } else {
            is_too_far_ = true;
        }
    }

    [[nodiscard]] bool touches(std::size_t i, const Contact& contact) const {
        const scene::Edge& edge = topology_.edges[contact.edge];
        const auto& w = face_[1 - i]->vertices;
        double most = 0;
        for (const std::uint32_t v : w)
            most = std::max(most, point_of(v).rounding);
        most += std::max(point_of(edge.a).rounding, point_of(edge.b).rounding);
        most += kRelativeError * glm::length(p_[edge.b] - p_[edge.a]);
        const auto distance = [&](double t) {
            return distance_to_triangle(p_[edge.a] + t * (p_[edge.b] - p_[edge.a]),
                                        {p_[w[0]], p_[w[1]], p_[w[2]]});
        };
        return distance(contact.t_begin) <= most && distance(contact.t_end) <= most;
    }

    void meet_in_plane(Meeting& meeting) {
        for (std::size_t i = 0; i < 2; ++i) {
            for (Side side = 0; side < 3; ++side) {
                if (!is_shared(i, side)) clip_in_plane(i, face_[i]->edges[side], meeting);
            }
        }
        meeting.is_coplanar = meeting.contact_count > 0;
    }

    /// A point off the other triangle's plane: through it and a line of the plane goes a plane
    /// that tells the line's sides.
    [[nodiscard]] glm::dvec3 apex(const scene::Face& face) const {
        const auto& [a, b, c] = face.vertices;
        const glm::dvec3 u = p_[b] - p_[a], v = p_[c] - p_[a];
        const glm::dvec3 n = glm::abs(glm::cross(u, v));
        const int axis = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
        glm::dvec3 result = p_[a];
        result[axis] += std::max({glm::length(u), glm::length(v), std::abs(result[axis]) * 1e-3});
        return result;
    }

    /// The part of an edge of the i-th triangle that lies on the other one. A side of that may be
    /// followed so far that rounding leaves open on which side of it an end lies; where the part
    /// then reaches off the triangle, the end is taken as it is.
    void clip_in_plane(std::size_t i, std::uint32_t e, Meeting& meeting) {
        for (const bool is_as_given : {is_as_given_, true}) {
            const Contact contact = clipped(i, e, is_as_given);
            if (contact.t_end - contact.t_begin < kShortest) return;
            if (!touches(i, contact)) continue;
            meeting.contacts[meeting.contact_count++] = contact;
            return;
        }
    }

    [[nodiscard]] Contact clipped(std::size_t i, std::uint32_t e, bool is_as_given) const {
        const scene::Edge& edge = topology_.edges[e];
        const scene::Face& other = *face_[1 - i];
        const glm::dvec3 top = apex(other);
        const int inwards = scene::orient3d(
            p_[other.vertices[0]], p_[other.vertices[1]], top, p_[other.vertices[2]]);
        Contact contact{e, 0, 1, index_[1 - i]};
        for (Side side = 0; side < 3; ++side) {
            const std::uint32_t r = other.vertices[side], s = other.vertices[(side + 1) % 3];
            const auto height = [&](std::uint32_t v) {
                if (v == r || v == s) return 0.0;
                const double value = scene::orient3d_value(p_[r], p_[s], top, p_[v]);
                const double doubt =
                    is_as_given
                        ? 0
                        : scene::orient3d_doubt(point_of(r), point_of(s), {top, 0}, point_of(v));
                return std::abs(value) <= doubt ? 0.0 : inwards * value;
            };
            const double at_a = height(edge.a), at_b = height(edge.b);
            if (at_a <= 0 && at_b <= 0 && (at_a < 0 || at_b < 0)) return {e, 0, 0, index_[1 - i]};
            if (at_a >= 0 && at_b >= 0) continue;
            const double root = at_a / (at_a - at_b);
            if (at_a < 0) {
                contact.t_begin = std::max(contact.t_begin, root);
            } else {
                contact.t_end = std::min(contact.t_end, root);
            }
        }
        return contact;
    }

    const std::vector<glm::dvec3>& p_;
    const scene::Topology& topology_;
    std::array<std::uint32_t, 2> index_;
    std::array<const scene::Face*, 2> face_{};
    std::array<Span, 2> span_;
    bool is_as_given_ = false;  ///< rounding is left out
    bool is_too_far_ = false;
};

}  // namespace

double distance_to_triangle(const glm::dvec3& p, const std::array<glm::dvec3, 3>& corners) {
    const auto& [a, b, c] = corners;
    const glm::dvec3 u = b - a, v = c - a, d = p - a;
    const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v);
    const double du = glm::dot(d, u), dv = glm::dot(d, v);
    const double area2 = uu * vv - uv * uv;
    const double s = vv * du - uv * dv, t = uu * dv - uv * du;
    const double on_border = std::min({scene::distance_to_segment(p, a, b),
                                       scene::distance_to_segment(p, b, c),
                                       scene::distance_to_segment(p, c, a)});
    if (!(area2 > 0) || s < 0 || t < 0 || s + t > area2) return on_border;
    return std::min(on_border, glm::length(d - (s * u + t * v) / area2));
}

Meeting meet(const scene::Topology& topology, std::uint32_t f, std::uint32_t g) {
    return Pair(topology, std::min(f, g), std::max(f, g)).meet();
}

}  // namespace ink::truth
