#include "studies/skip_scenes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "catalogue/catalogue_stage.h"
#include "catalogue/shapes.h"

namespace ink::studies {
namespace {

using catalogue::EyeShot;
using catalogue::Pose;
using catalogue::Stage;
using raster::Skip;

/// The stage's scene under the name of its camera.
scene::Scene finished(Stage& stage) {
    scene::Scene made = stage.finish();
    assert(made.cameras.size() == 1);
    made.name = made.cameras.front().name;
    return made;
}

SkipScene scene_for(Skip skip, std::string summary, Stage& stage) {
    scene::Scene made = finished(stage);
    return {made.name, std::move(summary), skip, std::move(made)};
}

/// A ball with waves on it: lines before itself wherever it is seen.
scene::Mesh wavy_ball(int levels) {
    scene::Mesh mesh = catalogue::make_icosphere(1, levels);
    for (glm::vec3& p : mesh.positions) {
        const glm::dvec3 q = p;
        const double wave = std::sin(7 * q.x) * std::sin(7 * q.y) * std::sin(7 * q.z);
        p = catalogue::snapped(q * (1 + 0.1 * wave));
    }
    return mesh;
}

SkipScene no_normals(int levels) {
    Stage stage;
    stage.add("ball", wavy_ball(levels - 1));
    stage.view(EyeShot{"no_normals", {0, 0, 4}, {0, 0, 0}, 40});
    SkipScene made = scene_for(
        Skip::attributes, "A ball of facets; the codes give the normal no weight.", stage);
    // A normal per facet: three vertices a triangle, so that their work shows.
    made.settings = {{"range_nx", "0"},
                     {"range_ny", "0"},
                     {"range_nz", "0"},
                     {"range_normal", "0"},
                     {"normals", "facet"}};
    return made;
}

SkipScene corner_of_a_field(int levels) {
    Stage stage;
    const auto ball = stage.mesh("ball", catalogue::make_icosphere(1, std::max(1, levels - 6)));
    constexpr int kSide = 16;
    for (int i = 0; i < kSide * kSide; ++i) {
        stage.place(ball, "ball", Pose{{2.5 * (i % kSide), 0, 2.5 * (i / kSide)}});
    }
    // Beside the first row, looking along it and out of the field.
    stage.view(EyeShot{"corner_of_a_field", {9, 3, 7}, {0, 0, -1}, 30});
    return scene_for(
        Skip::frustum_culling, "A field of 256 balls, of which a few are in view.", stage);
}

SkipScene dense_ball(int levels) {
    Stage stage;
    stage.add("ball", catalogue::make_icosphere(1, levels - 2));
    stage.view(EyeShot{"dense_ball", {0, 0, 3}, {0, 0, 0}, 42});
    return scene_for(Skip::back_face_culling, "A dense closed ball; half of it looks away.", stage);
}

SkipScene dust(int levels) {
    Stage stage;
    stage.add("ball", catalogue::make_icosphere(1, levels));
    stage.view(EyeShot{"dust", {0, 0, 3.5}, {0, 0, 0}, 42});
    return scene_for(
        Skip::no_sample, "A ball of a million triangles, most of them far below a pixel.", stage);
}

SkipScene behind_a_wall(int levels) {
    Stage stage;
    // The wall comes first, so that all behind it may be left out.
    stage.add("wall", catalogue::make_sheet({-2, -1.5, 1.5}, {4, 0, 0}, {0, 3, 0}));
    stage.add("ball", catalogue::make_icosphere(1, levels - 2));
    stage.view(EyeShot{"behind_a_wall", {0, 0, 6}, {0, 0, 0}, 42});
    return scene_for(
        Skip::occlusion_culling, "A dense ball behind a wall that is drawn first.", stage);
}

SkipScene far_teapot() {
    Stage stage;
    const catalogue::Teapot pot = catalogue::make_teapot(8);
    stage.add("body", pot.body);
    stage.add("lid", pot.lid);
    stage.add("handle", pot.handle);
    stage.add("spout", pot.spout);
    stage.view(EyeShot{"far_teapot", {20, 14, 40}, {0, 1.5, 0}, 40});
    return scene_for(Skip::empty_tiles, "One small object before the sky.", stage);
}

SkipScene wall() {
    Stage stage;
    stage.add("wall", catalogue::make_sheet({-40, -40, 0}, {80, 0, 0}, {0, 80, 0}));
    stage.view(EyeShot{"wall", {3, 2, 6}, {1, 0.5, 0}, 40});
    return scene_for(Skip::flat_tiles, "A wall that fills the frame.", stage);
}

SkipScene one_of_nine_turns(int levels) {
    Stage stage;
    const int across = 4 << std::min(levels - 2, 3);
    const auto ring = stage.mesh("ring", catalogue::make_torus({1, 0.4}, {2 * across, across}));
    for (int i = 0; i < 9; ++i) {
        // The middle one is the first instance: the one that turns.
        const int place = i == 0 ? 4 : (i <= 4 ? i - 1 : i);
        stage.place(
            ring, "ring", Pose{{4.0 * (place % 3 - 1), 3.0 * (place / 3 - 1), 0}, {70, 0, 0}});
    }
    stage.view(EyeShot{"one_of_nine_turns", {0, 0, 14}, {0, 0, 0}, 42});
    SkipScene made = scene_for(
        Skip::temporal_reuse, "Nine rings, one of which turns, before a fixed camera.", stage);
    for (int frame = 0; frame < 4; ++frame)
        made.poses.push_back(catalogue::placed({{0, 0, 0}, {70 + 4.0 * frame, 0, 0}}));
    return made;
}

SkipScene view_of_ball(int levels, const EyeShot& evaluation, std::string summary) {
    Stage stage;
    stage.add("ball", wavy_ball(levels - 2));
    stage.view(evaluation);
    scene::Scene made = finished(stage);
    return {evaluation.name, std::move(summary), std::nullopt, std::move(made)};
}

}  // namespace

SkipScene skip_scene(raster::Skip skip, int levels) {
    assert(levels >= 2 && levels <= 9);
    switch (skip) {
        case Skip::attributes:
            return no_normals(levels);
        case Skip::frustum_culling:
            return corner_of_a_field(levels);
        case Skip::back_face_culling:
            return dense_ball(levels);
        case Skip::no_sample:
            return dust(levels);
        case Skip::occlusion_culling:
            return behind_a_wall(levels);
        case Skip::empty_tiles:
            return far_teapot();
        case Skip::flat_tiles:
            return wall();
        case Skip::temporal_reuse:
            return one_of_nine_turns(levels);
    }
    assert(false);
    return {};
}

std::vector<SkipScene> skip_views(int levels) {
    return {
        view_of_ball(levels, {"view_empty", {0, 0, 3}, {0, 0, 6}, 40}, "All behind the camera."),
        view_of_ball(levels, {"view_small", {0, 0, 40}, {2, 1, 0}, 40}, "One small object."),
        view_of_ball(levels, {"view_full", {0, 0, 1.5}, {0, 0, 0}, 50}, "It fills the frame."),
    };
}

}  // namespace ink::studies
