#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "scene/box.h"
#include "scene/clusters.h"
#include "scene/predicates.h"

namespace ink::scene {
namespace {

constexpr double kOutwards = 1 + 1e-12;  ///< on a radius, so that rounding leaves nothing outside

/// A face's unit normal as double has it, and how far it may be from the true one.
struct Normal {
    glm::dvec3 unit{0};
    double error = 2;  ///< length of the difference; 2 if any direction is possible
};

double sum_of_sizes(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// From the cross product of two edges and the product of their sizes.
Normal unit_normal(const glm::dvec3& n, double size) {
    const double length = glm::length(n);
    // Differences and products each lose half a unit in the last place of at most `size`; numbers
    // below 1e-140 may lose more when they are squared.
    const double lost = 16 * std::numeric_limits<double>::epsilon() * size;
    if (!(length > 1e-140) || !(length > 4 * lost) || !std::isfinite(length)) return {};
    return {n / length, 4 * lost / length};
}

/// A cluster's vertices and triangles, where they are now.
struct Patch {
    std::array<glm::dvec3, kMaxClusterVertices> p_world;
    std::span<const std::array<std::uint8_t, 3>> triangles;
    std::array<Normal, kMaxClusterTriangles> normals;
};

/// Moves the mean of the normals towards the one farthest from it, by ever smaller steps (Badoiu
/// and Clarkson 2003, "Smaller core-sets for balls"): the mean lies where most faces look, and a
/// cone must hold the last one too. Bunny from outside: 32 % of its triangles turned away with the
/// mean, 35 % with 8 steps, 36 % with 64.
void aim_cone(const Patch& patch, Cluster& cluster) {
    constexpr int kSteps = 8;
    const std::span normals(patch.normals.data(), patch.triangles.size());
    glm::dvec3 axis{0};
    for (const Normal& n : normals)
        axis += n.unit;
    axis = unit_or_zero(axis);
    double cosine = -2;
    for (int step = 1; step <= kSteps; ++step) {
        double lowest = 2;
        const Normal* farthest = nullptr;
        for (const Normal& n : normals) {
            const double reach = glm::dot(n.unit, axis) - n.error;
            if (reach >= lowest) continue;
            lowest = reach;
            farthest = &n;
        }
        if (lowest > cosine) {
            cosine = lowest;
            cluster.cone_axis = axis;
        }
        axis = unit_or_zero(axis + (farthest->unit - axis) / double(step + 1));
    }
    cosine -= 1e-12;  // what the axis and the dot product lose, a thousandfold
    // `is_turned_away` takes the cosine back from the sine, so a half-space is no cone.
    cluster.cone_sine = cosine > 1e-4 ? std::sqrt(1 - cosine * cosine) : 1;
}

void bound(const Patch& patch, Cluster& cluster) {
    const std::span points(patch.p_world.data(), cluster.vertex_count);
    const glm::dvec3 center = box_of(points).center();
    double square = 0;
    for (const glm::dvec3& p : points)
        square = std::max(square, glm::dot(p - center, p - center));
    cluster.bounds = {center, std::sqrt(square) * kOutwards};
    cluster.center_height = -cluster.bounds.radius;
    for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
        const Normal& n = patch.normals[i];
        const double height = glm::dot(n.unit, center - patch.p_world[patch.triangles[i][0]]) +
                              (n.error + 1e-12) * cluster.bounds.radius;
        cluster.center_height = std::max(cluster.center_height, height);
    }
}

/// What the clusters of a solid add up to.
struct Sums {
    const glm::dvec3* origin = nullptr;  ///< one of its corners
    Box box;
    double volume = 0;     ///< times six
    double size = 0;       ///< of the products in it, which bounds what rounding takes
    bool is_whole = true;  ///< no face lost its area, no place came apart
};

/// Takes the cluster's vertices from the surface; false if a place came apart.
bool place(const Surface& surface, const Clusters& clusters, const Cluster& cluster, Patch& patch) {
    bool is_whole = true;
    for (std::uint32_t v = 0; v < cluster.vertex_count; ++v) {
        const std::uint32_t k = cluster.first_vertex + v;
        patch.p_world[v] = surface.p_world[clusters.vertices[k]];
        is_whole &= patch.p_world[v] == surface.p_world[clusters.places[k]];
    }
    patch.triangles = {clusters.triangles.data() + cluster.first_triangle, cluster.triangle_count};
    return is_whole;
}

/// The normals of the patch, and what its faces add to the solid.
void measure_faces(Patch& patch, Sums& sums) {
    for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
        const auto& [ia, ib, ic] = patch.triangles[i];
        const glm::dvec3 &a = patch.p_world[ia], &b = patch.p_world[ib], &c = patch.p_world[ic];
        const glm::dvec3 n = glm::cross(b - a, c - a);
        const double size = sum_of_sizes(b - a) * sum_of_sizes(c - a);
        patch.normals[i] = unit_normal(n, size);
        sums.volume += glm::dot(a - *sums.origin, n);
        sums.size += sum_of_sizes(a - *sums.origin) * size;
        if (patch.normals[i].error >= 2 && is_collinear(a, b, c)) sums.is_whole = false;
    }
}

bool has_area(const Surface& surface, std::uint32_t triangle) {
    const auto& [a, b, c] = surface.triangles[triangle];
    return !is_collinear(surface.p_world[a], surface.p_world[b], surface.p_world[c]);
}

}  // namespace

void refresh(const Surface& moved, Clusters& clusters) {
    for (const std::uint32_t triangle : clusters.left_out) {
        if (!has_area(moved, triangle)) continue;
        clusters = make_clusters(moved);
        return;
    }
    std::vector<Sums> sums(clusters.solids.size());
    Patch patch;
    for (Cluster& cluster : clusters.clusters) {
        Sums& of_solid = sums[cluster.solid];
        if (!of_solid.origin) {
            of_solid.origin = &moved.p_world[clusters.vertices[cluster.first_vertex]];
        }
        of_solid.is_whole &= place(moved, clusters, cluster, patch);
        measure_faces(patch, of_solid);
        bound(patch, cluster);
        aim_cone(patch, cluster);
        for (std::uint32_t v = 0; v < cluster.vertex_count; ++v)
            of_solid.box.add(patch.p_world[v]);
    }
    for (std::size_t s = 0; s < sums.size(); ++s) {
        Solid& solid = clusters.solids[s];
        solid.bounds = {sums[s].box.center(), 0};
        // A million terms that each lose 1e-16 stay below; a sheet with two sides does not pass.
        solid.is_watertight =
            solid.is_closed && sums[s].is_whole && sums[s].volume > 1e-10 * sums[s].size;
        solid.is_watertight_covered =
            solid.hole_count > 0 && sums[s].is_whole &&
            refresh_holes(
                moved, static_cast<std::uint32_t>(s), {*sums[s].origin, sums[s].volume}, clusters);
    }
    for (const Cluster& cluster : clusters.clusters) {
        Sphere& ball = clusters.solids[cluster.solid].bounds;
        for (std::uint32_t v = 0; v < cluster.vertex_count; ++v) {
            const std::uint32_t corner = clusters.vertices[cluster.first_vertex + v];
            const glm::dvec3 arm = moved.p_world[corner] - ball.center_world;
            ball.radius = std::max(ball.radius, glm::dot(arm, arm));  // squared, for now
        }
    }
    for (Solid& solid : clusters.solids)
        solid.bounds.radius = std::sqrt(solid.bounds.radius) * kOutwards;
}

bool is_turned_away(const Cluster& cluster, const Viewpoint& eye) {
    if (cluster.cone_sine >= 1) return false;
    // The eye e sees the back of a face with normal n through p if n . (p - e) > 0. With c the
    // centre, v = c - e, h >= n . (c - p), t the angle from the axis to v and s that of the cone:
    //   n . (p - e) = n . v - n . (c - p) >= |v| cos(t + s) - h         (t + s < pi; cos falls
    //   there)
    //               = axis . v cos s - |v - axis (axis . v)| sin s - h.
    // The usual axis . v >= |v| sin s + r is the same with cos(t + s) >= cos t - sin s and h <= r.
    // It holds for each plane as a whole, wherever in the image: the perspective is in v.
    // Infinitely far away, h is nothing beside |v|.
    const glm::dvec3 v = eye.sight(cluster.bounds.center_world);
    const double along = glm::dot(v, cluster.cone_axis);
    if (!(along > 0)) return false;
    const double distance = glm::length(v);
    const double beside = glm::length(v - cluster.cone_axis * along);
    const double cosine = std::sqrt(1 - cluster.cone_sine * cluster.cone_sine);
    const double slack = 1e-9 * (distance + (eye.is_direction ? 0 : cluster.bounds.radius));
    const double height = eye.is_direction ? 0 : cluster.center_height;
    return along * cosine - beside * cluster.cone_sine > height + slack;
}

}  // namespace ink::scene
