// Skips on their way from the command line through a timed drawing into a row.

#include <gmock/gmock.h>

#include "core/error.h"
#include "harness/cells/cell.h"
#include "tests/core/error_text.h"
#include "tests/harness/made_up_method.h"
#include "tests/harness/random_rows.h"

namespace ink::harness {
namespace {

using raster::Skip;
using raster::SkipSet;

TEST(WithoutSkips, TakesNamesAwayAndAllTakesEverything) {
    EXPECT_EQ(without_skips({}, {}), SkipSet());
    EXPECT_EQ(without_skips({}, {"occlusion_culling", "back_face_culling"}),
              SkipSet().set(Skip::occlusion_culling, false).set(Skip::back_face_culling, false));
    EXPECT_EQ(without_skips({}, {"all"}), SkipSet::none());
    EXPECT_EQ(without_skips(SkipSet::none(), {"occlusion_culling"}), SkipSet::none());
}

TEST(WithoutSkips, AnUnknownNameIsAnErrorThatListsThem) {
    EXPECT_THAT(core::error_text([] {
                    return without_skips({}, {"back_face_culling", "oclusion_culling"});
                }),
                testing::ContainsRegex("^--no-skip: .*'oclusion_culling'.*attributes.*"
                                       "temporal_reuse.*all.*did you mean occlusion_culling"));
}

TEST(ForbiddenSkips, AreNamedInTheOrderOfTheTable) {
    EXPECT_EQ(forbidden_skips({}), "");
    EXPECT_EQ(forbidden_skips(without_skips({}, {"occlusion_culling", "frustum_culling"})),
              "frustum_culling;occlusion_culling");
    EXPECT_EQ(forbidden_skips(SkipSet::none()),
              "attributes;frustum_culling;back_face_culling;no_sample;occlusion_culling;empty_"
              "tiles;flat_tiles;temporal_reuse");
}

TEST(SkipsOfRepeatedDrawings, AreAllButThoseOfWhatStandsStill) {
    EXPECT_EQ(forbidden_skips(skips_of_repeated_drawings()), "temporal_reuse");
    EXPECT_EQ(forbidden_skips(MeasureOptions().skips), "temporal_reuse");
}

TEST(DrawInTurns, AllowsWhatTheOptionsAllowAndCountsTheLastDrawing) {
    Script script{.counts = made_up_counts()};
    MeasureOptions options{1, 2, 2, 1000};
    options.skips = without_skips({}, {"back_face_culling"});
    const Row row = timed(script, options);
    ASSERT_EQ(script.frames.size(), 3U);
    for (const method::Frame& frame : script.frames)
        EXPECT_EQ(frame.skips, options.skips);
    EXPECT_EQ(row.skips_off, "back_face_culling");
    EXPECT_EQ(field(row, "skips_off"), "back_face_culling");
    EXPECT_EQ(field(row, "skip_frustum_culling"), "20");
    EXPECT_EQ(field(row, "skip_frustum_culling_of"), "100");
    EXPECT_EQ(field(row, "skip_back_face_culling"), "0") << "not allowed";
    EXPECT_EQ(field(row, "skip_temporal_reuse"), "80");
    EXPECT_EQ(field(row, "skip_temporal_reuse_of"), "100");
}

TEST(DrawInTurns, AMethodThatFailedCountsNothing) {
    Script script{.counts = made_up_counts(), .failure = "out of ink"};
    const Row row = timed(script, {1, 2, 2, 1000});
    EXPECT_EQ(row.skips, std::nullopt);
    EXPECT_EQ(field(row, "skip_occlusion_culling"), "");
    EXPECT_EQ(field(row, "skip_occlusion_culling_of"), "");
}

}  // namespace
}  // namespace ink::harness
