#include "harness/scores/intersection_scores.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/cells/cell.h"
#include "harness/scores/evaluations.h"
#include "tests/truth/shapes.h"

namespace ink::harness {
namespace {

using score::Intersections;

/// Two crossing quads, a plane and one that leans out of it: their intersection stands upright and
/// bends by `bend_deg`.
void add_crossing(scene::Scene& scene, float bottom, double bend_deg) {
    const auto depth = static_cast<float>(std::tan(bend_deg * std::numbers::pi / 180));
    const float top = bottom + 1;
    scene::Mesh flat, leaning;
    truth::add_quad(flat, {-1, bottom, 0}, {1, bottom, 0}, {1, top, 0}, {-1, top, 0});
    truth::add_quad(leaning,
                    {-0.5F, bottom + 0.1F, -depth / 2},
                    {0.5F, bottom + 0.1F, depth / 2},
                    {0.5F, top - 0.1F, depth / 2},
                    {-0.5F, top - 0.1F, -depth / 2});
    for (scene::Mesh* mesh : {&flat, &leaning}) {
        scene.instances.push_back(
            {static_cast<std::uint32_t>(scene.meshes.size()), glm::dmat4(1), "object"});
        scene.meshes.push_back(std::move(*mesh));
    }
}

/// One intersection bends by 20 degrees, one by 60.
class Crossings : public testing::Test {
  protected:
    Crossings() {
        add_crossing(scene_, 0.1F, 20);
        add_crossing(scene_, -1.1F, 60);
    }

    ViewTruth traced(Intersections intersections) {
        TraceOptions trace;
        trace.intersections = intersections;
        truth::SceneModel model(scene_, trace.truth);
        return trace_view(model, truth::view_from(4), trace);
    }

    static Row scored(const edge::EdgeImage& image, const ViewTruth& truth) {
        Row row;
        fill_score_2px(
            score::make_strokes(image, 128, score_options(128)), truth, list_view(truth), row);
        return row;
    }

    /// Every line of the truth, or all but the flat intersection.
    static edge::EdgeImage drawing(const truth::Truth& traced, bool has_flat) {
        edge::EdgeImage image(traced.labels.width_px(), traced.labels.height_px());
        for (std::size_t i = 0; i < image.size(); ++i) {
            const bool is_drawn =
                traced.labels.data()[i] != 0 && (has_flat || traced.below_crease.data()[i] == 0);
            image.data()[i] = is_drawn ? 255 : 0;
        }
        return image;
    }

    scene::Scene scene_;
};

TEST_F(Crossings, AboveTheCreaseAngleAFlatOneMayBeLeftOut) {
    const ViewTruth truth = traced(Intersections::above_crease);
    const Row row = scored(drawing(truth.traced, false), truth);
    EXPECT_EQ(row.f_2px, 1);
    EXPECT_EQ(row.above_crease_2px->f(), 1);
    EXPECT_LT(row.all_intersections_2px->f(), 1);
    EXPECT_EQ(row.by_class.at("intersection_above_crease").f(), 1);
    EXPECT_LT(row.by_class.at("intersection_below_crease").f(), 0.1);
    EXPECT_GT(row.by_class.at("intersection_below_crease").n_truth, 100);
}

TEST_F(Crossings, AFlatOneThatIsDrawnIsNoFalsePositive) {
    const ViewTruth truth = traced(Intersections::above_crease);
    const Row row = scored(drawing(truth.traced, true), truth);
    EXPECT_EQ(row.false_positives, 0);
    EXPECT_GT(*row.f_2px, 0.99) << "pixels beside other lines count as duplicates there";
    EXPECT_EQ(row.all_intersections_2px->f(), 1);
    EXPECT_EQ(row.by_class.at("intersection_below_crease").f(), 1);
}

TEST_F(Crossings, EitherChoiceTellsBoth) {
    const ViewTruth above = traced(Intersections::above_crease);
    const ViewTruth all = traced(Intersections::all);
    for (const bool has_flat : {false, true}) {
        const edge::EdgeImage image = drawing(above.traced, has_flat);
        const Row of_above = scored(image, above), of_all = scored(image, all);
        EXPECT_EQ(of_above.f_2px, of_above.above_crease_2px->f());
        EXPECT_EQ(of_all.f_2px, of_all.all_intersections_2px->f());
        EXPECT_EQ(of_above.above_crease_2px, of_all.above_crease_2px);
        EXPECT_EQ(of_above.all_intersections_2px, of_all.all_intersections_2px);
        EXPECT_EQ(of_above.by_class, of_all.by_class);
    }
}

TEST_F(Crossings, TheTruthScoresOneAgainstItselfWithEither) {
    for (const Intersections intersections : {Intersections::above_crease, Intersections::all}) {
        const ViewTruth truth = traced(intersections);
        const auto baselines = baseline_evaluations(truth);
        EXPECT_EQ(scored(baselines[3].image, truth).f_2px, 1);
        EXPECT_EQ(scored(baselines[0].image, truth).f_2px, 0);
    }
}

TEST_F(Crossings, TheKeptTruthImageIsTheOneThatIsScored) {
    const ViewTruth truth = traced(Intersections::above_crease);
    const auto count = [](const core::Image<std::uint8_t>& labels, int label) {
        return std::count(labels.data(), labels.data() + labels.size(), label);
    };
    EXPECT_GT(count(truth.counted_labels(), 7), 100);
    EXPECT_EQ(count(truth.traced.labels, 7), 0);
    EXPECT_EQ(traced(Intersections::all).counted_labels(), truth.traced.labels);
}

TEST(TraceOptions, TellTheCreaseAngleInRoundDegrees) {
    for (int deg = 0; deg <= 180; ++deg) {
        TraceOptions trace;
        trace.truth.crease_rad = deg * (std::numbers::pi / 180);
        EXPECT_EQ(trace.crease_deg(), deg);
    }
}

}  // namespace
}  // namespace ink::harness
