#include "studies/skip_study.h"

#include <gmock/gmock.h>

#include <set>

#include "harness/skip_switches.h"
#include "studies/skips_table.h"
#include "tests/harness/skipping_method.h"

namespace ink::studies {
namespace {

using raster::Skip;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr SkipStudyOptions kQuick{
    .width_px = 16, .height_px = 9, .threads = 2, .levels = 2, .min_rounds = 2, .max_rounds = 2};

std::vector<std::string> forbidden_in(const std::vector<method::Frame>& frames) {
    std::vector<std::string> names;
    for (const method::Frame& frame : frames)
        names.push_back(harness::forbidden_skips(frame.skips));
    return names;
}

TEST(SkipScenes, AreOnePerSkipAndThreeViewsWithOneCameraEach) {
    std::set<std::string> names;
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        const SkipScene made = skip_scene(info.skip, 3);
        EXPECT_EQ(made.skip, info.skip);
        EXPECT_EQ(made.poses.empty(), info.skip != Skip::temporal_reuse) << info.name;
        names.insert(made.name);
        EXPECT_NO_THROW(scene::check_scene(made.scene)) << made.name;
        ASSERT_EQ(made.scene.cameras.size(), 1U) << made.name;
        EXPECT_EQ(made.scene.cameras[0].name, made.name);
    }
    const auto views = skip_views(3);
    ASSERT_EQ(views.size(), 3U);
    for (const SkipScene& view : views) {
        names.insert(view.name);
        EXPECT_FALSE(view.skip);
        EXPECT_EQ(scene::scene_hash(view.scene), scene::scene_hash(views[0].scene));
    }
    EXPECT_EQ(names.size(), raster::kSkipCount + 3);
}

TEST(SkipScenes, TheDensestHasAMillionTriangles) {
    EXPECT_EQ(scene::triangle_count(skip_scene(Skip::no_sample, 4).scene), 20U << (2 * 4));
    static_assert(20 << (2 * kSkipSceneLevels) > 1'000'000);
}

/// The pixels that hold something.
int drawn_px(const SkipScene& scene) {
    edge::EdgeImage out(160, 90);
    const auto method = methods::find_method("mote4").make({});
    method->prepare(scene.scene);
    method->pose(scene.scene);
    method->draw({{scene.scene.cameras[0], 160, 90}, 1}, out);
    return static_cast<int>(
        std::count_if(out.data(), out.data() + out.size(), [](auto s) { return s > 0; }));
}

TEST(SkipViews, AreEmptySmallAndFull) {
    const auto views = skip_views(6);
    EXPECT_EQ(drawn_px(views[0]), 0);
    EXPECT_GT(drawn_px(views[1]), 0);
    EXPECT_LT(drawn_px(views[1]), 160 * 90 / 50);
    EXPECT_GT(drawn_px(views[2]), 0);
}

TEST(TimeSkips, DrawsAllArmsInTurnsAndCountsTheSkipsOfEach) {
    harness::SkipScript script{.counts = harness::made_up_counts()};
    const auto info = harness::skipping_info(script);
    const auto times = time_skips({&info, {}}, skip_scene(Skip::occlusion_culling, 2), kQuick);
    const std::string all = harness::forbidden_skips(raster::SkipSet::none());
    const std::string on = "temporal_reuse";
    const std::string one_off = "occlusion_culling;temporal_reuse";
    // The first round warms up; another arm begins each round.
    EXPECT_THAT(forbidden_in(script.frames),
                ElementsAre(on, one_off, all, one_off, all, on, all, on, one_off));
    EXPECT_EQ(script.frames[0].threads, 2);
    EXPECT_EQ(script.frames[0].view.width_px, 16);
    ASSERT_EQ(times.size(), 3U);
    const auto hidden = static_cast<std::size_t>(Skip::occlusion_culling);
    EXPECT_EQ(times[0].arm, SkipArm::on);
    EXPECT_EQ(times[0].counts[hidden].skipped, 50U);
    EXPECT_EQ(times[1].arm, SkipArm::one_off);
    EXPECT_EQ(times[1].counts[hidden].skipped, 0U);
    EXPECT_EQ(times[2].arm, SkipArm::all_off);
    for (const SkipTime& time : times) {
        EXPECT_EQ(time.status, "ok");
        EXPECT_EQ(time.method, "puppet");
        EXPECT_EQ(time.scene, "behind_a_wall");
        EXPECT_EQ(time.draw_n, 2);
        EXPECT_LE(*time.draw_ns_min, *time.draw_ns);
        EXPECT_EQ(time.image_hash, times[0].image_hash);
    }
}

TEST(TimeSkips, OfAViewComparesEverythingWithNothing) {
    harness::SkipScript script;
    const auto info = harness::skipping_info(script);
    const auto times = time_skips({&info, {}}, skip_views(2).front(), kQuick);
    ASSERT_EQ(times.size(), 2U);
    EXPECT_EQ(times[0].arm, SkipArm::on);
    EXPECT_EQ(times[1].arm, SkipArm::all_off);
}

TEST(TimeSkips, OfASequencePosesEveryFrameAndLeavesTheFirstUntimed) {
    harness::SkipScript script{.counts = harness::made_up_counts()};
    const auto info = harness::skipping_info(script);
    const SkipScene scene = skip_scene(Skip::temporal_reuse, 2);
    ASSERT_EQ(scene.poses.size(), 4U);
    const auto times = time_skips({&info, {}}, scene, kQuick);
    ASSERT_EQ(times.size(), 3U);
    EXPECT_EQ(harness::forbidden_skips(times[0].allowed), "");
    EXPECT_EQ(harness::forbidden_skips(times[1].allowed), "temporal_reuse");
    EXPECT_EQ(script.frames.size(), 3U * 3 * 4) << "rounds, arms, frames";
    EXPECT_EQ(script.poses.size(), 1 + script.frames.size()) << "one to begin with";
    EXPECT_EQ(times[0].draw_n, 2 * 3);
    const auto still = static_cast<std::size_t>(Skip::temporal_reuse);
    EXPECT_EQ(times[0].counts[still].skipped, 3 * 90U) << "over the timed frames of a round";
    EXPECT_EQ(times[0].counts[still].of, 3 * 100U);
    // Only the first instance moves, and it does.
    std::set<std::string> seen;
    for (std::size_t i = 1; i <= 4; ++i) {
        const auto& instances = script.poses[i].instances;
        EXPECT_EQ(instances[0].world_from_object, scene.poses[i - 1]);
        EXPECT_EQ(instances[1].world_from_object, scene.scene.instances[1].world_from_object);
    }
    EXPECT_NE(scene.poses[0], scene.poses[1]);
}

TEST(TimeSkips, GivesASceneItsSettingsWhereTheMethodKnowsThem) {
    harness::SkipScript script;
    const auto info = harness::skipping_info(script);
    const auto times = time_skips({&info, {}}, skip_scene(Skip::attributes, 2), kQuick);
    EXPECT_EQ(times[0].params, "range_nx=0;threshold=100") << "it knows no range_ny";
}

TEST(TimeSkips, AnImageThatASkipChangesIsAnErrorOfThatArm) {
    harness::SkipScript script{.wrong = Skip::occlusion_culling};
    const auto info = harness::skipping_info(script);
    const auto times = time_skips({&info, {}}, skip_scene(Skip::occlusion_culling, 2), kQuick);
    EXPECT_EQ(times[0].status, "ok");
    EXPECT_EQ(times[1].status,
              "differs: the image is another without occlusion_culling;temporal_reuse");
    EXPECT_THAT(times[2].status, HasSubstr("differs"));
    EXPECT_NE(times[1].image_hash, times[0].image_hash);
    EXPECT_THAT(skip_differences(times),
                ElementsAre("puppet on behind_a_wall differs: the image is another without "
                            "occlusion_culling;temporal_reuse",
                            HasSubstr("without attributes;frustum_culling")));
}

TEST(TimeSkips, AMethodThatFailsSaysSoInEveryLine) {
    harness::SkipScript script{.failure = "out of ink"};
    const auto info = harness::skipping_info(script);
    const auto times = time_skips({&info, {}}, skip_scene(Skip::back_face_culling, 2), kQuick);
    ASSERT_EQ(times.size(), 3U);
    for (const SkipTime& time : times) {
        EXPECT_EQ(time.status, "failed: out of ink");
        EXPECT_FALSE(time.draw_ns);
    }
    EXPECT_THAT(skip_differences(times), IsEmpty());
}

TEST(StudySkips, IsEverySceneWithEveryConfigAndARowEach) {
    harness::SkipScript script{.counts = harness::made_up_counts()};
    const auto info = harness::skipping_info(script);
    std::vector<SkipTime> study;
    for (std::size_t n = 0; n < skip_scene_count(); ++n) {
        for (const SkipTime& time : study_skip_scene({{&info, {}}}, n, kQuick))
            study.push_back(time);
    }
    EXPECT_EQ(study.size(), 9U * 3 + 3 * 2);
    const harness::Row first = skip_row(study.front(), kQuick);
    EXPECT_EQ(first.scene, "no_normals");
    EXPECT_EQ(first.method, "puppet");
    EXPECT_EQ(first.params, "range_nx=0;threshold=100");
    EXPECT_EQ(first.skips_off, "temporal_reuse");
    EXPECT_EQ(first.width, 16);
    EXPECT_EQ(first.height, 9);
    EXPECT_EQ(first.threads, 2);
    EXPECT_EQ(first.triangles, 80);
    ASSERT_TRUE(first.skips);
    EXPECT_EQ((*first.skips)[1].skipped, 20U);
    EXPECT_EQ((*first.skips)[1].of, 100U);
    EXPECT_EQ(skip_line(1, study.front()), "1,attributes,on\n");
    EXPECT_EQ(skip_line(2, study.back()), "2,,all_off\n") << "of a view, made for no skip";
}

}  // namespace
}  // namespace ink::studies
