#include "summary/cost_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ink::summary {
namespace {

constexpr PerUnit kPrices = {30, 4, 80, 25, 0.5, 0.125, 0.0625};

/// Frames of all sorts, priced by `prices`.
std::vector<CostSample> priced_samples(const PerUnit& prices) {
    std::mt19937_64 random(3);
    std::vector<CostSample> samples(40);
    for (CostSample& sample : samples) {
        for (std::size_t i = 0; i < kCostUnits; ++i) {
            // Units as unlike in size as vertices and bytes are.
            sample.counts[i] =
                static_cast<double>(random() % 1000) * std::pow(10, static_cast<double>(i));
            sample.measured_ns += sample.counts[i] * prices[i];
        }
    }
    return samples;
}

method::Cost declared(int interpolants, double bytes, double filter_bytes) {
    method::Cost cost;
    cost.passes = 1;
    cost.interpolants = interpolants;
    cost.values_per_vertex = interpolants;
    cost.buffer_bytes_per_px = static_cast<int>(bytes);
    cost.fill = {4, bytes};
    cost.filter = {filter_bytes, 1};
    return cost;
}

/// Four methods on three views of each scene, their times priced by kPrices; those of scene 0
/// multiplied.
std::vector<harness::Row> priced_rows(int scenes, double factor_of_first) {
    const std::vector<method::Cost> methods = {
        declared(1, 5, 8), declared(1, 6, 9), declared(2, 9, 30), declared(4, 20, 156)};
    std::mt19937_64 random(5);
    std::vector<harness::Row> rows;
    for (int scene = 0; scene < scenes; ++scene) {
        const double triangles = 100 + static_cast<double>(random() % 100000);
        const double vertices = triangles * (0.5 + static_cast<double>(random() % 100) / 80);
        for (int view = 0; view < 3; ++view) {
            const auto covered_px = static_cast<double>(random() % 900000);
            for (std::size_t m = 0; m < methods.size(); ++m) {
                harness::Row row;
                row.method = std::string(1, static_cast<char>('a' + m));
                row.scene = "scene" + std::to_string(scene);
                row.view = "view" + std::to_string(view);
                row.cost =
                    harness::CostFacts{methods[m], {vertices, triangles, covered_px, 921600}};
                const double ns = predict_ns(kPrices, unit_counts(*row.cost));
                row.draw_ns_min = std::llround(ns * (scene == 0 ? factor_of_first : 1));
                row.cell = static_cast<std::int64_t>(rows.size());
                rows.push_back(row);
            }
        }
    }
    return rows;
}

TEST(UnitCounts, ArePassesTimesTheSumOverStages) {
    method::Cost cost;
    cost.passes = 2;
    cost.interpolants = 3;
    cost.values_per_vertex = 5;
    cost.buffer_bytes_per_px = 7;
    cost.fill = {1, 2};
    cost.filter = {3, 4};
    const harness::FrameCounts frame{100, 10, 1000, 10000};
    const PerUnit counts = unit_counts({cost, frame});
    const PerUnit expected = {2 * 100,
                              2 * 100 * 5,
                              2 * 10,
                              2 * 10 * 3,
                              2 * 1000,
                              2 * 10000,
                              2 * (1000 * (1 + 2) + 10000 * (7 + 3 + 4))};
    EXPECT_EQ(counts, expected);
    cost.shares_vertices = false;
    EXPECT_EQ(unit_counts({cost, frame})[0], 2 * 3 * 10) << "three vertices a triangle";
}

TEST(FitUnitCosts, FindsThePricesThatTheTimesWereMadeFrom) {
    const PerUnit fitted = fit_unit_costs(priced_samples(kPrices));
    for (std::size_t i = 0; i < kCostUnits; ++i)
        EXPECT_NEAR(fitted[i] / kPrices[i], 1, 1e-6) << cost_units()[i].name;
}

TEST(FitUnitCosts, FindsThatAUnitCostsNothing) {
    PerUnit prices = kPrices;
    prices[2] = 0;
    const PerUnit fitted = fit_unit_costs(priced_samples(prices));
    EXPECT_NEAR(fitted[2], 0, 1e-6);
    EXPECT_NEAR(fitted[0] / prices[0], 1, 1e-6);
}

TEST(FitUnitCosts, HasNoPriceBelowZero) {
    // 2 a - b would fit exactly.
    std::vector<CostSample> samples(2);
    samples[0] = {{10, 1}, 19};
    samples[1] = {{10, 5}, 15};
    const PerUnit fitted = fit_unit_costs(samples);
    const double first = 10.0 / 19;
    const double second = 10.0 / 15;
    EXPECT_EQ(fitted[1], 0);
    EXPECT_NEAR(fitted[0], (first + second) / (first * first + second * second), 1e-9);
    EXPECT_EQ(fitted[2], 0) << "no sample has any of it";
}

TEST(FitUnitCosts, OfNothingIsNothing) {
    EXPECT_EQ(fit_unit_costs({}), PerUnit{});
}

TEST(PredictCosts, IsExactWhereTheModelIs) {
    const CostFit fit = predict_costs(priced_rows(5, 1), {});
    EXPECT_EQ(fit.cells, 5U * 3 * 4);
    EXPECT_EQ(fit.left_out, "scene");
    ASSERT_EQ(fit.predictions.size(), fit.cells);
    for (const CostPrediction& of : fit.predictions)
        EXPECT_NEAR(of.residual, 0, 1e-3) << of.cell;
}

TEST(PredictCosts, LeavesARowsOwnSceneOut) {
    const std::vector<harness::Row> rows = priced_rows(5, 3);
    for (const CostPrediction& of : predict_costs(rows, {}).predictions) {
        const harness::Row& row = rows[static_cast<std::size_t>(of.cell)];
        if (row.scene != "scene0") continue;
        EXPECT_NEAR(of.residual, 2, 0.01) << "three times what the others foretell";
        EXPECT_NEAR(static_cast<double>(*row.draw_ns_min) / static_cast<double>(of.predicted_ns),
                    1 + of.residual,
                    1e-4);
    }
}

TEST(PredictCosts, LeavesViewsOutWhereThereIsOneScene) {
    const CostFit fit = predict_costs(priced_rows(1, 1), {});
    EXPECT_EQ(fit.left_out, "view");
    EXPECT_EQ(fit.predictions.size(), 12U);
    for (const CostPrediction& of : fit.predictions)
        EXPECT_NEAR(of.residual, 0, 1e-2);
}

TEST(PredictCosts, SaysNothingWithFewerCellsThanUnits) {
    std::vector<harness::Row> rows = priced_rows(1, 1);
    rows.resize(8);  // two views of four methods: four cells are left for each
    const CostFit fit = predict_costs(rows, {});
    EXPECT_EQ(fit.cells, 0U);
    EXPECT_TRUE(fit.predictions.empty());
}

TEST(PredictCosts, LeavesBaselinesAndUndeclaredMethodsOutAndPredictsSettings) {
    std::vector<harness::Row> rows = priced_rows(3, 1);
    const std::size_t declared = rows.size();
    harness::Row oracle;
    oracle.method = "oracle";
    oracle.scene = "scene0";
    rows.push_back(oracle);
    harness::Row undeclared = rows.front();
    undeclared.cost->declared = {};
    rows.push_back(undeclared);
    harness::Row setting = rows.front();
    setting.setting = 2;
    const CostFit fit = predict_costs(rows, {setting});
    ASSERT_EQ(fit.predictions.size(), declared + 1);
    EXPECT_EQ(fit.predictions.back().setting, 2);
}

TEST(PredictionsTable, HasALinePerCellAndSetting) {
    CostFit fit;
    fit.predictions = {{3, 0, 1500, 0.25}, {3, 2, 1000, -0.5}};
    EXPECT_EQ(predictions_table().file(fit.predictions),
              "cell,setting,predicted_ns,cost_residual\n3,,1500,0.25\n3,2,1000,-0.5\n");
}

}  // namespace
}  // namespace ink::summary
