#include "experiment/view_bench.h"

#include <gtest/gtest.h>

namespace ink::experiment {
namespace {

Experiment one_cube(std::vector<std::string> methods) {
    Experiment experiment;
    experiment.where = "test";
    experiment.name = "bench";
    experiment.methods = std::move(methods);
    experiment.scenes = {"cube"};
    experiment.sizes = {{160, 90}};
    experiment.compare.views = 1;
    experiment.times = false;
    return experiment;
}

std::vector<edge::EdgeImage> images_of(ViewBench& bench, const harness::PreparedMethods& methods) {
    std::vector<edge::EdgeImage> images;
    for (harness::Evaluation& evaluation : harness::method_evaluations(
             methods, bench.view(0, {160, 90}, 0), bench.cell_options(1).measure))
        images.push_back(std::move(evaluation.image));
    return images;
}

TEST(ViewBench, MakesReadyAgainWhatWasReleased) {
    ViewBench bench(one_cube({"mote4", "mote16", "ids", "mote2"}), {});
    const harness::PreparedMethod* first = bench.methods(0, 0)->front().get();
    EXPECT_EQ(bench.methods(0, 0)->front().get(), first);
    const auto expected = images_of(bench, *bench.prepared(bench.configs(), 0));
    bench.release(0);
    EXPECT_EQ(images_of(bench, *bench.prepared(bench.configs(), 0)), expected);
    EXPECT_EQ(bench.methods(0, 0)->size(), 4U);
}

}  // namespace
}  // namespace ink::experiment
