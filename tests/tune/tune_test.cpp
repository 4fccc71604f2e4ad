#include "tune/tune.h"
#include "methods/method_configs.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "core/whole_file.h"
#include "experiment/run_record.h"
#include "harness/cells/cell.h"
#include "methods/presets.h"
#include "tests/core/temp_folder.h"
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
    static std::vector<harness::SceneViews> scenes(const std::vector<std::string>& names) {
        return harness::load_scenes(names, small());
    }
    TuneOptions options(const std::string& method, const std::string& parameters) const {
        TuneOptions made;
        made.config = methods::make_configs(method, {}).front();
        made.parameters = parameters;
        made.plan = {.evaluations = 24, .seed = 7};
        made.out = folder_ / "out";
        made.is_forced = true;  // several searches in one test
        made.name = method + "_found";
        made.command = "inkbench tune " + method;
        made.threads = 2;
        return made;
    }
    std::string read(const std::string& name) const {
        const auto text = core::read_whole_file(folder_ / "out" / name);
        EXPECT_TRUE(text) << name;
        return text.value_or("");
    }
    const core::TempFolder folder_;
};

double error_of(const std::vector<score::CurveCount>& counts) {
    score::CurveCount sum;
    for (const score::CurveCount& count : counts)
        sum += count;
    return 1 - sum.f();
}

/// The same by the harness's own way to draw and score a cell.
double plain_error(const method::MethodConfig& config,
                   const std::vector<harness::SceneViews>& scenes) {
    score::CurveCount sum;
    for (const harness::SceneViews& scene_views : scenes) {
        truth::SceneModel model(scene_views.scene, {});
        harness::PreparedMethod prepared(config, scene_views.scene);
        for (const scene::View& view : scene_views.views) {
            const harness::ViewTruth truth = harness::trace_view(model, view, {});
            edge::EdgeImage image(view.width_px, view.height_px);
            prepared.method().draw({view, 1}, image);
            const score::Score s =
                score::score(image, truth.scoring, harness::score_options(prepared.threshold()));
            sum += {s.k, s.n_pred, s.n_truth};
        }
    }
    return 1 - sum.f();
}

TEST(TuneFinding, SaysWhatWasGainedWhereAndWhatToDo) {
    TuneOptions named;
    named.name = "mine";
    TuneResult result;
    result.defaults.train = {{900, 1000, 1000}};
    result.tuned.train = {{938, 1000, 1000}};
    const std::string found = "mine: F +.038 where it searched";
    EXPECT_EQ(tune_finding(result, named), found + "; what it does elsewhere is not known");
    result.heldout_scenes = {{"knight", scene::Split::real, "figure"}};
    result.defaults.heldout = {{955, 1000, 1000}};
    result.tuned.heldout = {{949, 1000, 1000}};
    EXPECT_EQ(tune_finding(result, named), found + ", -.006 on knight: do not ship");
    result.tuned.heldout = {{965, 1000, 1000}};
    EXPECT_EQ(tune_finding(result, named),
              found + ", +.010 on knight: better there, too, on too few scenes to be sure");
}

TEST_F(Tune, FindsNothingWorseThanTheDefaultsAndSaysWhatTheHarnessSays) {
    const TuneOptions with = options("mote4", "range_nz,threshold=1..64");
    const TuneResult result = tune(scenes({"cube", "layers", "gem"}), with);
    EXPECT_EQ(result.steps.size(), 24U);
    EXPECT_EQ(result.random_steps.size(), 24U);
    EXPECT_LE(result.tuned.found.value, result.defaults.found.value);
    EXPECT_EQ(result.train_views, 6U);
    EXPECT_EQ(result.heldout_views, 3U);
    for (const TunedSettings* each : {&result.defaults, &result.tuned}) {
        method::MethodConfig config = with.config;
        config.settings = each->settings;
        const double train = plain_error(config, scenes({"cube", "layers"}));
        EXPECT_EQ(each->found.error, train) << each->name;
        EXPECT_EQ(error_of(each->train), train) << each->name;
        EXPECT_EQ(error_of(each->heldout), plain_error(config, scenes({"gem"}))) << each->name;
    }
}

TEST_F(Tune, WritesEveryEvaluationAndAPresetThatReadsBack) {
    const TuneOptions with = options("decaudin", "k_normal=0.05..1,join");
    const TuneResult result = tune(scenes({"cube"}), with);
    const std::string csv = read("evaluations.csv");
    EXPECT_THAT(csv,
                testing::StartsWith(
                    "evaluation,phase,k_normal,join,e_train,drawn_by,draw_ms\n1,start,0.25,max,"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 24 + 24);
    EXPECT_FALSE(fs::exists(folder_ / "out" / "evaluations.csv.part"));

    const methods::Preset preset = methods::parse_preset(
        read("decaudin_found.toml"), "decaudin_found.toml", methods::registry());
    EXPECT_EQ(preset.name, "decaudin_found");
    EXPECT_EQ(preset.method, "decaudin");
    EXPECT_EQ(preset.settings, result.tuned.settings);
    EXPECT_EQ(preset.command, "inkbench tune decaudin");
    EXPECT_EQ(methods::preset_config(folder_ / "out" / "decaudin_found.toml")
                  .info->complete({})
                  .at("join"),
              result.tuned.settings.at("join"));
}

TEST_F(Tune, ThreadsChangeNothing) {
    TuneOptions with = options("mote4", "");
    (void)tune(scenes({"cube", "layers", "gem"}), with);
    const std::string csv = read("evaluations.csv");
    const std::string toml = read("mote4_found.toml");
    with.threads = 1;
    (void)tune(scenes({"cube", "layers", "gem"}), with);
    EXPECT_EQ(read("evaluations.csv"), csv);
    EXPECT_EQ(read("mote4_found.toml"), toml);
}

TEST_F(Tune, AFinishedSearchLeavesNoLogAndGivesTheSameBytesAgain) {
    const TuneOptions with = options("mote4", "");
    (void)tune(scenes({"cube"}), with);
    const std::string csv = read("evaluations.csv");
    const std::string toml = read("mote4_found.toml");
    const TuneResult result = tune(scenes({"cube"}), with);
    EXPECT_EQ(result.resumed, 0U);
    EXPECT_EQ(read("evaluations.csv"), csv);
    EXPECT_EQ(read("mote4_found.toml"), toml);
}

TEST_F(Tune, ATimeBudgetThatNothingMeetsIsSaid) {
    TuneOptions with = options("mote4", "threshold");
    with.budget_ms = 1e-9;
    with.random = false;
    with.plan.evaluations = 3;
    const TuneResult result = tune(scenes({"cube"}), with);
    EXPECT_GT(result.tuned.found.value, 1);
    ASSERT_TRUE(result.tuned.found.draw_ms);
    EXPECT_THAT(tune_summary(result, with), HasSubstr("no setting keeps within"));
}

TEST_F(Tune, WithoutHeldOutScenesOneViewIsLeftOutAtATime) {
    TuneOptions with = options("mote4", "");
    with.random = false;
    const TuneResult alone = tune(scenes({"cube"}), with);
    ASSERT_EQ(alone.left_out.size(), 3U);
    EXPECT_GE(error_of(alone.left_out), alone.tuned.found.error);
    EXPECT_THAT(tune_finding(alone, with), HasSubstr(" on what was left out in turns: "));
    EXPECT_THAT(tune_summary(alone, with), HasSubstr("one view left out at a time: E 0."));
    EXPECT_THAT(read("mote4_found.toml"), HasSubstr("e_left_out = "));
    EXPECT_TRUE(tune(scenes({"cube", "gem"}), with).left_out.empty());
}

TEST_F(Tune, ByKindOneKindIsLeftOutAtATimeBesideHeldOutScenes) {
    TuneOptions with = options("mote4", "threshold");
    with.objective = TuneObjective::kinds;
    with.random = false;
    with.plan.evaluations = 6;
    const TuneResult found = tune(scenes({"cube", "gear", "gem"}), with);
    EXPECT_EQ(found.left_out.size(), found.train_views);
    EXPECT_THAT(tune_summary(found, with), HasSubstr("one kind left out at a time: E 0."));
    EXPECT_THAT(read("mote4_found.toml"), HasSubstr("objective = \"kinds\""));
}

TEST_F(Tune, ModelsOfTheUserAreSearchedUnlessTheyAreUnseen) {
    const fs::path model = folder_ / "roof.obj";
    std::ofstream(model) << "v 0 0 0\nv 1 0 0\nv 0 1 1\nv 1 1 1\nv 0 2 0\nv 1 2 0\n"
                            "f 1 2 4 3\nf 3 4 6 5\n";
    TuneOptions with = options("mote4", "threshold");
    with.random = false;
    with.plan.evaluations = 8;
    const TuneResult alone = tune(scenes({model.string()}), with);
    ASSERT_EQ(alone.train_scenes.size(), 1U);
    EXPECT_EQ(alone.train_scenes[0].name, "roof");
    EXPECT_EQ(alone.left_out.size(), 3U);
    with.unseen = {"roof"};
    const TuneResult beside = tune(scenes({"cube", model.string()}), with);
    ASSERT_EQ(beside.train_scenes.size(), 1U);
    EXPECT_EQ(beside.train_scenes[0].name, "cube");
    EXPECT_EQ(beside.train_scenes[0].kind, "shape");
    ASSERT_EQ(beside.heldout_scenes.size(), 1U);
    EXPECT_EQ(beside.heldout_scenes[0].name, "roof");
    EXPECT_EQ(beside.heldout_scenes[0].split, scene::Split::real);
    EXPECT_TRUE(beside.left_out.empty());
    fs::remove(model);
}

TEST_F(Tune, ItsRecordSaysWhatOfModelsDoesNotCount) {
    std::vector<harness::SceneViews> models = scenes({"cube", "torus"});
    models[1].scene.file.notes = {"a lamp"};
    TuneOptions with = options("mote4", "threshold=1..64");
    with.plan.evaluations = 4;
    (void)tune(models, with);
    const auto record = experiment::read_record(with.out);
    ASSERT_TRUE(record);
    EXPECT_EQ(record->state, experiment::RunState::finished);
    EXPECT_EQ(record->models, (std::vector<experiment::ModelFacts>{{"torus", {}, {"a lamp"}}}));
}

TEST_F(Tune, BadWishesAreRefused) {
    EXPECT_THROW((void)tune(scenes({"gem"}), options("mote4", "")), core::Error)
        << "no training scene";
    TuneOptions fixed = options("mote4", "threshold");
    fixed.config = methods::make_configs("mote4", {"threshold=9"}).front();
    EXPECT_THROW((void)tune(scenes({"cube"}), fixed), core::Error) << "fixed and tuned";
}

TEST(TuneBenchTest, KeptImagesScoreAsFreshOnes) {
    const auto scenes = harness::load_scenes({"cube", "layers"}, small());
    TuneBench bench(scenes, {}, 2);
    method::MethodConfig config = methods::make_configs("mote4", {}).front();
    for (const char* range : {"63", "40", "63", "20", "40"}) {
        for (const char* threshold : {"6", "30"}) {
            config.settings = {{"range_nz", range}, {"threshold", threshold}};
            EXPECT_EQ(error_of(bench.counts(config)), plain_error(config, scenes))
                << range << " " << threshold;
        }
    }
}

TEST_F(Tune, WhatWasBestWhenItCameIsTheMethodsOwnAndTheRestIsDrawnFromPlanes) {
    TuneOptions with = options("mote4", "range_depth,range_nz,threshold=1..64");
    with.plan.evaluations = 40;
    const TuneResult result = tune(scenes({"cube", "torus"}), with);
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
    EXPECT_THAT(tune_summary(result, with), HasSubstr("evaluations took a short cut"));
}

TEST_F(Tune, OtherCodesAreDrawnByTheirMethod) {
    for (const char* parameters : {"crease_deg", "depth_encoding,sky"}) {
        const TuneResult result = tune(scenes({"cube"}), options("mote4", parameters));
        EXPECT_EQ(result.agreement.has_value(), parameters != std::string("crease_deg"))
            << parameters;
    }
    EXPECT_FALSE(tune(scenes({"cube"}), options("decaudin", "")).agreement);
}

TEST(PresetFile, SpellsValuesAsTomlDoes) {
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
