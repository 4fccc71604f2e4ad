// A study of one's own is one function that returns cells: it runs, shards, and stands on the page
// and in the figures without another line.

#include <gmock/gmock.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

#include "catalogue/shapes.h"
#include "core/whole_file.h"
#include "experiment/experiment_run.h"
#include "experiment/run_data.h"
#include "report/packed_run.h"
#include "report/run_page.h"
#include "tests/core/temp_folder.h"

namespace ink::experiment {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Boxes that grow longer.
std::vector<studies::Case> boxes_of(double length, const studies::CaseSize& size) {
    studies::Case one{"length", length, {}};
    scene::Scene& scene = one.scene_views.scene;
    scene.name = "box";
    scene.meshes.push_back(catalogue::make_box({-length, -1, -1}, {length, 1, 1}));
    scene.instances.push_back({});
    scene::Camera camera = scene::look_at({5, 4, 9}, glm::dvec3(0), {0, 1, 0}, 1);
    scene::fit_clip_range(camera, scene::bounding_sphere(scene));
    camera.name = "length=" + std::to_string(length);
    one.scene_views.views.push_back({camera, size.width_px, size.height_px});
    return {one};
}

TEST(OwnStudy, RunsShardsAndStandsOnThePageAndInTheFigures) {
    studies::Axis axis;
    axis.study = "boxes";
    axis.name = "length";
    axis.title = "length of a box";
    axis.values = {1, 2, 4};
    axis.sentence = "Boxes grow longer.";
    axis.cases = boxes_of;
    Experiment experiment;
    experiment.kind = ExperimentKind::stress;
    experiment.name = "boxes";
    experiment.methods = {"mote4", "ids"};
    experiment.sizes = {{96, 54}};
    experiment.stress.own_axes = {axis};
    const Plan plan = make_plan(experiment, {});
    const core::TempFolder folder;
    (void)run_experiment(plan, {.out = folder / "whole"});
    for (const int i : {1, 2})
        (void)run_experiment(plan, {.out = folder / std::to_string(i), .shard = {i, 2}});
    (void)merge_shards({folder / "1", folder / "2"}, folder / "merged");
    for (const char* name : {"rows.csv", "axes.csv", "axis_summary.csv"}) {
        const auto text = core::read_whole_file(folder / "whole" / name);
        EXPECT_THAT(text.value_or(""), HasSubstr("length")) << name;
        EXPECT_EQ(core::read_whole_file(folder / "merged" / name), text) << name;
    }
    const RunData run = read_run(folder / "whole");
    EXPECT_EQ(run.tables.on_axes.size(), 3U * (2 + harness::kBaselines));
    for (const studies::AxisRow& of : run.tables.on_axes)
        EXPECT_TRUE(of.row.reference_disagreement) << "the cross-check looks at it";
    const std::string page = report::run_page({run}).html;
    std::size_t count = 0;
    for (const auto& [name, table] : run.csv) {
        if (report::packed_columns(table).find("Boxes grow longer.") == std::string::npos) continue;
        EXPECT_THAT(page, HasSubstr(report::packed_table(table).dump())) << name;
        ++count;
    }
    EXPECT_EQ(count, 1U);
    const std::string python = "/usr/bin/python3 -B " INK_SOURCE_DIR "/notebooks/figures.py ";
    if (std::system("/usr/bin/python3 -c 'import matplotlib, pandas' 2> /dev/null") != 0)
        GTEST_SKIP() << "no matplotlib and pandas for python3: figures are not drawn";
    const std::string out = (folder / "figures").string();
    ASSERT_EQ(std::system((python + (folder / "whole").string() + " --only stress_losses --out " +
                           out + " > /dev/null")
                              .c_str()),
              0);
    EXPECT_THAT(core::read_whole_file(folder / "figures/figures.md").value_or(""),
                HasSubstr("length"));
}

}  // namespace
}  // namespace ink::experiment
