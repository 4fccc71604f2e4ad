#include "experiment/view_bench.h"

#include <gtest/gtest.h>

namespace ink::experiment {
namespace {

using Methods = std::vector<std::unique_ptr<harness::PreparedMethod>>;

Experiment one_cube(std::vector<std::string> methods) {
    Experiment experiment;
    experiment.where = "test";
    experiment.name = "bench";
    experiment.methods = std::move(methods);
    experiment.scenes = {"cube"};
    experiment.sizes = {{160, 90}};
    experiment.views = 1;
    experiment.times = false;
    return experiment;
}

std::vector<edge::EdgeImage> images_of(ViewBench& bench, Methods methods) {
    std::vector<edge::EdgeImage> images;
    for (harness::Evaluation& evaluation : harness::method_evaluations(
             methods, bench.view(0, {160, 90}, 0), bench.cell_options(1).measure))
        images.push_back(std::move(evaluation.image));
    return images;
}

std::vector<bool> has_taken(const Methods& methods) {
    std::vector<bool> taken;
    for (const auto& method : methods)
        taken.push_back(method->taken_from().has_value());
    return taken;
}

class LeftMethods : public testing::Test {
  protected:
    /// All methods of the bench, from its first on, made ready as copies.
    Methods copies(std::size_t count) {
        const auto& configs = bench_.configs();
        return bench_.prepared(
            {configs.begin(), configs.begin() + static_cast<std::ptrdiff_t>(count)},
            0,
            Preparation::copied);
    }

    ViewBench bench_{one_cube({"mote4", "mote16", "ids", "mote2"}), {}};
};

TEST_F(LeftMethods, ArePassedOnOnceToTheNextThatWouldPrepareTheSame) {
    EXPECT_EQ(has_taken(copies(4)), (std::vector<bool>{false, false, false, false}));
    bench_.leave(0, copies(2));
    // The first two go to two of a kind; nothing is left for the last.
    EXPECT_EQ(has_taken(copies(4)), (std::vector<bool>{true, true, false, false}));
    EXPECT_EQ(has_taken(copies(1)), (std::vector<bool>{false}));
}

TEST_F(LeftMethods, GoOneByOneEvenWhereNothingCanBeTakenOver) {
    const auto& configs = bench_.configs();
    bench_.leave(0, copies(1));
    (void)bench_.prepared({configs[2]}, 0, Preparation::copied);
    EXPECT_EQ(has_taken(copies(1)), (std::vector<bool>{false}));
}

TEST_F(LeftMethods, GoWhenTheMethodsThemselvesAreAskedFor) {
    bench_.leave(0, copies(1));
    (void)bench_.methods(0, 0);
    EXPECT_EQ(has_taken(copies(1)), (std::vector<bool>{false}));
}

TEST_F(LeftMethods, LeaveTheSameImages) {
    const std::vector<edge::EdgeImage> expected = images_of(bench_, copies(4));
    Methods drawn = copies(4);
    (void)harness::method_evaluations(
        drawn, bench_.view(0, {160, 90}, 0), bench_.cell_options(1).measure);
    bench_.leave(0, std::move(drawn));
    Methods taken = copies(4);
    EXPECT_EQ(has_taken(taken), (std::vector<bool>{true, true, true, true}));
    EXPECT_EQ(images_of(bench_, std::move(taken)), expected);
}

}  // namespace
}  // namespace ink::experiment
