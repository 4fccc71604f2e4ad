// What methods draw through gives the same ids on every SIMD target, whatever is skipped; it covers
// what the plain pass covers, but beside edges of triangles that are cut; and ids are Embree's, but
// for what the tests of both explain.

#include "raster/mesh/mesh_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <span>

#include "core/simd.h"
#include "raster/pass/clip.h"
#include "raster/pass/view_transform.h"
#include "tests/fuzz/fuzz.h"
#include "tests/inspect/compare_ids.h"
#include "tests/raster/gather_sink.h"

namespace ink::fuzz {
namespace {

using Ids = raster::GatherSink<std::uint32_t>;

constexpr int kMostVertices = 14;
constexpr int kMostTriangles = 24;

/// A coordinate: on a coarse grid, so that points, edges and planes coincide, or anywhere.
float coordinate(Feed& feed) {
    if (feed.whole(0, 3) > 0) return static_cast<float>(feed.whole(-8, 8)) / 4;
    return static_cast<float>(feed.real(-3, 3));
}

glm::vec3 place(Feed& feed) {
    const float x = coordinate(feed);
    const float y = coordinate(feed);
    return {x, y, coordinate(feed)};
}

scene::Scene some_scene(Feed& feed) {
    scene::Mesh mesh;
    const int vertices = feed.whole(3, kMostVertices);
    for (int i = 0; i < vertices; ++i)
        mesh.positions.push_back(place(feed));
    const int triangles = feed.whole(1, kMostTriangles);
    for (int i = 0; i < triangles; ++i) {
        scene::Triangle triangle{};
        for (std::uint32_t& corner : triangle)
            corner = static_cast<std::uint32_t>(feed.whole(0, vertices - 1));
        mesh.triangles.push_back(triangle);
    }
    scene::Scene scene;
    scene.name = "fuzz";
    scene.meshes.push_back(std::move(mesh));
    glm::dmat4 world_from_object(1);
    if (feed.flag()) world_from_object[0][1] = feed.real(-1, 1);  // lanes of double
    scene.instances.push_back({0, world_from_object, "all"});
    return scene;
}

scene::View some_view(const scene::Scene& scene, Feed& feed) {
    scene::View view;
    const glm::dvec3 eye(place(feed));
    const glm::dvec3 target(place(feed));
    view.camera = scene::look_at(eye, target, {0, 1, 0}, feed.real(0.05, 2.8));
    scene::fit_clip_range(view.camera, scene::bounding_sphere(scene));
    if (feed.flag()) view.camera.near = feed.real(0.01, 2);
    view.camera.far = std::max(view.camera.far, 2 * view.camera.near);
    view.width_px = feed.whole(1, 140);
    view.height_px = feed.whole(1, 70);
    return view;
}

/// A scene laid out for a pass, each triangle's constant its index.
struct Stage {
    scene::Surface surface;
    raster::LaneMesh mesh;
    std::vector<std::uint32_t> ids;
    scene::View view;
    scene::Sphere bounds;

    Stage(const scene::Scene& scene, const scene::View& from)
        : surface(scene::flatten(scene)),
          mesh(surface),
          ids(surface.triangles.size()),
          view(from),
          bounds(scene::bounding_sphere(scene)) {
        std::iota(ids.begin(), ids.end(), 0U);
    }
    Stage(const Stage&) = delete;  // the mesh borrows the surface
    Stage& operator=(const Stage&) = delete;
};

Ids draw_in_clusters(const Stage& stage, const raster::SkipSet& skips) {
    raster::MeshInput input;
    input.mesh = &stage.mesh;
    input.constants = stage.ids;
    input.view = stage.view;
    input.bounds = stage.bounds;
    input.skips = skips;
    input.sky_code = {raster::kNobody};
    Ids sink(raster::id_format(), stage.view.width_px, stage.view.height_px);
    raster::MeshPass pass;
    (void)pass.draw(raster::id_format(), input, sink);
    return sink;
}

/// The triangles that clusters keep, by index in the surface. One without area may come to cover a
/// pixel where the near plane cuts its edges and the cuts are rounded each by itself.
std::vector<std::uint32_t> with_area(const Stage& stage) {
    const std::vector<std::uint32_t>& left_out = stage.mesh.clusters().left_out;
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t t : stage.ids) {
        if (std::find(left_out.begin(), left_out.end(), t) == left_out.end()) kept.push_back(t);
    }
    return kept;
}

Ids draw_plainly(const Stage& stage, std::span<const std::uint32_t> kept) {
    const raster::ViewTransform transform(stage.view);
    std::vector<glm::dvec3> p_clip;
    for (const glm::dvec3& p : stage.surface.p_world)
        p_clip.push_back(transform.to_clip(p));
    std::vector<scene::Triangle> triangles;
    for (const std::uint32_t t : kept)
        triangles.push_back(stage.surface.triangles[t]);
    raster::PassInput input;
    input.p_clip = p_clip;
    input.triangles = triangles;
    input.near = stage.view.camera.near;
    input.far = stage.view.camera.far;
    return raster::draw_ids(input, stage.view.width_px, stage.view.height_px);
}

bool is_same(const Ids& a, const Ids& b) {
    return a.planes[0] == b.planes[0] && a.depth == b.depth;
}

/// Whether the two passes may differ beside this triangle's edges: they cut what is near or far out
/// at other places, and round the cuts.
bool is_cut_beside(const Stage& stage, std::uint32_t triangle, const glm::dvec2& p_px) {
    const raster::ViewTransform transform(stage.view);
    const double near = stage.view.camera.near;
    std::array<glm::dvec3, 3> p_clip;
    bool is_cut = false;
    for (std::size_t i = 0; i < 3; ++i) {
        p_clip[i] = transform.to_clip(stage.surface.p_world[stage.surface.triangles[triangle][i]]);
        is_cut = is_cut || raster::needs_cut(p_clip[i], near);
    }
    return is_cut && raster::is_near_edge(p_clip, near, p_px);
}

void check_passes(const Stage& stage) {
    const Ids best = draw_in_clusters(stage, {});
    expect(is_same(draw_in_clusters(stage, raster::SkipSet::none()), best),
           "skips change no pixel");
    for (const core::SimdTarget& target : core::simd_targets()) {
        const core::ForcedSimdTarget forced(target);
        expect(is_same(draw_in_clusters(stage, {}), best), "every SIMD target gives the same bits");
    }
    const std::vector<std::uint32_t> kept = with_area(stage);
    const Ids plain = draw_plainly(stage, kept);
    for (int y = 0; y < stage.view.height_px; ++y) {
        for (int x = 0; x < stage.view.width_px; ++x) {
            const std::uint32_t id = best.planes[0].at(x, y);
            const float q = best.depth.at(x, y);
            expect(std::isfinite(q) && (q > 0) == (id != raster::kNobody),
                   "covered pixels have a depth");
            if ((q > 0) == (plain.depth.at(x, y) > 0)) continue;
            const std::uint32_t by = q > 0 ? id : kept[plain.planes[0].at(x, y)];
            expect(is_cut_beside(stage, by, {x + 0.5, y + 0.5}),
                   "clusters cover what the plain pass covers, but beside edges of cut triangles");
        }
    }
}

double distance_to_segment(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 ab = b - a;
    const double length2 = glm::dot(ab, ab);
    const double share = length2 > 0 ? std::clamp(-glm::dot(a, ab) / length2, 0.0, 1.0) : 0;
    return glm::length(a + share * ab);
}

/// Whether floats tell where Embree's rays meet a triangle. They do not if the eye sees it edge-on
/// or nearly so: then it is open whether they meet it, and how far away. Nor if the eye is so near
/// to one of its edges, beside its farthest corner, that rounding moves this by part of a pixel.
bool is_sure(const scene::Surface& surface, std::size_t t, const scene::View& view) {
    constexpr double kEdgeOn = 1e-4;
    constexpr double kMove_px = 1.0 / 512;
    glm::dvec3 p_eye[3];
    double farthest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        p_eye[i] = surface.p_world[surface.triangles[t][i]] - view.camera.eye_world;
        farthest = std::max(farthest, glm::length(p_eye[i]));
    }
    const glm::dvec3 normal = glm::cross(p_eye[1] - p_eye[0], p_eye[2] - p_eye[0]);
    if (std::abs(glm::dot(normal, p_eye[0])) <= kEdgeOn * glm::length(normal) * farthest)
        return false;
    const double nearest = std::min({distance_to_segment(p_eye[0], p_eye[1]),
                                     distance_to_segment(p_eye[1], p_eye[2]),
                                     distance_to_segment(p_eye[2], p_eye[0])});
    const double focal_px = view.height_px / (2 * std::tan(view.camera.fov_y_rad / 2));
    const double move_rad = 2 * std::numeric_limits<float>::epsilon() * farthest / nearest;
    return focal_px * move_rad < kMove_px;
}

/// The scene without the triangles of which floats cannot be sure.
scene::Scene with_sure_ones(scene::Scene scene, const scene::View& view) {
    const scene::Surface surface = scene::flatten(scene);
    std::vector<scene::Triangle>& triangles = scene.meshes.front().triangles;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        if (is_sure(surface, t, view)) triangles[kept++] = triangles[t];
    }
    triangles.resize(kept);
    return scene;
}

}  // namespace

void check_mesh_pass(Bytes bytes) {
    Feed feed(bytes);
    const scene::Scene scene = some_scene(feed);
    const auto seen_from = unless_refused([&] { return some_view(scene, feed); });
    if (!seen_from) return;  // an eye that looks nowhere
    const scene::View& view = *seen_from;
    check_passes(Stage(scene, view));
    const scene::Scene seen = with_sure_ones(scene, view);
    const raster::IdAgreement ids = raster::compare_ids(seen, view, raster::DepthFormat::q32);
    expect(ids.other == 0, "ids are Embree's, but near edges and where floats tell no depth apart");
}

}  // namespace ink::fuzz
