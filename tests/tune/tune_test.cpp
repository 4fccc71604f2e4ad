#include "tune/tune.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "harness/cell.h"
#include "methods/preset.h"
#include "methods/presets.h"
#include "tune/tune_bench.h"
#include "tune/tune_report.h"

namespace ink::tune {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

harness::ViewRequest small() {
    harness::ViewRequest request;
    request.width_px = 160;
    request.height_px = 90;
    return request;
}

class Tune : public testing::Test {
  protected:
    void SetUp() override { fs::remove_all(out_); }
    void TearDown() override { fs::remove_all(out_); }

    static std::vector<harness::Subject> subjects(const std::vector<std::string>& names) {
        return harness::load_subjects(names, small());
    }
    TuneOptions options(const std::string& method, const std::string& knobs) const {
        TuneOptions made;
        made.entrant = harness::make_entrants(method, {}).front();
        made.knobs = knobs;
        made.plan = {.evaluations = 24, .seed = 7};
        made.out = out_;
        made.name = method + "_found";
        made.command = "inkbench tune " + method;
        made.threads = 2;
        return made;
    }
    std::string read(const std::string& name) const {
        std::ifstream file(out_ / name, std::ios::binary);
        EXPECT_TRUE(file.is_open()) << name;
        return {std::istreambuf_iterator<char>(file), {}};
    }
    /// Of each test its own: they run side by side.
    const fs::path out_ =
        fs::path(testing::TempDir()) /
        (std::string("tune_test_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

double error_of(const std::vector<score::CurveCount>& counts) {
    score::CurveCount sum;
    for (const score::CurveCount& count : counts)
        sum += count;
    return 1 - sum.f();
}

/// The same by the harness's own way to draw and score a cell.
double plain_error(const harness::Entrant& entrant, const std::vector<harness::Subject>& subjects) {
    score::CurveCount sum;
    for (const harness::Subject& subject : subjects) {
        truth::SceneModel model(subject.scene, {});
        harness::PreparedMethod prepared(entrant, subject.scene);
        for (const scene::View& view : subject.views) {
            const harness::ViewTruth truth = harness::trace_view(model, view, {});
            edge::EdgeImage picture(view.width_px, view.height_px);
            prepared.method().draw({view, 1}, picture);
            const score::Score s =
                score::score(picture, truth.scoring, harness::score_options(prepared.threshold()));
            sum += {s.k, s.n_pred, s.n_truth};
        }
    }
    return 1 - sum.f();
}

TEST_F(Tune, FindsNothingWorseThanTheDefaultsAndSaysWhatTheHarnessSays) {
    const TuneOptions with = options("mote4", "range_nz,threshold=1..64");
    const TuneResult result = tune(subjects({"cube", "layers", "gem"}), with);
    EXPECT_EQ(result.steps.size(), 24U);
    EXPECT_EQ(result.random_steps.size(), 24U);
    EXPECT_LE(result.tuned.found.value, result.defaults.found.value);
    EXPECT_EQ(result.train_views, 6U);
    EXPECT_EQ(result.heldout_views, 3U);
    for (const TunedSettings* each : {&result.defaults, &result.tuned}) {
        harness::Entrant entrant = with.entrant;
        entrant.settings = each->settings;
        const double train = plain_error(entrant, subjects({"cube", "layers"}));
        EXPECT_EQ(each->found.error, train) << each->name;
        EXPECT_EQ(error_of(each->train), train) << each->name;
        EXPECT_EQ(error_of(each->heldout), plain_error(entrant, subjects({"gem"}))) << each->name;
    }
}

TEST_F(Tune, WritesEveryEvaluationAndAPresetThatReadsBack) {
    const TuneOptions with = options("decaudin", "k_normal=0.05..1,join");
    const TuneResult result = tune(subjects({"cube"}), with);
    const std::string csv = read("evaluations.csv");
    EXPECT_THAT(
        csv,
        testing::StartsWith("evaluation,phase,k_normal,join,e_train,drawn_by\n1,start,0.25,max,"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 24 + 24);
    EXPECT_FALSE(fs::exists(out_ / "evaluations.csv.part"));

    const methods::Preset preset = methods::parse_preset(
        read("decaudin_found.toml"), "decaudin_found.toml", methods::registry());
    EXPECT_EQ(preset.name, "decaudin_found");
    EXPECT_EQ(preset.method, "decaudin");
    EXPECT_EQ(preset.settings, result.tuned.settings);
    EXPECT_EQ(preset.command, "inkbench tune decaudin");
    EXPECT_EQ(harness::preset_entrant(out_ / "decaudin_found.toml").info->complete({}).at("join"),
              result.tuned.settings.at("join"));
}

TEST_F(Tune, ThreadsChangeNothing) {
    TuneOptions with = options("mote4", "");
    (void)tune(subjects({"cube", "layers", "gem"}), with);
    const std::string csv = read("evaluations.csv");
    const std::string toml = read("mote4_found.toml");
    with.threads = 1;
    (void)tune(subjects({"cube", "layers", "gem"}), with);
    EXPECT_EQ(read("evaluations.csv"), csv);
    EXPECT_EQ(read("mote4_found.toml"), toml);
}

TEST_F(Tune, AFinishedSearchLeavesNoLogAndGivesTheSameBytesAgain) {
    const TuneOptions with = options("mote4", "");
    (void)tune(subjects({"cube"}), with);
    const std::string csv = read("evaluations.csv");
    const std::string toml = read("mote4_found.toml");
    const TuneResult result = tune(subjects({"cube"}), with);
    EXPECT_EQ(result.resumed, 0U);
    EXPECT_EQ(read("evaluations.csv"), csv);
    EXPECT_EQ(read("mote4_found.toml"), toml);
}

TEST_F(Tune, AveragePrecisionIsTunedWithoutAThresholdAndGetsTheBestOne) {
    TuneOptions with = options("mote4", "range_depth,range_nz");
    with.objective = TuneObjective::ap;
    with.random = false;
    with.plan.evaluations = 8;
    const TuneResult result = tune(subjects({"cube"}), with);
    EXPECT_EQ(result.random_steps.size(), 0U);
    ASSERT_EQ(result.tuned.settings.count("threshold"), 1U);
    harness::Entrant entrant = with.entrant;
    entrant.settings = result.tuned.settings;
    const double at_best = plain_error(entrant, subjects({"cube"}));
    for (const char* threshold : {"4", "8", "16", "32"}) {
        entrant.settings["threshold"] = threshold;
        EXPECT_LE(at_best, plain_error(entrant, subjects({"cube"})) + 1e-12) << threshold;
    }
    with.knobs = "threshold";
    EXPECT_THROW((void)tune(subjects({"cube"}), with), core::Error);
}

TEST_F(Tune, ATimeBudgetThatNothingMeetsIsSaid) {
    TuneOptions with = options("mote4", "threshold");
    with.budget_ms = 1e-9;
    with.random = false;
    with.plan.evaluations = 3;
    const TuneResult result = tune(subjects({"cube"}), with);
    EXPECT_GT(result.tuned.found.value, 1);
    ASSERT_TRUE(result.tuned.found.draw_ms);
    EXPECT_THAT(tune_summary(result, with), HasSubstr("none of the settings keeps within"));
}

TEST_F(Tune, BadWishesAreRefused) {
    EXPECT_THROW((void)tune(subjects({"gem"}), options("mote4", "")), core::Error)
        << "no training scene";
    TuneOptions fixed = options("mote4", "threshold");
    fixed.entrant = harness::make_entrants("mote4", {"threshold=9"}).front();
    EXPECT_THROW((void)tune(subjects({"cube"}), fixed), core::Error) << "fixed and tuned";
}

TEST(ScenesError, IsTheSquareOfTheMeanRoot) {
    EXPECT_EQ(scenes_error({}), 0);
    // Errors of .36 and .04, whatever their pixels: (.6 + .2) / 2 squared.
    EXPECT_NEAR(scenes_error({{64, 100, 100}, {9600, 10000, 10000}}), 0.16, 1e-12);
}

TEST(TuneBenchTest, KeptPicturesScoreAsFreshOnes) {
    const auto subjects = harness::load_subjects({"cube", "layers"}, small());
    TuneBench bench(subjects, {}, 2);
    harness::Entrant entrant = harness::make_entrants("mote4", {}).front();
    for (const char* range : {"63", "40", "63", "20", "40"}) {
        for (const char* threshold : {"6", "30"}) {
            entrant.settings = {{"range_nz", range}, {"threshold", threshold}};
            EXPECT_EQ(error_of(bench.counts(entrant)), plain_error(entrant, subjects))
                << range << " " << threshold;
        }
    }
}

TEST_F(Tune, WhatWasBestWhenItCameIsTheMethodsOwnAndTheRestIsDrawnFromPlanes) {
    TuneOptions with = options("mote4", "range_depth,range_nz,threshold=1..64");
    with.plan.evaluations = 40;
    const TuneResult result = tune(subjects({"cube", "torus"}), with);
    double best = 2;
    int by_planes = 0;
    for (const TuneStep& step : result.steps) {
        by_planes += step.found.is_by_planes;
        if (step.found.value < best) {
            EXPECT_FALSE(step.found.is_by_planes);
            best = step.found.value;
        }
    }
    EXPECT_GT(by_planes, 20);
    EXPECT_EQ(result.tuned.found.value, best);
    ASSERT_TRUE(result.agreement);
    EXPECT_EQ(result.agreement->total_px, 6 * 160 * 90);
    EXPECT_LE(result.agreement->differ_px, 6 * 160 * 90 / 500);
    EXPECT_NEAR(error_of(result.agreement->by_planes), error_of(result.tuned.train), 0.01);
    EXPECT_THAT(tune_summary(result, with), HasSubstr("drawn from planes: "));
}

TEST_F(Tune, OtherCodesAreDrawnByTheirMethod) {
    for (const char* knobs : {"crease_deg", "depth_encoding,sky"}) {
        const TuneResult result = tune(subjects({"cube"}), options("mote4", knobs));
        EXPECT_EQ(result.agreement.has_value(), knobs != std::string("crease_deg")) << knobs;
    }
    EXPECT_FALSE(tune(subjects({"cube"}), options("decaudin", "")).agreement);
}

TEST(methods::PresetFile, SpellsValuesAsTomlDoes) {
    const methods::PresetFile file{
        "mine",
        &methods::find_method("mote4"),
        {{"threshold", "7"}, {"range_nx", "80.5"}, {"normals", "facet"}},
        {{"command", methods::toml_text("say \"no\" \\ \n")}, {"seed", "3"}}};
    EXPECT_EQ(methods::preset_toml(file),
              "name = \"mine\"\nmethod = \"mote4\"\n\n[settings]\nrange_nx = 80.5\n"
              "normals = \"facet\"\nthreshold = 7\n\n[provenance]\n"
              "command = \"say \\\"no\\\" \\\\ \\u000a\"\nseed = 3\n");
}

}  // namespace
}  // namespace ink::tune
