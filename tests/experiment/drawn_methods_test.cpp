// Methods that do not all fit into memory: they draw all views that are to come at once.

#include "experiment/drawn_methods.h"

#include <gtest/gtest.h>

#include "experiment/compare_blocks.h"
#include "experiment/view_bench.h"

namespace ink::experiment {
namespace {

Experiment two_views() {
    Experiment experiment;
    experiment.where = "test";
    experiment.name = "ahead";
    experiment.methods = {"mote4", "ids", "decaudin"};
    experiment.scenes = {"cube"};
    experiment.sizes = {{160, 90}};
    experiment.views = 2;
    experiment.repetitions = 1;
    experiment.times = false;
    experiment.full_scores = true;
    experiment.images = KeptImages::all;
    return experiment;
}

BlockPlace place(const ViewBench& bench, std::size_t nth_view) {
    return {0, &bench.view(0, {160, 90}, nth_view), 1, 0, nth_view == 0, true};
}

AskedView asked(const ViewBench& bench, std::size_t nth_view) {
    return {&bench.view(0, {160, 90}, nth_view), 1, true};
}

TEST(DrawnMethods, OneMethodAtATimeGivesTheSameTablesAndImagesAsAllTogether) {
    const Experiment experiment = two_views();
    ViewBench all(experiment, {});
    ViewBench one(experiment, {}, 1);
    ASSERT_EQ(one.most_at_once(0), 1U);
    for (const std::size_t v : {0U, 1U})
        expect_methods(one, place(one, v));
    for (const std::size_t v : {0U, 1U}) {
        const BlockResult expected = run_methods(all, place(all, v));
        const BlockResult result = run_methods(one, place(one, v));
        EXPECT_EQ(result.lines, expected.lines) << v;
        EXPECT_EQ(result.files, expected.files) << v;
        EXPECT_FALSE(expected.files.empty());
    }
}

TEST(DrawnMethods, AreDrawnBeforeTheirTurnWhereTheyAreExpected) {
    ViewBench one(two_views(), {}, 1);
    for (const std::size_t v : {0U, 1U})
        expect_methods(one, place(one, v));
    (void)run_methods(one, place(one, 0));
    const auto drawn = one.drawn_ahead(0).take(asked(one, 1));
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->evaluations.size(), 3U);
}

TEST(DrawnMethods, AreNotDrawnBeforeTheirTurnWhereAllFitOrNoneIsExpected) {
    ViewBench all(two_views(), {});
    expect_methods(all, place(all, 1));
    (void)run_methods(all, place(all, 0));
    EXPECT_FALSE(all.drawn_ahead(0).take(asked(all, 1)));
    ViewBench one(two_views(), {}, 1);
    (void)run_methods(one, place(one, 0));
    EXPECT_FALSE(one.drawn_ahead(0).take(asked(one, 1)));
}

TEST(DrawnAhead, AsksForSoManyOfOneSizeThatAreNotDrawn) {
    const scene::View small{{}, 16, 9};
    const scene::View large{{}, 32, 18};
    DrawnAhead ahead;
    const AskedView first{&small, 1, false};
    const AskedView other_threads{&small, 2, false};
    const AskedView other_size{&large, 1, false};
    const AskedView with_layers{&small, 1, true};
    for (const AskedView& expected : {first, other_size, other_threads, with_layers})
        ahead.expect(expected);
    EXPECT_FALSE(ahead.take(first));
    EXPECT_EQ(ahead.to_draw(first, 9), (std::vector<AskedView>{other_threads, with_layers}));
    EXPECT_EQ(ahead.to_draw(first, 1), (std::vector<AskedView>{other_threads}));
    EXPECT_TRUE(ahead.to_draw(first, 0).empty());
    ahead.keep(other_threads, {});
    EXPECT_EQ(ahead.to_draw(first, 9), (std::vector<AskedView>{with_layers}));
    EXPECT_TRUE(ahead.take(other_threads));
    EXPECT_FALSE(ahead.take(other_threads));
}

}  // namespace
}  // namespace ink::experiment
