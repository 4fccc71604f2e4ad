#include "truth/visibility.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/predicates.h"

namespace ink::truth {
namespace {

constexpr double kBeside = 1.0 / 2048;  ///< px; design, section 5

// How far past the point candidates are taken: the distance that Embree finds for a triangle seen
// at a grazing angle g is off by about 1e-7/sin(g), so this loses none above a thousandth of a
// degree. Those taken in vain cost a predicate each.
constexpr double kPast = 1.0 / 64;

constexpr double kLevel = 1e-9;  ///< of a distance: faces so near to each other lie on each other

/// Of a vector, never below its length.
double size(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// The plane through the eye and two points.
class Sight {
  public:
    Sight(const scene::Viewpoint& eye, const glm::dvec3& q, const glm::dvec3& r)
        : on_plane_(eye.is_direction ? q : eye.at_world), normal_(eye.plane(r, q)) {
        const double across = size(eye.is_direction ? q - r : q - on_plane_);
        noise_ = kRounding * across * size(eye.sight(r));
    }

    /// The side on which a point lies that may be so far off, as orient3d of eye, point, q and r;
    /// 0 if that leaves it open.
    [[nodiscard]] int side(const glm::dvec3& p, double off) const {
        const glm::dvec3 d = p - on_plane_;
        const double height = glm::dot(normal_, d);
        const double bound = off * size(normal_) + noise_ * size(d);
        return std::abs(height) <= bound ? 0 : height > 0 ? 1 : -1;
    }

  private:
    glm::dvec3 on_plane_, normal_;
    double noise_ = 0;
};

}  // namespace

double rounding_between(const glm::dvec3& a, const glm::dvec3& b) {
    return kRounding * (size(a) + size(b));
}

bool Visibility::is_own(std::uint32_t face, const LinePoint& point) const {
    if (point.crossing != nullptr) {
        return face == point.crossing->face0 || face == point.crossing->face1;
    }
    const auto& edges = eye_.model.topology.faces[face].edges;
    return edges[0] == point.edge || edges[1] == point.edge || edges[2] == point.edge;
}

/// Known since the model was built; finding it anew takes two exact predicates that come out 0, the
/// slowest there are.
bool Visibility::is_touched_by(std::uint32_t face, std::uint32_t edge) const {
    if (eye_.model.is_touched[edge] == 0) return false;
    const auto contacts = eye_.model.crossings.contacts_of(edge);
    return std::ranges::any_of(contacts,
                               [&](const Contact& contact) { return contact.face == face; });
}

/// The side of the face's plane on which the point lies, exact for the true point of the edge: if
/// both ends lie on one side so does it, whatever rounding did to its coordinates.
int Visibility::side_of_point(std::uint32_t f, const LinePoint& point) const {
    if (point.crossing != nullptr) return side_of_crossing(f, point);
    const scene::Topology& topology = eye_.model.topology;
    const auto& p = topology.p_world;
    const scene::Edge& edge = topology.edges[point.edge];
    const auto& v = topology.faces[f].vertices;
    if (is_touched_by(f, point.edge)) return 0;
    const auto side = [&](std::uint32_t end) {
        if (end == v[0] || end == v[1] || end == v[2]) return 0;
        return scene::facing(p[v[0]], p[v[1]], p[v[2]], p[end]);
    };
    const int side_a = side(edge.a);
    const int side_b = side(edge.b);
    if (side_a * side_b >= 0) return side_a + side_b > 0 ? 1 : side_a + side_b < 0 ? -1 : 0;
    return scene::facing(p[v[0]], p[v[1]], p[v[2]], point.p_world);
}

/// On which side of the plane through the eye, q and r the point lies where that is too near to
/// tell: the ends of its line decide, as in side_of_point, so that a line right behind a border is
/// behind it as a whole, whatever rounding did to its points. 0 all along a line that runs in the
/// plane, a crossing within the slack.
int Visibility::side_by_ends(const LinePoint& point,
                             double slack_world,
                             const glm::dvec3& q,
                             const glm::dvec3& r) const {
    const scene::Viewpoint& eye = eye_.eye();
    int side_a = 0, side_b = 0;
    if (const Crossing* crossing = point.crossing) {
        const Sight sight(eye, q, r);
        side_a = sight.side(crossing->begin_world, slack_world + crossing->error);
        side_b = sight.side(crossing->end_world, slack_world + crossing->error);
    } else {
        const auto& p = eye_.model.topology.p_world;
        const scene::Edge& edge = eye_.model.topology.edges[point.edge];
        side_a = scene::facing(p[edge.a], q, r, eye);
        side_b = scene::facing(p[edge.b], q, r, eye);
    }
    if (side_a * side_b < 0) return scene::facing(point.p_world, q, r, eye);
    return side_a != 0 ? side_a : side_b;
}

/// Whether the line from the eye through the point meets the closed triangle, a crossing within the
/// slack of it; one seen edge-on is never met.
bool Visibility::pierces(std::uint32_t f, const LinePoint& point, double slack_world) const {
    const auto& p = eye_.model.topology.p_world;
    const auto& v = eye_.model.topology.faces[f].vertices;
    int low = 0, high = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &q = p[v[i]], &r = p[v[(i + 1) % 3]];
        int s = Sight(eye_.eye(), q, r).side(point.p_world, slack_world + point.noise_world);
        if (s == 0) s = side_by_ends(point, slack_world, q, r);
        low = std::min(low, s);
        high = std::max(high, s);
        if (low < 0 && high > 0) return false;
    }
    return low != high;
}

/// How far along the line of sight its plane is met, in units of the way to the point.
double Visibility::depth_of(std::uint32_t f, const LinePoint& point) const {
    const scene::Topology& topology = eye_.model.topology;
    const glm::dvec3& on_plane = topology.p_world[topology.faces[f].vertices[0]];
    const glm::dvec3 normal = topology.area_vector(f);
    const scene::SightLine line = eye_.projection.sight_to(point.p_world);
    return glm::dot(normal, on_plane - line.begin_world) / glm::dot(normal, line.way_world);
}

/// Whether the line of sight meets the face's plane in front of the near plane.
bool Visibility::is_cut_away(std::uint32_t f, const LinePoint& point) const {
    const auto& v = eye_.model.topology.faces[f].vertices;
    const auto is_near = [&](std::uint32_t i) { return eye_.is_before_near(eye_.p_clip[i]); };
    if (!is_near(v[0]) && !is_near(v[1]) && !is_near(v[2])) return false;
    return depth_of(f, point) * point.w < eye_.near;
}

bool Visibility::blocks(std::uint32_t f, const LinePoint& point) const {
    const int side_eye = eye_.facing[f];
    if (side_eye == 0 || is_own(f, point)) return false;
    const int side = side_of_point(f, point) * side_eye;
    if (side > 0 || (side == 0 && point.crossing == nullptr)) return false;
    const double slack = side == 0 ? doubt_of(f, point) : 0;
    if (!pierces(f, point, slack) || is_cut_away(f, point)) return false;
    return side < 0 || covers(f, point);
}

/// Beyond the point, or touching it there as the floor touches a box that stands on it.
bool Visibility::is_behind(std::uint32_t f, const LinePoint& point) const {
    const int side_eye = eye_.facing[f];
    if (side_eye == 0 || is_own(f, point)) return false;
    return side_of_point(f, point) * side_eye >= 0 && pierces(f, point);
}

bool Visibility::is_visible(const LinePoint& point,
                            std::uint32_t& blocker,
                            std::size_t& rays) const {
    if (blocker != kNoFace && blocks(blocker, point)) return false;
    const auto confirm = [&](std::uint32_t face) {
        if (!blocks(face, point)) return false;
        blocker = face;
        return true;
    };
    const double t_near = 0.99 * eye_.near / point.w;
    ++rays;
    const scene::SightLine line = eye_.projection.sight_to(point.p_world);
    if (scene_.any({line, t_near, 1 + kPast}, confirm)) return false;
    rays += 4;
    return !scene_.any_of_four(beside(point), {t_near, 1 + kPast}, confirm);
}

/// The lines of sight to the point's four neighbours on the image.
std::array<scene::SightLine, 4> Visibility::beside(const LinePoint& point) const {
    // Row vector times rotation: view space back to world.
    const double step = kBeside / eye_.projection.px_per_world(point.w);
    const glm::dvec3 right = glm::dvec3(step, 0, 0) * eye_.view_from_world;
    const glm::dvec3 up = glm::dvec3(0, step, 0) * eye_.view_from_world;
    const scene::SightLine line = eye_.projection.sight_to(point.p_world);
    const auto moved = [&](const glm::dvec3& by) -> scene::SightLine {
        if (eye_.eye().is_direction) return {line.begin_world + by, line.way_world};
        return {line.begin_world, line.way_world + by};
    };
    return {moved(right), moved(-right), moved(up), moved(-up)};
}

std::optional<EyeScene::Hit> Visibility::first_behind(const LinePoint& point,
                                                      std::size_t& rays) const {
    ++rays;
    return scene_.first(beyond(point), [&](std::uint32_t face) { return is_behind(face, point); });
}

/// The part of the line of sight on which what lies behind a point is looked for.
EyeRay Visibility::beyond(const LinePoint& point) const {
    return {eye_.projection.sight_to(point.p_world),
            1 - kPast,
            std::numeric_limits<double>::infinity()};
}

/// The nearest face behind that any of five rays is offered, of equally near ones the lowest;
/// kNoFace before the sky.
std::uint32_t Visibility::closely_behind(const LinePoint& point, std::size_t& rays) const {
    std::uint32_t nearest = kNoFace;
    double t_nearest = 0;
    const auto note = [&](std::uint32_t face) {
        if (!is_behind(face, point)) return false;
        const double t = depth_of(face, point);
        const bool is_level = std::abs(t - t_nearest) <= kLevel * t;
        if (nearest == kNoFace || (is_level ? face < nearest : t < t_nearest)) {
            nearest = face;
            t_nearest = t;
        }
        return false;
    };
    EyeRay ray = beyond(point);
    (void)scene_.any(ray, note);
    rays += 5;
    (void)scene_.any_of_four(beside(point), {ray.t_near, ray.t_far}, note);
    return nearest;
}

ContourKind Visibility::kind_behind(const LinePoint& point, Look look, std::size_t& rays) const {
    const auto is_found = [&](std::uint32_t face) { return is_behind(face, point); };
    std::uint32_t found = kNoFace;
    if (look == Look::close) {
        found = closely_behind(point, rays);
    } else if (eye_.model.is_one_object) {
        ++rays;
        return scene_.any(beyond(point), is_found) ? ContourKind::self : ContourKind::sky;
    } else if (const auto hit = first_behind(point, rays)) {
        found = hit->face;
    }
    if (found == kNoFace) return ContourKind::sky;
    const scene::Topology& topology = eye_.model.topology;
    const std::uint32_t own = topology.faces_of(topology.edges[point.edge])[0];
    return topology.faces[found].object == topology.faces[own].object ? ContourKind::self
                                                                      : ContourKind::other_object;
}

}  // namespace ink::truth
