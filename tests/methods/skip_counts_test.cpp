// Each skip has something to do on the scene that was made for it. Links ink::lab, whose scenes
// these are.

#include <gtest/gtest.h>

#include "lab/skip_scenes.h"
#include "lab/skip_study.h"
#include "lab/skip_switches.h"

namespace ink::methods {
namespace {

class SkipCounts : public testing::TestWithParam<raster::SkipInfo> {
  protected:
    static constexpr int kLevels = 7;  // a 4th of the triangles, on a 4th of the pixels

    /// mote4 on the scene of the skip: with every skip, without that one, without any.
    std::vector<lab::SkipTime> times() const {
        const auto entrants = lab::make_entrants("mote4", {});
        const auto scene = lab::skip_scene(GetParam().skip, kLevels);
        return lab::time_skips(
            entrants.front(),
            scene,
            {.width_px = 640, .height_px = 360, .min_rounds = 1, .max_rounds = 1});
    }
    raster::SkipCount count(const lab::SkipTime& time) const {
        return time.counts[static_cast<std::size_t>(GetParam().skip)];
    }
};

TEST_P(SkipCounts, AreAboveZeroOnTheSceneMadeForThem) {
    const auto timed = times();
    ASSERT_EQ(timed.front().status, "ok");
    EXPECT_GT(count(timed.front()).skipped, 0U);
    EXPECT_LE(count(timed.front()).skipped, count(timed.front()).of);
}

TEST_P(SkipCounts, AreZeroWhereTheSkipIsNotAllowed) {
    const auto timed = times();
    ASSERT_EQ(timed.size(), 3U);
    EXPECT_EQ(count(timed[1]).skipped, 0U);
    for (const raster::SkipCount& any : timed[2].counts)
        EXPECT_EQ(any.skipped, 0U);
}

TEST_P(SkipCounts, DoNotDependOnTheNumberOfThreads) {
    const auto scene = lab::skip_scene(GetParam().skip, kLevels);
    const auto info = lab::make_entrants("mote4", {}).front().info;
    std::vector<raster::SkipCount> counts;
    for (const int threads : {1, 2}) {
        const auto method = info->make(scene.settings);
        const scene::View view{scene.scene.cameras.front(), 640, 360};
        edge::EdgeImage out(view.width_px, view.height_px);
        method->prepare(scene.scene);
        scene::Scene posed = scene.scene;
        for (const glm::dmat4& pose : scene.poses.empty()
                                          ? std::vector{posed.instances[0].world_from_object}
                                          : scene.poses) {
            posed.instances[0].world_from_object = pose;
            method->pose(posed);
            method->draw({view, threads}, out);
        }
        counts.push_back(method->skip_counts()[static_cast<std::size_t>(GetParam().skip)]);
    }
    EXPECT_EQ(counts[0].skipped, counts[1].skipped);
    EXPECT_EQ(counts[0].of, counts[1].of);
}

INSTANTIATE_TEST_SUITE_P(Every,
                         SkipCounts,
                         testing::ValuesIn(raster::skip_infos()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace ink::methods
