#include <gtest/gtest.h>

#include <algorithm>

#include "edge/thin.h"
#include "import/import.h"
#include "score/score.h"
#include "tests/models/fetched_model.h"
#include "truth/model.h"
#include "truth/truth.h"

namespace ink::truth {
namespace {

/// A real model, three views of it, and whether what one sample a pixel shows, at its centre or at
/// its corner, agrees with the truth.
class RealModel : public testing::TestWithParam<const char*> {};

void expect_agrees(const Truth& truth, const edge::EdgeImage& sampled, double least_f) {
    const score::ScoreOptions options{.band_px = 6,
                                      .ignore_label = static_cast<int>(LineClass::ignore)};
    const auto scoring = score::prepare_truth(truth.labels, options, true);
    const score::Score score = score::score(sampled, scoring, options);
    EXPECT_GE(score.n_truth, 500);
    EXPECT_GE(score.f(), least_f);
    for (const score::ClassCount& c : score.classes) {
        // Creases of a fine scan are single edges far below a pixel: no sample sees them all.
        if (c.n_truth < 500 || c.label == static_cast<int>(LineClass::crease)) continue;
        EXPECT_GE(static_cast<double>(c.k) / static_cast<double>(c.n_truth), 0.98) << c.label;
    }
}

void expect_thin(const core::Image<std::uint8_t>& labels) {
    edge::Mask mask(labels.width_px(), labels.height_px());
    std::transform(labels.data(), labels.data() + labels.size(), mask.data(), [](std::uint8_t l) {
        return static_cast<std::uint8_t>(l != 0 &&
                                         l != static_cast<std::uint8_t>(LineClass::ignore));
    });
    EXPECT_EQ(edge::thin(mask), mask);
}

TEST_P(RealModel, SampledAgreesWithTheLabels) {
    const auto path = fetched_model(GetParam());
    INK_SKIP_WITHOUT(path);
    const scene::Scene scene = import::import_scene(path);
    const Model model = build_model(scene, {.threads = 2});
    const auto cameras = scene::orbit_cameras(scene::bounding_sphere(scene), 3, 1280.0 / 720.0);
    for (const scene::Camera& camera : cameras) {
        SCOPED_TRACE(camera.name);
        const Truth truth = trace_truth(model, {camera, 1280, 720}, {.threads = 2});
        expect_agrees(truth, truth.sampled, 0.95);
        expect_agrees(truth, truth.exact_corner, 0.97);
        expect_thin(truth.labels);
    }
}

INSTANTIATE_TEST_SUITE_P(Truth,
                         RealModel,
                         testing::Values("bunny_coarse.obj",
                                         "dragon.ply",
                                         "duck.glb",
                                         "gargoyle.obj",
                                         "spider.stl",
                                         "wuson.obj"),
                         [](const auto& test) {
                             const std::string file = test.param;
                             return file.substr(0, file.find('.'));
                         });

}  // namespace
}  // namespace ink::truth
