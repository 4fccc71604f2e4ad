#include "studies/skip_axes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <span>

#include "harness/skip_switches.h"
#include "methods/registry.h"
#include "studies/axis_rows.h"
#include "tests/harness/skipping_method.h"

namespace ink::studies {
namespace {

using raster::Skip;
using testing::ElementsAre;

constexpr CaseSize kSize{16, 9};

Case case_for(Skip skip, int levels) {
    return skip_scenes()[static_cast<std::size_t>(skip)].make(levels);
}

Axis axis_for(Skip skip) {
    return skip_axes(2)[static_cast<std::size_t>(skip)];
}

/// The cells of an axis' one scene, over two rounds.
std::vector<AxisRow> rows_on(Axis axis,
                             const method::MethodConfig& config,
                             const CaseSize& size = kSize) {
    axis.repetitions = 2;
    harness::CellOptions options;
    options.measure.threads = 2;
    auto rows = axis_rows(axis, axis.cases(axis.values.front(), size).front(), {config}, options);
    note_differences(axis, rows);
    return rows;
}

std::vector<std::string> forbidden_in(const std::vector<method::Frame>& frames) {
    std::vector<std::string> names;
    for (const method::Frame& frame : frames)
        names.push_back(harness::forbidden_skips(frame.skips));
    return names;
}

TEST(SkipScenes, AreOnePerSkipAndThreeViewsWithOneCameraEach) {
    std::set<std::string> names;
    std::set<std::uint64_t> objects;
    const auto& scenes = skip_scenes();
    ASSERT_EQ(scenes.size(), raster::kSkipCount + 3);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Case made = scenes[i].make(3);
        const scene::Scene& scene = made.scene_views.scene;
        EXPECT_EQ(made.poses.empty(), scenes[i].skip != Skip::temporal_reuse) << scene.name;
        names.insert(scene.name);
        EXPECT_NO_THROW(scene::check_scene(scene)) << scene.name;
        ASSERT_EQ(scene.cameras.size(), 1U) << scene.name;
        EXPECT_EQ(scene.cameras[0].name, scene.name);
        if (i < raster::kSkipCount) {
            EXPECT_EQ(scenes[i].skip, raster::skip_infos()[i].skip);
        } else {
            EXPECT_FALSE(scenes[i].skip);
            objects.insert(scene::scene_hash(scene));
        }
    }
    EXPECT_EQ(names.size(), scenes.size());
    EXPECT_EQ(objects.size(), 1U) << "one object from three places";
}

TEST(SkipScenes, TheDensestHasAMillionTriangles) {
    EXPECT_EQ(scene::triangle_count(case_for(Skip::no_sample, 4).scene_views.scene),
              20U << (2 * 4));
    static_assert(20 << (2 * kSkipSceneLevels) > 1'000'000);
}

/// The pixels that hold something.
int drawn_px(const SkipScene& of) {
    const scene::Scene scene = of.make(6).scene_views.scene;
    edge::EdgeImage out(160, 90);
    const auto method = methods::find_method("mote4").make({});
    method->prepare(scene);
    method->pose(scene);
    method->draw({{scene.cameras[0], 160, 90}, 1}, out);
    return static_cast<int>(
        std::count_if(out.data(), out.data() + out.size(), [](auto s) { return s > 0; }));
}

TEST(SkipViews, AreEmptySmallAndFull) {
    const auto views = std::span(skip_scenes()).last(3);
    EXPECT_EQ(drawn_px(views[0]), 0);
    EXPECT_GT(drawn_px(views[1]), 0);
    EXPECT_LT(drawn_px(views[1]), 160 * 90 / 50);
    EXPECT_GT(drawn_px(views[2]), 0);
}

TEST(SkipAxes, DrawAllValuesInTurnsAndCountTheSkipsOfEach) {
    harness::SkipScript script{.counts = harness::made_up_counts()};
    const auto info = harness::skipping_info(script);
    const auto rows = rows_on(axis_for(Skip::occlusion_culling), {&info, {}});
    const std::string all = harness::forbidden_skips(raster::SkipSet::none());
    const std::string on = "temporal_reuse";
    const std::string own_off = "occlusion_culling;temporal_reuse";
    // The first round warms up; another begins each round.
    EXPECT_THAT(forbidden_in(script.frames),
                ElementsAre(on, own_off, all, own_off, all, on, all, on, own_off));
    EXPECT_EQ(script.frames[0].threads, 2);
    EXPECT_EQ(script.frames[0].view.width_px, 16);
    ASSERT_EQ(rows.size(), 3U);
    const auto hidden = static_cast<std::size_t>(Skip::occlusion_culling);
    EXPECT_EQ((*rows[0].row.skips)[hidden].skipped, 50U);
    EXPECT_EQ((*rows[1].row.skips)[hidden].skipped, 0U);
    EXPECT_EQ(rows[1].row.skips_off, own_off);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const harness::Row& row = rows[i].row;
        EXPECT_EQ(row.status, "ok");
        EXPECT_EQ(row.axis, "skips_off");
        EXPECT_EQ(row.value, static_cast<double>(i + 1));
        EXPECT_EQ(row.method, "puppet");
        EXPECT_EQ(row.scene, "behind_a_wall");
        EXPECT_EQ(row.draw_n, 2);
        EXPECT_EQ(row.image_hash, rows[0].row.image_hash);
    }
}

TEST(SkipAxes, OfAViewCompareEverythingWithNothing) {
    harness::SkipScript script;
    const auto info = harness::skipping_info(script);
    const auto rows = rows_on(skip_axes(2).back(), {&info, {}});
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].row.value, 1);
    EXPECT_EQ(rows[1].row.value, 3);
}

TEST(SkipAxes, OfASequencePoseEveryFrameAndLeaveTheFirstUntimed) {
    harness::SkipScript script{.counts = harness::made_up_counts()};
    const auto info = harness::skipping_info(script);
    const Case sequence = case_for(Skip::temporal_reuse, 2);
    ASSERT_EQ(sequence.poses.size(), 4U);
    const auto rows = rows_on(axis_for(Skip::temporal_reuse), {&info, {}});
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].row.skips_off, "");
    EXPECT_EQ(rows[1].row.skips_off, "temporal_reuse");
    EXPECT_EQ(script.frames.size(), 3U * 3 * 4) << "rounds, values, frames";
    EXPECT_EQ(script.poses.size(), 1 + script.frames.size()) << "one to begin with";
    EXPECT_EQ(rows[0].row.draw_n, 2 * 3);
    const auto still = static_cast<std::size_t>(Skip::temporal_reuse);
    EXPECT_EQ((*rows[0].row.skips)[still].skipped, 3 * 80U) << "over the timed frames of a round";
    EXPECT_EQ((*rows[0].row.skips)[still].of, 3 * 100U);
    // Only the first instance moves, and it does.
    for (std::size_t i = 1; i <= 4; ++i) {
        const auto& instances = script.poses[i].instances;
        EXPECT_EQ(instances[0].world_from_object, sequence.poses[i - 1]);
        EXPECT_EQ(instances[1].world_from_object,
                  sequence.scene_views.scene.instances[1].world_from_object);
    }
    EXPECT_NE(sequence.poses[0], sequence.poses[1]);
}

TEST(SkipAxes, GiveASceneItsSettingsWhereTheMethodKnowsThem) {
    harness::SkipScript script;
    const auto info = harness::skipping_info(script);
    const auto rows = rows_on(axis_for(Skip::attributes), {&info, {}});
    EXPECT_EQ(rows[0].row.params, "range_nx=0;threshold=100") << "it knows no range_ny";
}

TEST(SkipAxes, AnImageThatASkipChangesIsAFaultThere) {
    harness::SkipScript script{.wrong = Skip::occlusion_culling};
    const auto info = harness::skipping_info(script);
    const auto rows = rows_on(axis_for(Skip::occlusion_culling), {&info, {}});
    EXPECT_EQ(rows[0].row.status, "ok");
    for (std::size_t i : {1U, 2U}) {
        EXPECT_EQ(rows[i].row.status, "differs: the image is another than at skips_off none off");
        EXPECT_EQ(rows[i].faults.differing, 1);
        EXPECT_NE(rows[i].row.image_hash, rows[0].row.image_hash);
    }
}

TEST(SkipAxes, AMethodThatFailsSaysSoInEveryRow) {
    harness::SkipScript script{.failure = "out of ink"};
    const auto info = harness::skipping_info(script);
    const auto rows = rows_on(axis_for(Skip::back_face_culling), {&info, {}});
    ASSERT_EQ(rows.size(), 3U);
    for (const AxisRow& of : rows) {
        EXPECT_EQ(of.row.status, "failed: out of ink");
        EXPECT_FALSE(of.row.draw_ns);
        EXPECT_EQ(of.faults.differing, 0);
    }
}

TEST(SkipAxes, AreOnePerSkipAndThreeViews) {
    int cells = 0;
    std::set<std::string> scenes;
    for (const Axis& axis : skip_axes(2)) {
        cells += rows_of_case(axis, 1);
        scenes.insert(axis.scene);
    }
    EXPECT_EQ(cells, 8 * 3 + 3 * 2);
    EXPECT_EQ(scenes.size(), raster::kSkipCount + 3);
}

}  // namespace
}  // namespace ink::studies
