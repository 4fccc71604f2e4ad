#include "harness/cells/cell.h"
#include "harness/truths/tracing.h"

#include <gmock/gmock.h>

#include <random>

#include "core/error.h"
#include "tests/harness/made_up_method.h"

namespace ink::harness {
namespace {

struct Stage : SmallCube {
    PreparedMethods methods;

    void add(const method::MethodInfo& info) {
        methods.push_back(std::make_unique<PreparedMethod>(method::MethodConfig{&info, {}}, scene));
    }
};

TEST(DrawInTurns, RepeatsAtLeastTheMinimumAndKeepsTheImage) {
    Script script;
    const auto info = made_up_info(script);
    Stage stage;
    stage.add(info);
    std::vector<edge::EdgeImage> images;
    const auto times = draw_in_turns(stage.methods, stage.view, {1, 3, 5, 1000, 0}, images);
    EXPECT_EQ(times[0].failure, "");
    EXPECT_EQ(times[0].draws.size(), 5U);
    EXPECT_EQ(script.frames.size(), 6U);  // one to warm up
    EXPECT_EQ(images[0].at(1, 1), 200);
}

TEST(DrawInTurns, OneMethodsFailureIsItsOwn) {
    Script good, bad, moody, unprepared;
    bad.failure = "out of ink";
    moody.on_draw = [&] { ++moody.edge_response; };
    unprepared.failure_to_prepare = "it will not prepare";
    const auto infos = std::vector{
        made_up_info(good), made_up_info(bad), made_up_info(moody), made_up_info(unprepared)};
    Stage stage;
    for (const auto& info : infos)
        stage.add(info);
    std::vector<edge::EdgeImage> images;
    const auto times = draw_in_turns(stage.methods, stage.view, {1, 2, 2, 1}, images);
    EXPECT_EQ(times[0].failure, "");
    EXPECT_THAT(times[1].failure, testing::HasSubstr("out of ink"));
    EXPECT_THAT(times[2].failure, testing::HasSubstr("two drawings of one view differ"));
    EXPECT_THAT(times[3].failure, testing::HasSubstr("it will not prepare"));
    EXPECT_EQ(stage.methods[3]->row().status, "puppet: it will not prepare");
    EXPECT_FALSE(stage.methods[3]->row().prepare_ns.has_value());
}

TEST(FillScores, CountsAddUpAndNullsStayNull) {
    score::ScoreOptions options;
    core::Image<std::uint8_t> labels(40, 40);
    for (int x = 10; x < 30; ++x)
        labels.at(x, 20) = 1;
    edge::EdgeImage image(40, 40);
    for (int x = 10; x < 20; ++x)
        image.at(x, 20) = 255;
    const auto truth = list_tolerances(score::prepare_truth(labels, options, true));
    Row row;
    fill_scores(score_image(image, truth, 128), row);
    EXPECT_EQ(row.k_2px + row.unmatched_truth + row.false_negatives, row.n_truth);
    EXPECT_EQ(row.k_2px + row.unmatched_duplicates + row.false_positives, row.n_pred);
    EXPECT_EQ(row.precision_2px, 1.0);

    Row empty;
    fill_scores(score_image(edge::EdgeImage(40, 40), truth, 128), empty);
    EXPECT_EQ(empty.f_2px, 0.0);
    EXPECT_FALSE(empty.precision_2px.has_value());
    EXPECT_FALSE(empty.mean_width_px.has_value());
}

TEST(ScoreImage, SaysAtEachToleranceWhatAScoreSays) {
    std::mt19937 random(5);
    edge::EdgeImage image(60, 50);
    core::Image<std::uint8_t> labels(60, 50);
    for (std::size_t i = 0; i < image.size(); ++i) {
        image.data()[i] = static_cast<std::uint8_t>(random() % 5 == 0 ? random() % 256 : 0);
        labels.data()[i] = static_cast<std::uint8_t>(random() % 10 == 0 ? 1 + random() % 7 : 0);
    }
    score::ScoreOptions options = score_options(90);
    const auto truth = score::prepare_truth(labels, options, false);
    const Scored scored = score_image(image, list_tolerances(truth), 90);
    ASSERT_EQ(scored.tolerance_sweep.size(), harness::kTolerances_px.size());
    for (std::size_t i = 0; i < scored.tolerance_sweep.size(); ++i) {
        options.tolerance_px = harness::kTolerances_px[i];
        const score::Score s = score::score(image, truth, options);
        EXPECT_EQ(scored.tolerance_sweep[i], s);
    }
}

TEST(JoinParams, IsOrderedByName) {
    EXPECT_EQ(join_params({{"b", "2"}, {"a", "x"}}), "a=x;b=2");
}

}  // namespace
}  // namespace ink::harness
