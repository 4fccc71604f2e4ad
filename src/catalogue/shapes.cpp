#include "catalogue/shapes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <utility>

#include "core/numbering.h"

namespace ink::catalogue {
namespace {

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
