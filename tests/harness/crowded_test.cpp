#include "harness/unscored_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/view_cells.h"

namespace ink::harness {
namespace {

/// The baselines of a scene's first view at this size, scored.
std::vector<Evaluation> baselines_of(const char* scene, int width_px, int height_px) {
    ViewRequest request;
    request.width_px = width_px;
    request.height_px = height_px;
    const SceneViews scene_views = make_scene_views(load_scene(scene), request);
    CellOptions options;
    options.trace.crosscheck = false;
    truth::SceneModel model(scene_views.scene, options.trace.truth);
    const scene::View& view = scene_views.views.front();
    const TracedView traced = trace_with_facts(model, scene_views.scene, view, options.trace);
    std::vector<Evaluation> evaluations;
    finish_evaluations(scene_views.scene, view, traced, options, evaluations);
    return evaluations;
}

TEST(Crowded, AViewBeyondTheLimitSaysSoAndCountsAllBeside) {
    for (const Evaluation& evaluation : baselines_of("bush", 240, 135)) {
        const Row& row = evaluation.row;
        EXPECT_GT(row.crowded_share, kMostCrowded);
        EXPECT_THAT(row.status, testing::StartsWith("crowded: ")) << row.method;
        EXPECT_FALSE(row.is_scored());
        ASSERT_TRUE(row.with_crowded_2px.has_value()) << row.method;
        EXPECT_GT(row.with_crowded_2px->n_truth, 0);
        if (row.method == "none") {
            EXPECT_EQ(row.with_crowded_2px->f(), 0);
        }
        if (row.method == "oracle") {
            EXPECT_EQ(row.with_crowded_2px->f(), 1);
        }
        // Nothing that a reader could take into a mean.
        EXPECT_FALSE(row.f_2px || row.f_1px || row.recall_2px || row.all_intersections_2px);
        EXPECT_FALSE(row.random_baseline || row.lines);
        EXPECT_EQ(row.n_truth, 0);
    }
}

TEST(Crowded, WhereNothingIsBothCountsAreOne) {
    for (const Evaluation& evaluation : baselines_of("cube", 320, 180)) {
        const Row& row = evaluation.row;
        EXPECT_EQ(row.crowded_share, 0);
        EXPECT_EQ(row.status, "ok");
        const score::CurveCount counts{row.k_2px, row.n_pred, row.n_truth};
        EXPECT_EQ(row.with_crowded_2px, counts) << row.method;
    }
}

}  // namespace
}  // namespace ink::harness
