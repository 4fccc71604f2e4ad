#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "core/error.h"
#include "core/named.h"
#include "experiment/experiment.h"
#include "experiment/experiment_plan.h"
#include "experiment/options/option_table.h"
#include "tests/core/error_text.h"

namespace ink::experiment {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Experiment parse(const std::string& text) {
    return parse_experiment(text, "e.toml");
}

/// What the error says; "" if there is none.
std::string error_of(const std::string& text) {
    return core::error_text([&] { return parse(text); });
}

constexpr const char* kHead = "name = \"e\"\nkind = \"compare\"\n";  // two lines

TEST(ExperimentFile, ReadsEveryKey) {
    const Experiment e = parse(R"(name = "e"
kind = "compare"
seed = 7
[grid]
scenes = ["cube", "torus"]
views = 2
methods = ["mote4", "ids"]
sizes = ["64x36", "128x72"]
threads = [1, 2]
[measure]
repetitions = 4
budget_ms = 10
full_scores = false
crosscheck = false
entrant_seconds = 90
times = false
crease_deg = 50
intersections = "all"
[answer]
f_margin = 0.02
budget_ms = 3
[settings]
crease_deg = 30
[settings.mote4]
packing = "pixel"
[sweep]
own_views = 1
[sweep.mote4]
threshold = [3, 6]
fatten = [true, false]
)");
    EXPECT_EQ(e.name, "e");
    EXPECT_EQ(e.seed, 7U);
    EXPECT_THAT(e.scenes, ElementsAre("cube", "torus"));
    EXPECT_EQ(e.compare.views, 2);
    EXPECT_THAT(e.methods, ElementsAre("mote4", "ids"));
    ASSERT_EQ(e.sizes.size(), 2U);
    EXPECT_EQ(e.sizes[1].width_px, 128);
    EXPECT_EQ(e.sizes[1].height_px, 72);
    EXPECT_THAT(e.threads, ElementsAre(1, 2));
    EXPECT_EQ(e.repetitions, 4);
    EXPECT_DOUBLE_EQ(e.budget_ms, 10);
    EXPECT_EQ(e.compare.entrant_s, 90);
    EXPECT_EQ(e.compare.answer, (summary::AnswerRule{0.02, 3}));
    EXPECT_FALSE(e.compare.full_scores || e.crosscheck || e.times);
    EXPECT_THAT(e.settings, ElementsAre("crease_deg=30", "mote4.packing=pixel"));
    EXPECT_EQ(e.crease_deg, 50);
    EXPECT_EQ(e.intersections, score::Intersections::all);
    EXPECT_EQ(e.compare.own_sweep_views, 1);
    ASSERT_EQ(e.compare.grids.size(), 1U);
    EXPECT_EQ(grid_configs(configs_of(e).front(), e.compare.grids.front()).size(), 4U);
    const auto configs = configs_of(e);
    EXPECT_EQ(configs[0].settings.at("packing"), "pixel");
    EXPECT_EQ(configs[1].settings.at("crease_deg"), "30");
    EXPECT_FALSE(configs[1].settings.contains("packing"));
}

TEST(ExperimentFile, WithoutAGridIsEveryMethodOnTheCatalogue) {
    const Experiment e = parse(kHead);
    EXPECT_EQ(e.scenes, scenes_called("catalogue"));
    EXPECT_EQ(e.methods.size(), configs_of(e).size());
    EXPECT_GT(e.methods.size(), 10U);
    EXPECT_EQ(scenes_called("train").size() + scenes_called("heldout").size(), e.scenes.size());
}

TEST(ExperimentFile, NamesFileLineKeyAndWhatIsAccepted) {
    const auto of = [](const std::string& more) { return error_of(kHead + more); };
    EXPECT_THAT(
        of("[grid]\nscene = [\"cube\"]\n"),
        testing::AllOf(HasSubstr("e.toml:4"), HasSubstr("grid.scene"), HasSubstr("scenes")));
    EXPECT_THAT(of("[grid]\nscenes = [\n\"cube\",\n\"cub\"]\n"),
                testing::AllOf(HasSubstr("e.toml:6"), HasSubstr("'cub'"), HasSubstr("cube")));
    EXPECT_THAT(
        of("[grid]\nviews = \"two\"\n"),
        testing::AllOf(
            HasSubstr("e.toml:4"), HasSubstr("grid.views"), HasSubstr("two"), HasSubstr("1..360")));
    EXPECT_THAT(of("[grid]\nmethods = [\"mote5\"]\n"),
                testing::AllOf(HasSubstr("e.toml:4"), HasSubstr("mote5"), HasSubstr("mote4")));
    EXPECT_THAT(
        of("[grid]\nsizes = [\"64\"]\n"),
        testing::AllOf(HasSubstr("e.toml:4"), HasSubstr("'64'"), HasSubstr("WIDTHxHEIGHT")));
    EXPECT_THAT(of("[grid]\nthreads = [0]\n"),
                testing::AllOf(HasSubstr("e.toml:4"), HasSubstr("1..256")));
    EXPECT_THAT(
        of("[measure]\ncrosscheck = 1\n"),
        testing::AllOf(
            HasSubstr("e.toml:4"), HasSubstr("measure.crosscheck"), HasSubstr("true | false")));
    EXPECT_THAT(of("[settings]\nthreshold = 999\n"),
                testing::AllOf(HasSubstr("e.toml:4"), HasSubstr("999"), HasSubstr("1..255")));
    EXPECT_THAT(of("[sweep.mote4]\nrange_dept = [1, 2]\n"),
                testing::AllOf(HasSubstr("e.toml:4"), HasSubstr("range_depth")));
    EXPECT_THAT(of("[sweep.mote4]\nthreshold = []\n"),
                testing::AllOf(HasSubstr("e.toml:4"), HasSubstr("empty")));
    EXPECT_THAT(of("[sweep.mote5]\nthreshold = [1]\n"), HasSubstr("mote5"));
    EXPECT_THAT(of("[gird]\n"), testing::AllOf(HasSubstr("e.toml:3"), HasSubstr("grid")));
    EXPECT_THAT(of("grid = 3\n"), testing::AllOf(HasSubstr("e.toml:3"), HasSubstr("[grid]")));
    EXPECT_THAT(of("a = = 3\n"), testing::AllOf(HasSubstr("e.toml:3"), HasSubstr("no TOML")));
    EXPECT_THAT(error_of("name = \"e\"\nkind = \"compar\"\n"),
                testing::AllOf(HasSubstr("e.toml:2"), HasSubstr("compare | stress | animation")));
    EXPECT_THAT(error_of("kind = \"compare\"\n"), HasSubstr("there is no name"));
    EXPECT_THAT(error_of("name = \"../x\"\nkind = \"compare\"\n"), HasSubstr("e.toml:1"));
    EXPECT_THAT(error_of("name = \"e\"\nkind = \"stress\"\n[grid]\nscenes = [\"cube\"]\n"),
                testing::AllOf(HasSubstr("e.toml:4"), HasSubstr("axes")));
}

TEST(ExperimentFile, CommandLineReplacesSizeScenesMethodsAndViews) {
    Experiment e = parse(std::string(kHead) +
                         "[settings.mote4]\nthreshold = 9\n[sweep.mote4]\nthreshold = [3, 6]\n"
                         "[sweep.ids]\ncrease_deg = [20, 40]\n");
    set_option(e, "grid.sizes", {{"80x45", "--size"}});
    set_option(e, "grid.scenes", {{"cube", "--scenes"}});
    set_option(e, "grid.methods", {{"ids", "--methods"}});
    set_option(e, "grid.views", {{"1", "--views"}});
    EXPECT_EQ(e.sizes.front().width_px, 80);
    EXPECT_THAT(e.scenes, ElementsAre("cube"));
    EXPECT_THAT(e.methods, ElementsAre("ids"));
    ASSERT_EQ(e.compare.grids.size(), 1U);
    EXPECT_EQ(e.compare.grids.front().method, "ids");
    EXPECT_EQ(e.compare.views, 1);
    EXPECT_EQ(configs_of(e).size(), 1U);
    EXPECT_THROW(set_option(e, "grid.sizes", {{"80", "--size"}}), core::Error);
    EXPECT_THROW(set_option(e, "grid.axes", {{"origin", "--axes"}}), core::Error)
        << "a comparison has no axes";
}

TEST(ExperimentFile, EachAntialiasIsAMethodOfItsOwn) {
    const Experiment e =
        parse(std::string(kHead) +
              "[grid]\nantialias = [\"none\", \"resolve16\"]\n[measure]\ncoverage = true\n");
    EXPECT_TRUE(e.coverage);
    std::vector<std::string> names;
    for (const method::MethodConfig& config : configs_of(e))
        names.push_back(config.info->name);
    Experiment plain = e;
    plain.antialias = {methods::Antialias::none};
    const std::size_t half = configs_of(plain).size();
    // Those that draw ink are grey already.
    std::vector<std::string> expected(names.begin(), names.begin() + std::ptrdiff_t(half));
    for (std::size_t i = 0; i < half; ++i)
        if (names[i] != "strokes" && names[i] != "chords")
            expected.push_back(names[i] + "_resolve16");
    EXPECT_EQ(names, expected);
    const auto of = [](const std::string& more) { return error_of(std::string(kHead) + more); };
    EXPECT_THAT(of("[grid]\nantialias = [\"resolve9\"]\n"),
                testing::AllOf(HasSubstr("resolve9"), HasSubstr("none, resolve4, resolve16")));
    EXPECT_THAT(of("[grid]\nantialias = [\"none\", \"none\"]\n"), HasSubstr("twice"));
    EXPECT_THAT(of("[measure]\nline_width_px = 5\n"), HasSubstr("0.25..4"));
    Experiment large = e;
    large.sizes = {{8000, 90}};
    EXPECT_THROW((void)make_plan(large, {}), core::Error);
}

TEST(ExperimentFile, InkIsAsWideAsTheTrueLinesItIsComparedWith) {
    const auto width_of = [](const std::string& more) {
        const Experiment e =
            parse(std::string(kHead) + "[grid]\nmethods = [\"strokes\", \"ids\"]\n" + more);
        const auto settings = configs_of(e).front().settings;
        const auto width = settings.find("width_px");
        return width == settings.end() ? "" : width->second;
    };
    EXPECT_EQ(width_of(""), "1.5") << "who names ink is scored by ink";
    EXPECT_EQ(width_of("[measure]\ncoverage = true\nline_width_px = 2.5\n"), "2.5");
    EXPECT_EQ(width_of("[measure]\ncoverage = true\n[settings]\nstrokes.width_px = 3\n"), "3");
    EXPECT_FALSE(parse(kHead).coverage) << "all methods are not named";
}

/// A value of every option as text: its least for a number, its last word for a choice.
std::string some_value(const core::Param& param) {
    if (param.name == "seed" || param.name == "grid.threads") return "7";
    if (param.name == "grid.sizes") return "64x36";
    if (param.name == "grid.scenes") return "cube";
    if (param.name == "grid.methods") return "ids";
    if (param.name == "grid.entrants") return "mine=/tmp";
    if (param.name == "grid.model_list") return INK_SOURCE_DIR "/experiments/models.toml";
    if (param.name == "views.up") return "z";
    if (param.name == "views.fit") return "box";
    if (param.name == "views.directions") return "top";
    if (param.is_number() && std::isinf(param.min)) return "0.5";
    if (param.kind == core::ParamKind::list)
        return param.choices.empty() ? "a" : param.choices.front();
    if (param.kind == core::ParamKind::flag) return "true";
    return core::format_param(
        param, param.kind == core::ParamKind::choice ? param.max : std::ceil(param.min));
}

TEST(OptionTable, HoldsAndRecordsWhatEveryOptionIsGiven) {
    const OptionTable& table = option_table();
    for (std::size_t row = 0; row < table.options.size(); ++row) {
        const core::Param& param = table.param(row);
        for (const ExperimentKind kind :
             {ExperimentKind::compare, ExperimentKind::stress, ExperimentKind::animation}) {
            Experiment e;
            e.kind = kind;
            e.sizes = {{640, 360}};
            e.view_request.directions = {scene::drawing_views().front()};  // in which is an up
            if (!table.has_kind(row, kind)) continue;
            set_option(e, param.name, {{some_value(param), "here"}});
            EXPECT_THAT(table.rows.get(e, row), ElementsAre(some_value(param))) << param.name;
            if (param.name == "grid.presets" || param.name == "grid.entrants") continue;
            const std::string key = param.name.substr(param.name.find('.') + 1);
            EXPECT_THAT(asked_text(e), HasSubstr(key + " = ")) << param.name;
        }
        EXPECT_FALSE(param.doc.empty()) << param.name;
    }
}

TEST(ExperimentFile, AsksForCamerasAndOptionsOfViews) {
    const auto of = [](const std::string& more) {
        return parse(std::string(kHead) + "[views]\n" + more).view_request;
    };
    const harness::ViewRequest own =
        of("cameras = [{eye = [3, 2, 5], target = [0.1, 0, 0], up = [0, 0, 1], fov_deg = 30},\n"
           "{eye = [1, 2, 6], parallel_height = 2.5}]\ntime_s = 0.25\n");
    ASSERT_EQ(own.cameras.size(), 2U);
    EXPECT_EQ(own.cameras[0].target_world, glm::dvec3(0.1, 0, 0));
    EXPECT_EQ(own.cameras[0].fov_deg, 30);
    EXPECT_EQ(own.cameras[0].up_world, glm::dvec3(0, 0, 1));
    EXPECT_EQ(own.cameras[1].height_world, 2.5);
    EXPECT_EQ(own.cameras[1].target_world, std::nullopt);
    EXPECT_EQ(own.time_s, 0.25);
    const harness::ViewRequest named =
        of("directions = [\"top\", \"iso\"]\nup = \"z\"\nfit = \"box\"\nmargin = 0\n");
    EXPECT_EQ(core::names_of(named.directions), (std::vector<std::string>{"top", "iso"}));
    EXPECT_EQ(named.up, harness::UpAxis::z);
    EXPECT_EQ(named.fit, harness::Fit::box);
    EXPECT_EQ(named.margin, 0);
    EXPECT_EQ(of("orbit = 3\n").orbit_count, 3);
    EXPECT_TRUE(of("file_cameras = true\n").file_cameras);
    EXPECT_EQ(of("parallel_height = 3\n").projections,
              std::vector{scene::ProjectionKind::parallel});
    for (const auto& [wrong, part] :
         {std::pair{"margin = 0.1", "no --fit box"},
          {"margin = 0.5", "0..0.45"},
          {"up = \"z\"", "no view by name"},
          {"time_s = 1\nframe = 2", "one of the two"},
          {"fit = \"box\"\norbit = 1\nframe = 1.5", "views.frame"},
          {"cameras = [{target = [0, 0, 0]}]", "has no eye"},
          {"cameras = [{eye = [0, 0]}]", "[X, Y, Z]"},
          {"cameras = [{eye = [1, 0, 0], fov = 1}]", "fov_deg"},
          {"cameras = [{eye = [1, 0, 0], fov_deg = 400}]", "1..170"},
          {"cameras = [{eye = [1, 0, 0], parallel_height = 0}]", "above 0"}}) {
        const std::string error = error_of(std::string(kHead) + "[views]\n" + wrong);
        EXPECT_THAT(error, testing::AllOf(testing::StartsWith("e.toml:"), HasSubstr(part)));
    }
    EXPECT_THAT(error_of("name = \"e\"\nkind = \"stress\"\n[views]\ncameras = []\n"),
                HasSubstr("no key views.cameras"));
}

TEST(ExperimentFiles, ThatAreShippedAllHaveCells) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(INK_SOURCE_DIR "/experiments")) {
        if (entry.path().extension() != ".toml") continue;
        // A list of models, experiments on them, which must be fetched, and those whose entrants
        // are looked for from the top of the checkout.
        const std::string stem = entry.path().stem().string();
        constexpr std::array kLeftOut{"models", "real", "outside", "webgl"};
        if (std::find(kLeftOut.begin(), kLeftOut.end(), stem) != kLeftOut.end()) continue;
        ++files;
        const Experiment e = read_experiment(entry.path());
        EXPECT_EQ(e.name, entry.path().stem().string());
        const Plan plan = make_plan(e, {});
        EXPECT_GT(plan.cells(), 0) << entry.path();
        double work_s = 0;
        for (const Block& block : plan.blocks) {
            EXPECT_GT(block.cells, 0) << block.key;
            work_s += block.work;
        }
        EXPECT_LT(work_s, 1800) << entry.path();
    }
    EXPECT_EQ(files, 9);
}

}  // namespace
}  // namespace ink::experiment
