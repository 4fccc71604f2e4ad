#include "harness/cells/frame_counts.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace ink::harness {
namespace {

/// Half-spaces of clip space (x, y, w): inside is where dot(normal, p) + offset >= 0.
struct Side {
    glm::dvec3 normal;
    double offset = 0;

    [[nodiscard]] double inside(const glm::dvec3& p) const { return glm::dot(normal, p) + offset; }
};
using Sides = std::array<Side, 5>;

/// The near plane and the four sides of the image.
Sides sides_of(const scene::View& view) {
    return {Side{{0, 0, 1}, -view.camera.near},
            Side{{1, 0, 0}},
            Side{{-1, 0, static_cast<double>(view.width_px)}},
            Side{{0, 1, 0}},
            Side{{0, -1, static_cast<double>(view.height_px)}}};
}

/// A convex polygon; five cuts leave a triangle at most eight corners.
struct Polygon {
    std::array<glm::dvec3, 8> corners;
    std::size_t count = 0;

    void add(const glm::dvec3& corner) { corners[count++] = corner; }
};

/// What of `polygon` lies inside (Sutherland and Hodgman 1974).
Polygon cut(const Polygon& polygon, const Side& side) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec3& a = polygon.corners[i];
        const glm::dvec3& b = polygon.corners[(i + 1) % polygon.count];
        const double a_in = side.inside(a);
        const double b_in = side.inside(b);
        if (a_in >= 0) kept.add(a);
        if ((a_in >= 0) != (b_in >= 0)) kept.add(a + (b - a) * (a_in / (a_in - b_in)));
    }
    return kept;
}

double area_px(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec3& a = polygon.corners[i];
        const glm::dvec3& b = polygon.corners[(i + 1) % polygon.count];
        twice += a.x / a.z * (b.y / b.z) - b.x / b.z * (a.y / a.z);
    }
    return std::abs(twice) / 2;
}

double covered_px(Polygon polygon, const Sides& sides) {
    for (const Side& side : sides) {
        polygon = cut(polygon, side);
        if (polygon.count < 3) return 0;
    }
    return area_px(polygon);
}

}  // namespace

FrameCounts count_frame(const scene::Scene& scene, const scene::View& view) {
    FrameCounts counts;
    counts.frame_px = static_cast<double>(view.width_px) * view.height_px;
    const scene::Projection projection(view);
    const Sides sides = sides_of(view);
    std::vector<glm::dvec3> p_clip;
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        p_clip.clear();
        for (const glm::vec3& p : mesh.positions)
            p_clip.push_back(projection.to_clip(scene::to_world(instance, p)));
        counts.vertices += static_cast<double>(p_clip.size());
        counts.triangles += static_cast<double>(mesh.triangles.size());
        for (const scene::Triangle& triangle : mesh.triangles) {
            Polygon polygon;
            for (int i = 0; i < 3; ++i)
                polygon.add(p_clip[triangle[i]]);
            counts.covered_px += covered_px(polygon, sides);
        }
    }
    return counts;
}

}  // namespace ink::harness
