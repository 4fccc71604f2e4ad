#include "studies/roll_study.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/roll_table.h"
#include "tests/harness/skipping_method.h"

namespace ink::studies {
namespace {

using testing::HasSubstr;

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

/// The claim itself: two angles per crease, each within two degrees of where mote4 loses it.
TEST(StudyRoll, Mote4LosesEachCreaseWhereItsWeightsSay) {
    const RollOptions options{.frame_count = 180, .size_px = 200};
    const auto curves = study_roll(harness::make_configs("mote4", {}), options);
    ASSERT_EQ(curves.size(), 3U);
    for (const RollCurve& curve : curves) {
        SCOPED_TRACE(curve.crease);
        EXPECT_TRUE(curve.is_predicted);
        ASSERT_EQ(curve.samples.size(), 180U);
        ASSERT_EQ(curve.vanishing.size(), 2U);
        for (const Vanishing& at : curve.vanishing) {
            ASSERT_TRUE(at.measured_rad.has_value());
            const double off =
                std::remainder(*at.measured_rad - at.predicted_rad, 360 * kDegree_rad);
            EXPECT_LT(std::abs(off), 2 * kDegree_rad);
            EXPECT_LT(at.recall_there.value(), 0.2);
        }
        // Wherever the step is seen clearly the crease is whole, and only there.
        for (const RollSample& sample : curve.samples) {
            if (std::abs(sample.step) > 8) {
                EXPECT_GT(sample.recall(), 0.95) << sample.roll_rad;
            }
            if (std::abs(sample.step) < 2) {
                EXPECT_LT(sample.recall(), 0.3) << sample.roll_rad;
            }
        }
    }
}

TEST(StudyRoll, WhoDeclaresNoCodeIsNotPredictedAndThreadsChangeNothing) {
    RollOptions options{.frame_count = 8, .size_px = 120};
    const auto configs = harness::make_configs("decaudin,mote4", {});
    const auto curves = study_roll(configs, options);
    ASSERT_EQ(curves.size(), 6U);
    EXPECT_FALSE(curves[0].is_predicted);
    EXPECT_TRUE(curves[0].vanishing.empty());
    EXPECT_GT(curves[0].mean_recall(), 0.9);
    options.measure.threads = 3;
    const auto again = study_roll(configs, options);
    ASSERT_EQ(again.size(), curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
        EXPECT_EQ(roll_lines(1, again[i]), roll_lines(1, curves[i]));
        EXPECT_EQ(vanishing_lines(1, again[i]), vanishing_lines(1, curves[i]));
    }
}

TEST(StudyRoll, AMethodThatFailsSaysWhyInItsRow) {
    harness::SkipScript script;
    script.failure = "out of ink";
    const auto info = harness::skipping_info(script);
    const RollOptions options{.frame_count = 4, .size_px = 40};
    const auto curves = study_roll({{&info, {}}}, options);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_EQ(curves[0].status, "failed: out of ink");
    EXPECT_EQ(roll_row(curves[0], options).status, curves[0].status);
    EXPECT_EQ(roll_row(curves[0], options).method, "puppet");
    EXPECT_EQ(roll_lines(1, curves[0]) + vanishing_lines(1, curves[0]), "");
}

/// A made-up curve of method `a<b` that must vanish at 45 degrees.
RollCurve made_up_curve() {
    RollCurve curve{.method = "a<b", .params = "k=1", .crease = 1, .is_predicted = true};
    for (int i = 0; i < 8; ++i) {
        curve.samples.push_back({.roll_rad = i * 45 * kDegree_rad,
                                 .length_px = 20,
                                 .covered_px = i == 1 ? 1.0 : 20.0,
                                 .step = i - 1.0,
                                 .is_blind = i == 1});
    }
    curve.vanishing = {{45 * kDegree_rad, 46 * kDegree_rad, 0.05}, {225 * kDegree_rad}};
    return curve;
}

TEST(RollCurve, KnowsItsLeastAndItsMean) {
    EXPECT_DOUBLE_EQ(made_up_curve().least_recall(), 0.05);
    EXPECT_DOUBLE_EQ(made_up_curve().mean_recall(), 7.05 / 8);
    EXPECT_EQ(RollCurve{}.mean_recall(), 1);
}

TEST(RollTable, HasALinePerAngleAndOnePerPrediction) {
    const std::string roll = roll_lines(3, made_up_curve());
    EXPECT_EQ(std::count(roll.begin(), roll.end(), '\n'), 8);
    EXPECT_THAT(roll, HasSubstr("\n3,1,45,20,1,0,true\n"));
    RollCurve unpredicted = made_up_curve();
    unpredicted.is_predicted = false;
    unpredicted.samples.resize(1);
    EXPECT_EQ(roll_lines(3, unpredicted), "3,1,0,20,20,,\n");
    EXPECT_EQ(vanishing_lines(3, made_up_curve()), "3,1,45,46,1,0.05\n3,1,225,,,\n");
}

}  // namespace
}  // namespace ink::studies
