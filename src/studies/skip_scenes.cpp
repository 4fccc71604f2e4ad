#include "studies/skip_axes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "catalogue/catalogue_stage.h"
#include "catalogue/shapes.h"

namespace ink::studies {
namespace {

using catalogue::EyeShot;
using catalogue::Pose;
using catalogue::Stage;
using raster::Skip;

/// The stage's scene under the name of its camera.
Case case_of(Stage& stage) {
    scene::Scene made = stage.finish({});
    assert(made.cameras.size() == 1);
    made.name = made.cameras.front().name;
    return {"skips_off", 0, {std::move(made), {}}};
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

/// A ball of facets; the codes give the normal no weight.
Case no_normals(int levels) {
    Stage stage;
    stage.add("ball", wavy_ball(levels - 1));
    stage.view(EyeShot{"no_normals", {0, 0, 4}, {0, 0, 0}, 40});
    Case made = case_of(stage);
    // A normal per facet: three vertices a triangle, so that their work shows.
    made.settings = {"range_nx=0", "range_ny=0", "range_nz=0", "range_normal=0", "normals=facet"};
    return made;
}

/// A field of 256 balls, of which a few are in view.
Case corner_of_a_field(int levels) {
    Stage stage;
    const auto ball = stage.mesh("ball", catalogue::make_icosphere(1, std::max(1, levels - 6)));
    constexpr int kSide = 16;
    for (int i = 0; i < kSide * kSide; ++i) {
        stage.place(ball, "ball", Pose{{2.5 * (i % kSide), 0, 2.5 * (i / kSide)}});
    }
    // Beside the first row, looking along it and out of the field.
    stage.view(EyeShot{"corner_of_a_field", {9, 3, 7}, {0, 0, -1}, 30});
    return case_of(stage);
}

/// A dense closed ball; half of it looks away.
Case dense_ball(int levels) {
    Stage stage;
    stage.add("ball", catalogue::make_icosphere(1, levels - 2));
    stage.view(EyeShot{"dense_ball", {0, 0, 3}, {0, 0, 0}, 42});
    return case_of(stage);
}

/// A ball of a million triangles, most of them far below a pixel.
Case dust(int levels) {
    Stage stage;
    stage.add("ball", catalogue::make_icosphere(1, levels));
    stage.view(EyeShot{"dust", {0, 0, 3.5}, {0, 0, 0}, 42});
    return case_of(stage);
}

/// A dense ball behind a wall that is drawn first.
Case behind_a_wall(int levels) {
    Stage stage;
    // The wall comes first, so that all behind it may be left out.
    stage.add("wall", catalogue::make_sheet({-2, -1.5, 1.5}, {4, 0, 0}, {0, 3, 0}));
    stage.add("ball", catalogue::make_icosphere(1, levels - 2));
    stage.view(EyeShot{"behind_a_wall", {0, 0, 6}, {0, 0, 0}, 42});
    return case_of(stage);
}

/// One small object before the sky.
Case far_teapot(int /*levels*/) {
    Stage stage;
    const catalogue::Teapot pot = catalogue::make_teapot(8);
    stage.add("body", pot.body);
    stage.add("lid", pot.lid);
    stage.add("handle", pot.handle);
    stage.add("spout", pot.spout);
    stage.view(EyeShot{"far_teapot", {20, 14, 40}, {0, 1.5, 0}, 40});
    return case_of(stage);
}

/// A wall that fills the frame.
Case wall(int /*levels*/) {
    Stage stage;
    stage.add("wall", catalogue::make_sheet({-40, -40, 0}, {80, 0, 0}, {0, 80, 0}));
    stage.view(EyeShot{"wall", {3, 2, 6}, {1, 0.5, 0}, 40});
    return case_of(stage);
}

/// Nine rings, one of which turns, before a fixed camera.
Case one_of_nine_turns(int levels) {
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
    Case made = case_of(stage);
    for (int frame = 0; frame < 4; ++frame)
        made.poses.push_back(catalogue::placed({{0, 0, 0}, {70 + 4.0 * frame, 0, 0}}));
    return made;
}

/// One object from some place.
SkipScene view_of_ball(const EyeShot& shot) {
    return {std::nullopt, [shot](int levels) {
                Stage stage;
                stage.add("ball", wavy_ball(levels - 2));
                stage.view(shot);
                return case_of(stage);
            }};
}

}  // namespace

const std::vector<SkipScene>& skip_scenes() {
    static const std::vector<SkipScene> kScenes = {
        {Skip::attributes, no_normals},
        {Skip::frustum_culling, corner_of_a_field},
        {Skip::back_face_culling, dense_ball},
        {Skip::no_sample, dust},
        {Skip::occlusion_culling, behind_a_wall},
        {Skip::empty_tiles, far_teapot},
        {Skip::flat_tiles, wall},
        {Skip::temporal_reuse, one_of_nine_turns},
        view_of_ball({"view_empty", {0, 0, 3}, {0, 0, 6}, 40}),   // all behind the camera
        view_of_ball({"view_small", {0, 0, 40}, {2, 1, 0}, 40}),  // one small object
        view_of_ball({"view_full", {0, 0, 1.5}, {0, 0, 0}, 50}),  // it fills the frame
    };
    return kScenes;
}

}  // namespace ink::studies
