// Skips on their way from the command line through a timed drawing into a row.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "harness/cell.h"
#include "harness/row_table.h"
#include "harness/skip_switches.h"
#include "tests/harness/skipping_method.h"
#include "tests/scene/small_meshes.h"

namespace ink::harness {
namespace {

using raster::Skip;
using raster::SkipSet;
using testing::HasSubstr;

std::string field(const Row& row, const std::string& column) {
    const CsvTable table =
        split_csv(heading(rows_table()) + row_line(1, Study::compare, row), "rows.csv");
    return table.records.at(0).at(table.find(column));
}

TEST(WithoutSkips, TakesNamesAwayAndAllTakesEverything) {
    EXPECT_EQ(without_skips({}, ""), SkipSet());
    EXPECT_EQ(without_skips({}, "hidden,backs"),
              SkipSet().set(Skip::hidden, false).set(Skip::backs, false));
    EXPECT_EQ(without_skips({}, "all"), SkipSet::none());
    EXPECT_EQ(without_skips(SkipSet::none(), "hidden"), SkipSet::none());
}

TEST(WithoutSkips, AnUnknownNameIsAnErrorThatListsThem) {
    try {
        (void)without_skips({}, "backs,hiden");
        FAIL() << "no error";
    } catch (const core::Error& error) {
        EXPECT_EQ(error.where(), "--no-skip");
        EXPECT_THAT(error.what(), HasSubstr("'hiden'"));
        EXPECT_THAT(error.accepted(), HasSubstr("did you mean hidden?"));
        for (const char* name : {"attributes", "still_tiles", "all"})
            EXPECT_THAT(error.accepted(), HasSubstr(name));
    }
}

TEST(ForbiddenSkips, AreNamedInTheOrderOfTheTable) {
    EXPECT_EQ(forbidden_skips({}), "");
    EXPECT_EQ(forbidden_skips(without_skips({}, "hidden,frustum")), "frustum;hidden");
    EXPECT_EQ(forbidden_skips(SkipSet::none()),
              "attributes;frustum;backs;no_sample;hidden;empty_tiles;flat_tiles;flat_stencils;"
              "still_tiles");
}

TEST(SkipsOfRepeatedDrawings, AreAllButThoseOfWhatStandsStill) {
    EXPECT_EQ(forbidden_skips(skips_of_repeated_drawings()), "still_tiles");
    EXPECT_EQ(forbidden_skips(MeasureOptions().skips), "still_tiles");
}

struct Stage {
    SkipScript script{.counts = made_up_counts()};
    method::MethodInfo info = skipping_info(script);
    scene::Scene scene = scene::scene_of(scene::unit_cube());
    scene::View view{scene::orbit_cameras(scene::bounding_sphere(scene), 1, 1).front(), 8, 8};

    Row timed(MeasureOptions options) {
        std::vector<std::unique_ptr<PreparedMethod>> methods;
        methods.push_back(std::make_unique<PreparedMethod>(Entrant{&info, {}}, scene));
        std::vector<edge::EdgeImage> pictures;
        const auto times = draw_in_turns(methods, view, options, pictures);
        Row row = methods[0]->row();
        fill_skips(times[0], options.skips, row);
        return row;
    }
};

TEST(DrawInTurns, AllowsWhatTheOptionsAllowAndCountsTheLastDrawing) {
    Stage stage;
    MeasureOptions options{1, 2, 2, 1000};
    options.skips = without_skips({}, "backs");
    const Row row = stage.timed(options);
    ASSERT_EQ(stage.script.frames.size(), 3U);
    for (const method::Frame& frame : stage.script.frames)
        EXPECT_EQ(frame.skips, options.skips);
    EXPECT_EQ(row.skips_off, "backs");
    EXPECT_EQ(field(row, "skips_off"), "backs");
    EXPECT_EQ(field(row, "skip_frustum"), "20");
    EXPECT_EQ(field(row, "skip_frustum_of"), "100");
    EXPECT_EQ(field(row, "skip_backs"), "0") << "not allowed";
    EXPECT_EQ(field(row, "skip_still_tiles"), "90");
    EXPECT_EQ(field(row, "skip_still_tiles_of"), "100");
}

TEST(DrawInTurns, AMethodThatFailedCountsNothing) {
    Stage stage;
    stage.script.failure = "out of ink";
    const Row row = stage.timed({1, 2, 2, 1000});
    EXPECT_EQ(row.skips, std::nullopt);
    EXPECT_EQ(field(row, "skip_hidden"), "");
    EXPECT_EQ(field(row, "skip_hidden_of"), "");
}

TEST(RowTable, HasTwoColumnsForEverySkipWithTheirUnit) {
    const auto& columns = rows_table().columns;
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        const std::string name = "skip_" + std::string(info.name);
        const auto has = [&](const std::string& column) {
            return std::count_if(columns.begin(), columns.end(), [&](const Column& c) {
                return c.name == column && c.unit == info.unit;
            });
        };
        EXPECT_EQ(has(name), 1) << name;
        EXPECT_EQ(has(name + "_of"), 1) << name;
    }
    Row bracket;
    bracket.method = "oracle";
    EXPECT_EQ(field(bracket, "skip_hidden"), "");
    EXPECT_EQ(field(bracket, "skips_off"), "");
}

}  // namespace
}  // namespace ink::harness
