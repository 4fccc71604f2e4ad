#include "catalogue/shapes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/numbering.h"

namespace ink::catalogue {
namespace {

/// The plane of one ring: `u` x `v` points along the path.
struct Frame {
    glm::dvec3 u;
    glm::dvec3 v;
};

/// `u` with its part along `direction` taken out, and the axis that completes it.
Frame frame_across(const glm::dvec3& direction, const glm::dvec3& u) {
    const glm::dvec3 across = glm::normalize(u - direction * glm::dot(direction, u));
    return {across, glm::cross(direction, across)};
}

Frame first_frame(const glm::dvec3& direction) {
    const bool is_upright = std::abs(direction.y) > 0.9;
    return frame_across(direction, is_upright ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
}

Frame turned(const Frame& frame, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return {frame.u * c + frame.v * s, frame.v * c - frame.u * s};
}

Ring ring_at(const TubeNode& node, const Frame& frame, const Ring& circle) {
    Ring ring;
    for (const auto& p : circle) {
        ring.push_back(node.center + (frame.u * p.x - frame.v * p.z) * node.radius);
    }
    return ring;
}

// Ear clipping (Meisters 1975, "Polygons have ears"): cut off a convex corner that holds no other
// corner, until three are left. Cubic at worst, for outlines of a few dozen points.

using Outline = std::span<const glm::dvec2>;

/// Twice the signed area of (a, b, c): positive where it turns left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_ear(Outline outline,
            const std::vector<std::uint32_t>& left,
            const scene::Triangle& corner) {
    const std::uint32_t a = corner[0], b = corner[1], c = corner[2];
    if (turn(outline[a], outline[b], outline[c]) <= 0) return false;
    return std::none_of(left.begin(), left.end(), [&](std::uint32_t i) {
        if (i == a || i == b || i == c) return false;
        const auto& p = outline[i];
        return turn(outline[a], outline[b], p) >= 0 && turn(outline[b], outline[c], p) >= 0 &&
               turn(outline[c], outline[a], p) >= 0;
    });
}

/// Cuts off the first ear and returns it.
scene::Triangle cut_ear(Outline outline, std::vector<std::uint32_t>& left) {
    const std::size_t count = left.size();
    for (std::size_t i = 0; i < count; ++i) {
        const scene::Triangle corner{left[(i + count - 1) % count], left[i], left[(i + 1) % count]};
        if (!is_ear(outline, left, corner)) continue;
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        return corner;
    }
    assert(!"the outline crosses itself or runs clockwise");
    left.clear();
    return {};
}

constexpr double kTau = 2 * std::numbers::pi;

std::uint32_t add(scene::Mesh& mesh, const glm::dvec3& p) {
    mesh.positions.emplace_back(snapped(p));
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// The indices of one ring, where a pole stands for as many points as asked.
struct RingIndex {
    std::uint32_t first;
    std::size_t size;

    [[nodiscard]] std::uint32_t at(std::size_t j) const {
        return first + static_cast<std::uint32_t>(j % size);
    }
};

void add_band(scene::Mesh& mesh, const RingIndex& low, const RingIndex& high, std::size_t quads) {
    assert(low.size > 1 || high.size > 1);
    for (std::size_t j = 0; j < quads; ++j) {
        if (low.size > 1) mesh.triangles.push_back({low.at(j), low.at(j + 1), high.at(j + 1)});
        if (high.size > 1) mesh.triangles.push_back({low.at(j), high.at(j + 1), high.at(j)});
    }
}

/// The point half way between two on the sphere, made once for both triangles that share the edge.
class Midpoints {
  public:
    Midpoints(std::vector<glm::dvec3>& points, double radius)
        : points_(points),
          first_(static_cast<std::uint32_t>(points.size())),
          radius_(radius),
          known_(3 * points.size()) {}

    std::uint32_t between(std::uint32_t a, std::uint32_t b) {
        const auto [number, is_new] = known_.insert({std::min(a, b), std::max(a, b)});
        if (is_new) points_.push_back(glm::normalize(points_[a] + points_[b]) * radius_);
        return first_ + number;
    }

  private:
    std::vector<glm::dvec3>& points_;
    std::uint32_t first_;
    double radius_;
    core::Numbering<std::array<std::uint32_t, 2>> known_;
};

std::vector<glm::dvec3> icosahedron_points(double radius) {
    const double golden = std::numbers::phi;
    std::vector<glm::dvec3> points;
    for (const double a : {-1.0, 1.0}) {
        for (const double b : {-golden, golden}) {
            points.insert(points.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
        }
    }
    for (auto& p : points)
        p = glm::normalize(p) * radius;
    return points;
}

/// All triples of points that lie one edge apart, turned outwards.
std::vector<scene::Triangle> icosahedron_triangles(const std::vector<glm::dvec3>& points) {
    const double radius = glm::length(points[0]);
    const auto joined = [&](std::uint32_t a, std::uint32_t b) {
        return glm::distance(points[a], points[b]) < 1.2 * radius;  // edges 1.05, diagonals 1.70
    };
    std::vector<scene::Triangle> triangles;
    const auto count = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t a = 0; a < count; ++a) {
        for (std::uint32_t b = a + 1; b < count; ++b) {
            for (std::uint32_t c = b + 1; c < count; ++c) {
                if (!joined(a, b) || !joined(b, c) || !joined(a, c)) continue;
                const double turn = glm::dot(points[a], glm::cross(points[b], points[c]));
                triangles.push_back(turn > 0 ? scene::Triangle{a, b, c} : scene::Triangle{a, c, b});
            }
        }
    }
    return triangles;
}

}  // namespace

std::vector<TubeNode> smoothed(std::span<const TubeNode> path, int cuts) {
    assert(path.size() >= 2);
    const auto node = [&](std::size_t i) {  // the ends are doubled
        return path[std::clamp<std::size_t>(i, 1, path.size()) - 1];
    };
    const auto blend = [](const auto& a, const auto& b, const auto& c, const auto& d, double t) {
        return b + (c - a) * (0.5 * t) + (a * 2.0 - b * 5.0 + c * 4.0 - d) * (0.5 * t * t) +
               ((b - c) * 3.0 + d - a) * (0.5 * t * t * t);
    };
    std::vector<TubeNode> result;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const TubeNode nodes[] = {node(i), node(i + 1), node(i + 2), node(i + 3)};
        for (int k = 0; k < cuts; ++k) {
            const double t = double(k) / cuts;
            const auto& [a, b, c, d] = nodes;
            result.push_back({blend(a.center, b.center, c.center, d.center, t),
                              blend(a.radius, b.radius, c.radius, d.radius, t)});
        }
    }
    result.push_back(path.back());
    return result;
}

scene::Mesh make_tube(std::span<const TubeNode> path, int segments) {
    assert(path.size() >= 2);
    const Ring circle = unit_circle(segments);
    const std::size_t last = path.size() - 1;
    std::vector<Ring> rings{{path[0].center}};
    Frame frame = first_frame(glm::normalize(path[1].center - path[0].center));
    for (std::size_t i = 0; i <= last; ++i) {
        const auto& from = path[i == 0 ? 0 : i - 1].center;
        const auto& to = path[i == last ? last : i + 1].center;
        frame = frame_across(glm::normalize(to - from), frame.u);
        rings.push_back(ring_at(path[i], frame, circle));
    }
    rings.push_back({path[last].center});
    return loft(rings);
}

scene::Mesh make_closed_tube(std::span<const TubeNode> path, int segments) {
    const Ring circle = unit_circle(segments);
    const std::size_t count = path.size();
    const auto direction = [&](std::size_t i) {
        return glm::normalize(path[(i + 1) % count].center - path[(i + count - 1) % count].center);
    };
    std::vector<Frame> frames{first_frame(direction(0))};
    for (std::size_t i = 1; i <= count; ++i) {
        frames.push_back(frame_across(direction(i % count), frames.back().u));
    }
    const glm::dvec3& end = frames[count].u;
    const double twist_rad = std::atan2(glm::dot(end, frames[0].v), glm::dot(end, frames[0].u));
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count);
        rings.push_back(ring_at(path[i], turned(frames[i], -twist_rad * share), circle));
    }
    return loft(rings, {.along = true});
}

scene::Mesh extrude(std::span<const glm::dvec2> outline, glm::dvec2 z) {
    Ring back;
    Ring front;
    for (const auto& p : outline) {
        back.emplace_back(p, z.x);
        front.emplace_back(p, z.y);
    }
    const Ring rings[] = {back, front};
    scene::Mesh mesh = loft(rings);
    const auto count = static_cast<std::uint32_t>(outline.size());
    std::vector<std::uint32_t> left(count);
    std::iota(left.begin(), left.end(), 0U);
    while (left.size() > 2) {
        const auto [a, b, c] = cut_ear(outline, left);
        mesh.triangles.push_back({count + a, count + b, count + c});
        mesh.triangles.push_back({c, b, a});
    }
    return mesh;
}

glm::dvec3 snapped(const glm::dvec3& p) {
    constexpr double kGrid = 1 << 20;
    return glm::round(p * kGrid) / kGrid + 0.0;  // + 0.0 turns -0 into 0
}

void append(scene::Mesh& whole, const scene::Mesh& part) {
    const auto first = static_cast<std::uint32_t>(whole.positions.size());
    whole.positions.insert(whole.positions.end(), part.positions.begin(), part.positions.end());
    for (const auto& [a, b, c] : part.triangles) {
        whole.triangles.push_back({first + a, first + b, first + c});
    }
}

scene::Mesh moved(const scene::Mesh& mesh, const glm::dmat4& world_from_object) {
    scene::Mesh result = mesh;
    result.normals.clear();
    for (auto& p : result.positions) {
        p = snapped(glm::dvec3(world_from_object * glm::dvec4(glm::dvec3(p), 1)));
    }
    if (glm::determinant(glm::dmat3(world_from_object)) < 0) {
        for (auto& triangle : result.triangles)
            std::swap(triangle[1], triangle[2]);
    }
    return result;
}

scene::Mesh loft(std::span<const Ring> rings, LoftEnds ends) {
    scene::Mesh mesh;
    std::vector<RingIndex> indices;
    std::size_t points = 1;
    for (const Ring& ring : rings) {
        assert(ring.size() == 1 || points == 1 || ring.size() == points);
        points = std::max(points, ring.size());
        indices.push_back({static_cast<std::uint32_t>(mesh.positions.size()), ring.size()});
        for (const auto& p : ring)
            add(mesh, p);
    }
    const std::size_t quads = ends.around ? points : points - 1;
    const std::size_t bands = ends.along ? rings.size() : rings.size() - 1;
    for (std::size_t i = 0; i < bands; ++i) {
        add_band(mesh, indices[i], indices[(i + 1) % rings.size()], quads);
    }
    return mesh;
}

Ring unit_circle(int count) {
    Ring circle;
    for (int i = 0; i < count; ++i) {
        const double angle_rad = kTau * i / count;
        circle.emplace_back(std::cos(angle_rad), 0, -std::sin(angle_rad));
    }
    return circle;
}

scene::Mesh make_box(const glm::dvec3& low, const glm::dvec3& high) {
    scene::Mesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        add(mesh,
            {corner & 1 ? high.x : low.x,
             corner & 2 ? high.y : low.y,
             corner & 4 ? high.z : low.z});
    }
    mesh.triangles = {{0, 4, 6},
                      {0, 6, 2},
                      {1, 3, 7},
                      {1, 7, 5},
                      {0, 1, 5},
                      {0, 5, 4},
                      {2, 6, 7},
                      {2, 7, 3},
                      {0, 2, 3},
                      {0, 3, 1},
                      {4, 5, 7},
                      {4, 7, 6}};
    return mesh;
}

scene::Mesh make_sheet(glm::ivec2 count,
                       const std::function<glm::dvec3(double u, double v)>& surface) {
    std::vector<Ring> rows(count.y + 1);
    for (int j = 0; j <= count.y; ++j) {
        for (int i = 0; i <= count.x; ++i) {
            rows[j].push_back(surface(double(i) / count.x, double(j) / count.y));
        }
    }
    return loft(rows, {.around = false});
}

scene::Mesh make_sheet(const glm::dvec3& corner,
                       const glm::dvec3& u,
                       const glm::dvec3& v,
                       glm::ivec2 count) {
    return make_sheet(count, [&](double s, double t) { return corner + u * s + v * t; });
}

scene::Mesh revolve(std::span<const glm::dvec2> profile, int segments) {
    const Ring circle = unit_circle(segments);
    const bool is_loop = profile.size() > 1 && profile.front() == profile.back();
    std::vector<Ring> rings;
    for (const glm::dvec2& p : is_loop ? profile.first(profile.size() - 1) : profile) {
        Ring ring;
        for (const auto& direction : circle)
            ring.push_back(direction * p.x + glm::dvec3(0, p.y, 0));
        if (p.x == 0) ring.resize(1);
        rings.push_back(std::move(ring));
    }
    return loft(rings, {.along = is_loop});
}

scene::Mesh make_sphere(double radius, int segments, int stacks) {
    std::vector<glm::dvec2> profile{{0, -radius}};
    for (int i = 1; i < stacks; ++i) {
        const double angle_rad = kTau / 2 * i / stacks;
        profile.emplace_back(radius * std::sin(angle_rad), -radius * std::cos(angle_rad));
    }
    profile.emplace_back(0, radius);
    return revolve(profile, segments);
}

scene::Mesh make_icosphere(double radius, int levels) {
    std::vector<glm::dvec3> points = icosahedron_points(radius);
    std::vector<scene::Triangle> triangles = icosahedron_triangles(points);
    for (int level = 0; level < levels; ++level) {
        Midpoints midpoints(points, radius);
        std::vector<scene::Triangle> finer;
        for (const auto& [a, b, c] : triangles) {
            const auto ab = midpoints.between(a, b);
            const auto bc = midpoints.between(b, c);
            const auto ca = midpoints.between(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
    }
    scene::Mesh mesh;
    for (const auto& p : points)
        add(mesh, p);
    mesh.triangles = std::move(triangles);
    return mesh;
}

scene::Mesh make_torus(glm::dvec2 radii, glm::ivec2 counts) {
    std::vector<glm::dvec2> profile;
    for (const auto& p : unit_circle(counts.y)) {
        profile.emplace_back(radii.x + radii.y * p.x, -radii.y * p.z);
    }
    profile.push_back(profile.front());
    return revolve(profile, counts.x);
}

scene::Mesh make_cylinder(double radius, double height, int sides) {
    const glm::dvec2 profile[] = {{0, 0}, {radius, 0}, {radius, height}, {0, height}};
    return revolve(profile, sides);
}

scene::Mesh make_cone(double radius, double height, int sides) {
    const glm::dvec2 profile[] = {{0, 0}, {radius, 0}, {0, height}};
    return revolve(profile, sides);
}

}  // namespace ink::catalogue
