#include "studies/roll_axis.h"
#include "methods/method_configs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/axis_rows.h"
#include "tests/harness/skipping_method.h"
#include "tests/studies/roll_lines.h"

namespace ink::studies {
namespace {

constexpr double kDegree_rad = std::numbers::pi / 180;

/// 360 samples, one a degree, in which the named degrees are lost.
std::vector<RollSample> turn_without(const std::vector<int>& lost) {
    std::vector<RollSample> samples;
    for (int i = 0; i < 360; ++i) {
        const bool is_lost = std::find(lost.begin(), lost.end(), i) != lost.end();
        samples.push_back(
            {.roll_rad = i * kDegree_rad, .length_px = 10, .covered_px = is_lost ? 4.9 : 5.0});
    }
    return samples;
}

double measured_deg(const std::vector<int>& lost, double predicted_deg) {
    const auto measured = measured_vanishing(turn_without(lost), predicted_deg * kDegree_rad);
    return measured ? *measured / kDegree_rad : -1;
}

TEST(MeasuredVanishing, IsTheMiddleOfWhatIsLost) {
    EXPECT_NEAR(measured_deg({40, 41, 42, 43}, 42), 41.5, 1e-9);
    EXPECT_NEAR(measured_deg({40, 90, 91, 92, 200}, 93), 91, 1e-9);
    EXPECT_NEAR(measured_deg({40, 44}, 43), 44, 1e-9);
}

TEST(MeasuredVanishing, GoesRoundTheTurn) {
    EXPECT_NEAR(measured_deg({357, 358, 359, 0, 1}, 2), 359, 1e-9);
    EXPECT_NEAR(measured_deg({359, 0, 1, 2, 3, 4}, 358), 1.5, 1e-9);
}

TEST(MeasuredVanishing, IsNothingFarFromThePrediction) {
    EXPECT_EQ(measured_deg({40, 41, 42}, 60), -1);
    EXPECT_EQ(measured_deg({}, 60), -1);
    EXPECT_EQ(measured_vanishing({}, 1), std::nullopt);
}

TEST(MeasuredVanishing, OfACreaseThatIsNeverShownIsNothing) {
    std::vector<RollSample> samples = turn_without({});
    for (RollSample& sample : samples)
        sample.covered_px = 0;
    EXPECT_EQ(measured_vanishing(samples, 1), std::nullopt);
}

/// A whole turn; cells count up by `configs` and baselines.
Lines turn_round(const std::vector<method::MethodConfig>& configs,
                 const RollOptions& options,
                 int threads = 1) {
    const Axis axis = roll_axis(configs, options);
    harness::CellOptions cells;
    cells.trace.crosscheck = false;
    cells.measure.threads = threads;
    const auto observer = axis.observer();
    std::int64_t cell = 0;
    for (const double value : axis.values) {
        for (const Case& one : axis.cases(value, {}))
            cell += static_cast<std::int64_t>(
                axis_rows(axis, one, configs, cells, observer.get(), cell).size());
    }
    return observer->lines();
}

/// The claim itself: two angles per crease, each within two degrees of where mote4 loses it.
TEST(RollAxis, Mote4LosesEachCreaseWhereItsWeightsSay) {
    const Lines lines =
        turn_round(methods::make_configs("mote4", {}), {.angles = 180, .size_px = 200});
    const harness::CsvTable angles = harness::split_csv(
        harness::heading(vanishing_table()) + lines.at("vanishing.csv"), "vanishing.csv");
    ASSERT_EQ(angles.records.size(), 6U) << "three creases, two angles each";
    for (std::size_t i = 0; i < angles.records.size(); ++i) {
        EXPECT_LT(std::abs(harness::CsvField(angles, i, 4).as<double>()), 2) << "error_deg";
        EXPECT_LT(harness::CsvField(angles, i, 5).as<double>(), 0.2) << "recall_there";
    }
    // Wherever the step is seen clearly the crease is whole, and only there.
    const auto samples = creases_in(lines);
    ASSERT_EQ(samples.size(), 3U * 180);
    for (const RollSampleLine& sample : samples) {
        if (std::abs(sample.step) > 8) {
            EXPECT_GT(sample.recall(), 0.95) << sample.cell;
        }
        if (std::abs(sample.step) < 2) {
            EXPECT_LT(sample.recall(), 0.3) << sample.cell;
        }
    }
}

TEST(RollAxis, WhoDeclaresNoCodeIsNotPredictedAndThreadsChangeNothing) {
    const RollOptions options{.angles = 8, .size_px = 120};
    const auto configs = methods::make_configs("decaudin,mote4", {});
    const Lines lines = turn_round(configs, options);
    const auto samples = creases_in(lines);
    const std::int64_t cells_of_angle = 2 + harness::kBaselines;
    double recall = 0;
    int count = 0;
    for (const RollSampleLine& sample : samples) {
        if (sample.cell % cells_of_angle != 0) continue;
        recall += sample.recall();
        ++count;
    }
    EXPECT_GT(recall / count, 0.9);
    EXPECT_NE(lines.at("creases.csv").find(",,\n"), std::string::npos) << "no prediction";
    EXPECT_EQ(turn_round(configs, options, 3), lines);
}

TEST(RollAxis, AMethodThatFailsHasNoLines) {
    harness::SkipScript script;
    script.failure = "out of ink";
    const auto info = harness::skipping_info(script);
    EXPECT_TRUE(turn_round({{&info, {}}}, {.angles = 4, .size_px = 40}).empty());
}

TEST(RollTables, ALineHasAPredictionWhereTheMethodDeclaresACode) {
    RollSample sample{.crease = 2, .length_px = 8, .covered_px = 6, .step = -1.5, .is_blind = true};
    EXPECT_EQ(creases_table().line(3, sample), "3,2,8,6,,\n");
    sample.is_predicted = true;
    EXPECT_EQ(creases_table().line(3, sample), "3,2,8,6,-1.5,true\n");
}

TEST(RollTables, TurnTheShortWayFromPredictionToMeasurement) {
    EXPECT_EQ(vanishing_table().line(7, {0, 359 * kDegree_rad, 2 * kDegree_rad, 0.25}),
              "7,0,359,2,3,0.25\n");
    EXPECT_EQ(vanishing_table().line(7, {0, 10 * kDegree_rad, std::nullopt, std::nullopt}),
              "7,0,10,,,\n");
}

}  // namespace
}  // namespace ink::studies
