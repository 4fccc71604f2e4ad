#include "truth/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/predicates.h"
#include "tests/truth/shapes.h"

namespace ink::truth {
namespace {

glm::vec3 random_point(Noise& noise, double size) {
    const auto next = [&] { return static_cast<float>(size * (2 * noise.next() - 1)); };
    const float x = next(), y = next();
    return {x, y, next()};
}

/// Triangles of all sizes, thrown together; some share vertices and edges.
scene::Mesh soup(std::uint64_t seed) {
    Noise noise(seed);
    scene::Mesh mesh;
    for (int i = 0; i < 80; ++i) {
        const glm::vec3 a = random_point(noise, 2);
        const double size = 0.1 + noise.next();
        const glm::vec3 b = a + random_point(noise, size), c = a + random_point(noise, size);
        add_triangle(mesh, a, b, c);
        if (i % 2 == 0) add_triangle(mesh, c, b, a + random_point(noise, size));
    }
    return mesh;
}

/// The rule word for word, by trying every triangle: does one that is not the edge's own cross the
/// open segment from the eye to the point?
bool is_hidden_by_any(const EyeView& eye, std::uint32_t edge_index, const glm::dvec3& point) {
    const scene::Topology& topology = eye.model.topology;
    const auto& p = topology.p_world;
    const glm::dvec3 origin = eye.eye().at_world;
    return std::any_of(topology.faces.begin(), topology.faces.end(), [&](const scene::Face& face) {
        const auto own = std::find(face.edges.begin(), face.edges.end(), edge_index);
        if (own != face.edges.end()) return false;
        const auto& a = p[face.vertices[0]];
        const auto& b = p[face.vertices[1]];
        const auto& c = p[face.vertices[2]];
        const int at_eye = scene::orient3d(a, b, c, origin);
        const int at_point = scene::orient3d(a, b, c, point);
        if (at_eye * at_point >= 0) return false;
        const int ab = scene::orient3d(origin, point, a, b);
        const int bc = scene::orient3d(origin, point, b, c);
        const int ca = scene::orient3d(origin, point, c, a);
        return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
    });
}

TEST(Visibility, AgreesWithTryingEveryTriangle) {
    std::size_t visible = 0, hidden = 0;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Model model = build_model(scene_of({soup(seed)}), {});
        const scene::View view = view_from({1, 2, 7}, {0, 0, 0});
        const EyeView eye(model, view, 1);
        const EyeScene embree(model.topology, view.camera, 1);
        const Visibility visibility(eye, embree);
        Noise noise(seed + 100);
        for (std::uint32_t e = 0; e < model.topology.edges.size(); ++e) {
            const scene::Edge& edge = model.topology.edges[e];
            std::uint32_t blocker = kNoFace;
            for (int i = 0; i < 12; ++i) {
                const glm::dvec3& a = model.topology.p_world[edge.a];
                const glm::dvec3& b = model.topology.p_world[edge.b];
                const glm::dvec3 point = a + noise.next() * (b - a);
                std::size_t rays = 0;
                const bool is_visible = visibility.is_visible(
                    {e, point, eye.projection.to_clip(point).z}, blocker, rays);
                EXPECT_EQ(is_visible, !is_hidden_by_any(eye, e, point)) << seed << " edge " << e;
                ++(is_visible ? visible : hidden);
            }
        }
    }
    EXPECT_GT(visible, 1000U);
    EXPECT_GT(hidden, 1000U);
}

TEST(Visibility, TriangleInThePlaneOfThePointDoesNotBlock) {
    // A wall above a floor's far half; its foot lies in the floor's plane, inside the floor.
    scene::Mesh mesh;
    add_quad(mesh, {-5, 0, 5}, {5, 0, 5}, {5, 0, -5}, {-5, 0, -5});
    add_quad(mesh, {-1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0});
    const scene::Scene scene = scene_of({mesh});
    const scene::View above = view_from({0, 3, 9}, {0, 0, 0});
    const scene::View below = view_from({0, -3, 9}, {0, 0, 0});
    EXPECT_GT(seen_length(scene, trace(scene, above), {-1, 0, 0}, {1, 0, 0}), 100);
    // From below the floor is seen on both sides of the foot: there is no line.
    EXPECT_EQ(seen_length(scene, trace(scene, below), {-1, 0, 0}, {1, 0, 0}), 0);
    EXPECT_EQ(seen_length(scene, trace(scene, below), {-1, 1, 0}, {1, 1, 0}), 0);
}

TEST(Visibility, WallSeenEdgeOnBlocksNothing) {
    // The eye lies in the plane of a wall that stands between it and a bar.
    scene::Mesh mesh;
    add_quad(mesh, {0, -1, 2}, {0, -1, 1}, {0, 1, 1}, {0, 1, 2});
    add_quad(mesh, {-1, -0.25F, 0}, {1, -0.25F, 0}, {1, 0.25F, 0}, {-1, 0.25F, 0});
    const scene::Scene scene = scene_of({mesh});
    const Truth truth = trace(scene, view_from(6));
    EXPECT_NEAR(seen_length(scene, truth, {-1, 0.25, 0}, {1, 0.25, 0}), 200, 0.01);
    EXPECT_EQ(lengths(truth).size(), 1U);
}

}  // namespace
}  // namespace ink::truth
