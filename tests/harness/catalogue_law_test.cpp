// Laws of the score that hold on every image, over every frame of the catalogue and every method.

#include <gtest/gtest.h>

#include "catalogue/catalogue.h"
#include "core/parallel.h"
#include "harness/cells/cell.h"
#include "harness/scores/bins.h"
#include "harness/suite/suite.h"
#include "harness/truths/tracing.h"
#include "methods/registry.h"
#include "tests/catalogue_names.h"
#include "tests/models/fetched_model.h"

namespace ink::harness {
namespace {

constexpr std::array kTolerances_px = {0.5, 1.0, 1.5, 2.0, 3.0, 4.0};

class EveryScene : public testing::TestWithParam<std::string> {};

edge::EdgeImage drawing_of(const score::ScoringTruth& truth) {
    edge::EdgeImage image = truth.labels;
    for (std::size_t i = 0; i < image.size(); ++i)
        image.data()[i] = image.data()[i] != 0 ? 255 : 0;
    return image;
}

ViewRequest small_views() {
    ViewRequest request;
    request.width_px = 640;
    request.height_px = 360;
    using enum scene::ProjectionKind;
    request.projections = {perspective, parallel};
    return request;
}

ViewTruth truth_of(truth::SceneModel& model, const scene::View& view) {
    return trace_view(model, view, {});
}

truth::TruthOptions without_layers() {
    return {.threads = core::hardware_threads(), .layers = false};
}

score::Score score_of(const score::Strokes& strokes,
                      const score::ScoringTruth& truth,
                      const score::ScoreOptions& options) {
    const score::TruthLists lists = score::list_truth(truth, options);
    return score::score_lists(strokes, score::counted_pixels(strokes.thinned, lists), lists);
}

void expect_full_self_score(const ViewTruth& truth) {
    score::ScoreOptions options = score_options(128);
    const auto strokes = score::make_strokes(drawing_of(truth.scoring), 128, options);
    for (const double tolerance_px : kTolerances_px) {
        options.tolerance_px = tolerance_px;
        const score::Score s = score_of(strokes, truth.scoring, options);
        EXPECT_EQ(s.k, s.n_truth) << tolerance_px;
        EXPECT_EQ(s.k, s.n_pred) << tolerance_px;
        EXPECT_EQ(s.f(), 1.0) << tolerance_px;
    }
}

void expect_laws(const edge::EdgeImage& image, int threshold, const ViewTruth& truth) {
    score::ScoreOptions options = score_options(threshold);
    const auto strokes = score::make_strokes(image, threshold, options);
    std::int64_t k_before = 0;
    for (const double tolerance_px : kTolerances_px) {
        options.tolerance_px = tolerance_px;
        const score::Score s = score_of(strokes, truth.scoring, options);
        EXPECT_EQ(s.n_pred, s.k + s.unmatched_duplicates + s.false_positives) << tolerance_px;
        EXPECT_EQ(s.n_truth, s.k + s.unmatched_truth + s.false_negatives) << tolerance_px;
        for (const std::int64_t n :
             {s.k, s.unmatched_duplicates, s.false_positives, s.unmatched_truth, s.false_negatives})
            EXPECT_GE(n, 0) << tolerance_px;
        EXPECT_GE(s.k, k_before) << tolerance_px;
        k_before = s.k;
        std::int64_t n_of_classes = 0, k_of_classes = 0;
        for (const score::ClassCount& c : s.classes) {
            EXPECT_LE(c.k, c.n_truth);
            n_of_classes += c.n_truth;
            k_of_classes += c.k;
        }
        EXPECT_EQ(n_of_classes, s.n_truth);
        EXPECT_GE(k_of_classes, s.k);
    }
}

/// Unthinned the score does not care which of the two images is the drawing.
void expect_symmetry(const edge::EdgeImage& image, int threshold, const ViewTruth& truth) {
    score::ScoreOptions options{.threshold = threshold, .thin = false};
    const auto strokes = score::make_strokes(image, threshold, options);
    const auto drawn_as_truth = score::prepare_truth(strokes.drawn, options, false);
    auto labels_as_truth = truth.scoring;
    labels_as_truth.ignore.fill(0);
    const score::Score there = score_of(strokes, labels_as_truth, options);
    const score::Score back = score::score(drawing_of(truth.scoring), drawn_as_truth, options);
    EXPECT_EQ(there.k, back.k);
    EXPECT_EQ(there.unmatched_duplicates, back.unmatched_truth);
    EXPECT_EQ(there.false_positives, back.false_negatives);
    EXPECT_EQ(there.unmatched_truth, back.unmatched_duplicates);
    EXPECT_EQ(there.false_negatives, back.false_positives);
}

/// Every bin of an attribute adds up to no more than is true, and the oracle finds all of each.
void expect_bins(const ViewTruth& truth) {
    const auto strokes = score::make_strokes(drawing_of(truth.scoring), 128, score_options(128));
    const score::TruthLists lists = list_view(truth).scoring;
    const score::PixelList drawn = score::counted_pixels(strokes.thinned, lists);
    score::DrawnMatcher matcher(drawn, lists.disk);
    std::array<std::int64_t, 4> n_truth{};
    for (const BinCount& bin : match_bins(matcher, bin_truth(truth.traced, truth.scoring))) {
        EXPECT_EQ(bin.k, bin.n_truth);
        n_truth[bin.attribute] += bin.n_truth;
    }
    const auto all = static_cast<std::int64_t>(drawn.size());
    EXPECT_EQ(n_truth[2], all);  // every line has a view angle and a distance
    EXPECT_EQ(n_truth[3], all);
    EXPECT_LE(n_truth[0], all);
    EXPECT_LE(n_truth[1], all);
}

TEST_P(EveryScene, KeepsTheLawsOfTheScore) {
    const SceneViews scene_views = make_scene_views(load_scene(GetParam()), small_views());
    truth::SceneModel model(scene_views.scene, without_layers());
    PreparedMethods methods;
    for (const method::MethodInfo& info : methods::registry())
        methods.push_back(
            std::make_unique<PreparedMethod>(method::MethodConfig{&info, {}}, scene_views.scene));
    for (const scene::View& view : scene_views.views) {
        SCOPED_TRACE(view.camera.name);
        const ViewTruth truth = truth_of(model, view);
        expect_full_self_score(truth);
        expect_bins(truth);
        for (const auto& method : methods) {
            SCOPED_TRACE(method->config().info->name);
            edge::EdgeImage image(view.width_px, view.height_px);
            method->method().draw({view, core::hardware_threads()}, image);
            expect_laws(image, method->threshold(), truth);
            expect_symmetry(image, method->threshold(), truth);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue,
                         EveryScene,
                         testing::ValuesIn(light_scene_names_and_scan()),
                         [](const auto& value) { return value.param; });

class EveryModel : public testing::TestWithParam<std::string> {};

TEST_P(EveryModel, ScoresOneAgainstItself) {
    const auto path = fetched_model(GetParam());
    INK_SKIP_WITHOUT(path);
    const SceneViews scene_views = make_scene_views(load_scene(path.string()), small_views());
    truth::SceneModel model(scene_views.scene, without_layers());
    for (const scene::View& view : scene_views.views) {
        SCOPED_TRACE(view.camera.name);
        expect_full_self_score(truth_of(model, view));
    }
}

INSTANTIATE_TEST_SUITE_P(Fetched,
                         EveryModel,
                         testing::Values("bunny_coarse.obj",
                                         "engine.glb",
                                         "duck.glb",
                                         "jeep.glb",
                                         "spider.stl",
                                         "penguin.obj",
                                         "spruce.obj",
                                         "aggressor.obj"),
                         [](const auto& value) {
                             return value.param.substr(0, value.param.find('.'));
                         });

}  // namespace
}  // namespace ink::harness
