#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <vector>

#include "scene/scene.h"
#include "scene/topology.h"
#include "score/score.h"
#include "tests/scene/small_meshes.h"
#include "truth/truth.h"

namespace ink::truth {

using scene::scene_of;

inline constexpr int kWidth_px = 640;
inline constexpr int kHeight_px = 480;
inline constexpr double kFocal_px = 600;

/// A camera at (0, 0, distance) that looks down -z: x_px = 320 + 600 x / (distance - z).
inline scene::View view_from(double distance, double near = 0.01) {
    scene::View view;
    view.camera.eye_world = {0, 0, distance};
    view.camera.fov_y_rad = 2 * std::atan(kHeight_px / 2.0 / kFocal_px);
    view.camera.near = near;
    view.camera.far = 1000;
    view.width_px = kWidth_px;
    view.height_px = kHeight_px;
    return view;
}

/// A camera anywhere, of the same lens.
inline scene::View view_from(const glm::dvec3& eye, const glm::dvec3& target) {
    scene::View view = view_from(1);
    const double near = view.camera.near;
    view.camera = scene::look_at(eye, target, {0, 1, 0}, view.camera.fov_y_rad);
    view.camera.near = near;
    return view;
}

/// Where view_from(distance) sees a point: the pinhole formula, written down here once more.
inline glm::dvec2 project(const glm::dvec3& p, double distance) {
    const double scale = kFocal_px / (distance - p.z);
    return {kWidth_px / 2.0 + scale * p.x, kHeight_px / 2.0 - scale * p.y};
}

inline double length_px(const Curve& curve) {
    return std::hypot(curve.end.x_px - curve.begin.x_px, curve.end.y_px - curve.begin.y_px);
}

inline void add_triangle(scene::Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
}

/// Counter-clockwise from the front; split along a-c.
inline void add_quad(scene::Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
    add_triangle(mesh, a, b, c);
    add_triangle(mesh, a, c, d);
}

inline scene::Mesh quad(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
    scene::Mesh mesh;
    add_quad(mesh, a, b, c, d);
    return mesh;
}

/// An axis-aligned box of twelve triangles, fronts outside.
inline void add_box(scene::Mesh& mesh, glm::vec3 low, glm::vec3 high) {
    const auto p = [&](int x, int y, int z) {
        return glm::vec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
    };
    add_quad(mesh, p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1));  // front, +z
    add_quad(mesh, p(1, 0, 0), p(0, 0, 0), p(0, 1, 0), p(1, 1, 0));  // back
    add_quad(mesh, p(1, 0, 1), p(1, 0, 0), p(1, 1, 0), p(1, 1, 1));  // right, +x
    add_quad(mesh, p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0));  // left
    add_quad(mesh, p(0, 1, 1), p(1, 1, 1), p(1, 1, 0), p(0, 1, 0));  // top, +y
    add_quad(mesh, p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1));  // bottom
}

/// All triangles in one mesh, three vertices each.
inline scene::Mesh joined(const std::vector<scene::Mesh>& meshes) {
    scene::Mesh all;
    for (const scene::Mesh& mesh : meshes) {
        for (const scene::Triangle& t : mesh.triangles)
            add_triangle(all, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
    }
    return all;
}

inline scene::Mesh box(glm::vec3 low, glm::vec3 high) {
    scene::Mesh mesh;
    add_box(mesh, low, high);
    return mesh;
}

/// A cube of side 2 about the origin, turned by an instance transform.
inline scene::Scene turned_cube(const glm::dmat4& turn) {
    scene::Scene scene = scene_of({box({-1, -1, -1}, {1, 1, 1})});
    scene.instances[0].world_from_object = turn;
    return scene;
}

/// Objects that hide, touch, pierce and abut each other: whatever holds here holds widely.
inline scene::Scene crowd() {
    const scene::Mesh floor = quad({-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4});
    scene::Mesh pyramid;
    const glm::vec3 top{0.2F, 1.7F, 0.1F};
    const std::array<glm::vec3, 4> foot = {glm::vec3(-0.9F, 0.1F, 0.8F),
                                           glm::vec3(1.1F, 0.05F, 0.9F),
                                           glm::vec3(1, 0.15F, -1.1F),
                                           glm::vec3(-1, 0.1F, -0.9F)};
    for (std::size_t i = 0; i < 4; ++i)
        add_triangle(pyramid, foot[i], foot[(i + 1) % 4], top);
    return scene_of({floor,
                     box({-2, 0, -1}, {-1, 1, 1}),
                     box({-1, 0, -1}, {0, 1, 1}),
                     pyramid,
                     box({0.5F, -0.5F, 1}, {1.5F, 0.5F, 2.2F})});
}

inline Truth trace(const scene::Scene& scene, const scene::View& view, int threads = 1) {
    TruthOptions options;
    options.threads = threads;
    return trace_truth(scene, view, options);
}

/// Visible length in px per class.
inline std::map<LineClass, double> lengths(const Truth& truth) {
    std::map<LineClass, double> sum;
    for (const Curve& curve : truth.curves)
        sum[curve.line_class] += length_px(curve);
    return sum;
}

/// Visible length in px per mesh edge, of one class.
inline std::map<std::uint32_t, double> edge_lengths(const Truth& truth, LineClass line_class) {
    std::map<std::uint32_t, double> sum;
    for (const Curve& curve : truth.curves) {
        if (curve.line_class == line_class) sum[curve.edge] += length_px(curve);
    }
    return sum;
}

/// The visible length of the edge between two world points, any class; 0 if it is not seen.
inline double seen_length(const scene::Scene& scene,
                          const Truth& truth,
                          const glm::dvec3& a,
                          const glm::dvec3& b) {
    const scene::Topology topology = scene::weld(scene);
    const auto is_at = [&](std::uint32_t v, const glm::dvec3& p) {
        return glm::length(topology.p_world[v] - p) < 1e-9;
    };
    double sum = 0;
    for (const Curve& curve : truth.curves) {
        if (curve.edge == kNoEdge) continue;
        const scene::Edge& edge = topology.edges[curve.edge];
        if ((is_at(edge.a, a) && is_at(edge.b, b)) || (is_at(edge.a, b) && is_at(edge.b, a))) {
            sum += length_px(curve);
        }
    }
    return sum;
}

/// The length on the image of the straight line between two world points.
inline double length_px(const scene::View& view, const glm::dvec3& a, const glm::dvec3& b) {
    const scene::Projection projection(view);
    const glm::dvec3 p = projection.to_clip(a), q = projection.to_clip(b);
    return std::hypot(p.x / p.z - q.x / q.z, p.y / p.z - q.y / q.z);
}

/// What the `sampled` row scores against the labels, as it is scored in every comparison.
inline double sampled_f(const Truth& truth) {
    const score::ScoreOptions options{.band_px = 6,
                                      .ignore_label = static_cast<int>(LineClass::ignore)};
    const auto scoring = score::prepare_truth(truth.labels, options, true);
    return score::score(truth.sampled, scoring, options).f();
}

template <class T>
std::size_t drawn_px(const core::Image<T>& image) {
    return image.size() -
           static_cast<std::size_t>(std::count(image.data(), image.data() + image.size(), T{0}));
}
inline std::size_t drawn_px(const Truth& truth) {
    return drawn_px(truth.labels);
}

inline bool same_curve(const Curve& a, const Curve& b) {
    return a.line_class == b.line_class && a.kind == b.kind && a.edge == b.edge &&
           a.deviation_rad == b.deviation_rad && a.begin.x_px == b.begin.x_px &&
           a.begin.y_px == b.begin.y_px && a.begin.w == b.begin.w && a.end.x_px == b.end.x_px &&
           a.end.y_px == b.end.y_px && a.end.w == b.end.w;
}

inline bool same_curves(const Truth& a, const Truth& b) {
    return std::equal(
        a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(), same_curve);
}

/// Everything that a method's image is compared with.
inline void expect_same_truth(const Truth& a, const Truth& b) {
    EXPECT_TRUE(same_curves(a, b));
    EXPECT_EQ(a.labels, b.labels);
    EXPECT_EQ(a.below_crease, b.below_crease);
    EXPECT_EQ(a.sampled, b.sampled);
    EXPECT_EQ(a.exact_corner, b.exact_corner);
    EXPECT_EQ(a.layers.triangle, b.layers.triangle);
    EXPECT_EQ(a.layers.patch, b.layers.patch);
    EXPECT_EQ(a.layers.n_dot_v, b.layers.n_dot_v);
    EXPECT_EQ(a.layers.w, b.layers.w);
    EXPECT_EQ(a.counts.rays, b.counts.rays);
    EXPECT_EQ(a.counts.crowded_share, b.counts.crowded_share);
}

/// Deterministic noise in [0, 1) (the usual 64-bit linear congruence, Knuth's constants).
class Noise {
  public:
    explicit Noise(std::uint64_t seed) : state_(seed) {}
    double next() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11) / 9007199254740992.0;
    }

  private:
    std::uint64_t state_;
};

}  // namespace ink::truth
