#include "linear_code/cancellation.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "catalogue/catalogue.h"
#include "methods/registry.h"
#include "tests/linear_code/crease_fan.h"

namespace ink::linear_code {
namespace {

using truth::LineClass;

constexpr double kDegree_rad = std::numbers::pi / 180;
constexpr std::int64_t kEnough_px = 300;  // two points are six pixels of them
constexpr double kTwoPoints = 0.02;

/// The rows of methods on views of one scene; `crease_deg` is the methods' and the truth's.
std::vector<CancellationRow> study(const scene::Scene& scene,
                                   const std::vector<scene::View>& views,
                                   std::vector<method::MethodConfig> configs,
                                   double crease_deg) {
    for (method::MethodConfig& config : configs)
        config.settings["crease_deg"] = std::to_string(crease_deg);
    const auto methods = harness::prepare_methods(configs, scene);
    truth::TruthOptions options;
    options.crease_rad = crease_deg * kDegree_rad;
    truth::SceneModel model(scene, options);
    harness::MissPredictor predictor(scene);
    std::vector<CancellationRow> rows;
    for (const scene::View& view : views) {
        const harness::ViewTruth truth = harness::trace_view(model, view, {});
        const std::vector<harness::Evaluation> evaluations =
            harness::method_evaluations(methods, view, {1, 0, 0, 0});
        for (CancellationRow& row : study_cancellation(truth, view, predictor, evaluations))
            rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<method::MethodConfig> motes() {
    std::vector<method::MethodConfig> configs;
    for (const char* name : {"mote2", "mote4", "mote16"})
        configs.push_back({&methods::find_method(name), {}});
    return configs;
}

/// The counts of a method and a kind over all views.
struct CancellationTotal {
    std::size_t method = 0;
    LineKind kind = {};
    CancellationCount count = {};

    [[nodiscard]] double predicted_rate() const { return share(count.predicted_missed); }
    [[nodiscard]] double measured_rate() const { return share(count.measured_missed); }

  private:
    [[nodiscard]] double share(std::int64_t px) const {
        return static_cast<double>(px) / static_cast<double>(count.n_truth);
    }
};

/// Rows added up by method and kind, or by method and class.
std::vector<CancellationTotal> totals_of(const std::vector<CancellationRow>& rows, bool by_bin) {
    std::map<std::pair<std::size_t, LineKind>, CancellationCount> sums;
    for (const CancellationRow& row : rows) {
        LineKind kind = row.kind;
        if (!by_bin) kind.dihedral_low_deg.reset();
        CancellationCount& sum = sums[{row.evaluation, kind}];
        sum.n_truth += row.count.n_truth;
        sum.predicted_missed += row.count.predicted_missed;
        sum.measured_missed += row.count.measured_missed;
    }
    std::vector<CancellationTotal> totals;
    for (const auto& [of, sum] : sums) {
        CancellationTotal& total = totals.emplace_back();
        std::tie(total.method, total.kind) = of;
        total.count = sum;
    }
    return totals;
}

std::string words(const CancellationTotal& total) {
    return fmt::format("method {}, {} from {} deg",
                       total.method,
                       truth::name(total.kind.line_class),
                       total.kind.dihedral_low_deg.value_or(-1));
}

/// How many totals have enough pixels, each of which must be within two points.
int expect_within_two_points(const std::vector<CancellationTotal>& totals) {
    int count = 0;
    for (const CancellationTotal& total : totals) {
        if (total.count.n_truth < kEnough_px) continue;
        EXPECT_NEAR(total.predicted_rate(), total.measured_rate(), kTwoPoints)
            << words(total) << ", " << total.count.n_truth << " px";
        ++count;
    }
    return count;
}

CancellationCount crease_total(const std::vector<CancellationRow>& rows) {
    CancellationCount count;
    for (const CancellationRow& row : rows) {
        if (row.kind.line_class != LineClass::crease) continue;
        count.n_truth += row.count.n_truth;
        count.predicted_false_negatives += row.count.predicted_false_negatives;
        count.measured_false_negatives += row.count.measured_false_negatives;
        count.both_false_negatives += row.count.both_false_negatives;
    }
    return count;
}

TEST(ThresholdInCodes, OfMote4IsTheLeastThatItsTwoClippedBitsDraw) {
    const auto code = *methods::find_method("mote4").make({})->code();
    EXPECT_EQ(threshold_in_codes(code.response, 1), 4);
    EXPECT_EQ(threshold_in_codes(code.response, 6), 8);
    EXPECT_EQ(threshold_in_codes({.scale_bits = -15}, 8), std::nullopt);
}

TEST(Cancellation, OnCreasesOfEveryAnglePredictedAndMeasuredMissesAgree) {
    const RoofImage fan = crease_fan();
    const auto rows = study(fan.scene, {fan.view}, motes(), 5);
    const auto kinds = totals_of(rows, true);
    int bins = 0;
    for (const CancellationTotal& total : kinds) {
        if (total.kind.line_class != LineClass::crease) continue;
        // 24 ridges of 20 px: 20 pixels each along an axis, 14 along a diagonal.
        EXPECT_GE(total.count.n_truth, 340) << words(total);
        EXPECT_LE(total.count.n_truth, 520) << words(total);
        ++bins;
    }
    EXPECT_EQ(bins, 3 * 16) << "a bin for each bend and method";
    EXPECT_GE(expect_within_two_points(kinds), 3 * 16);
    expect_within_two_points(totals_of(rows, false));
    for (const CancellationTotal& total : totals_of(rows, false)) {
        if (total.kind.line_class != LineClass::crease) continue;
        EXPECT_GT(total.measured_rate(), 0.03) << "else there was nothing to foretell";
    }
}

TEST(Cancellation, OnCreaseScenesOfTheCatalogueTheyAgreeInEveryBinAndClass) {
    int compared = 0;
    for (const char* name : {"cube", "staircase", "gem"}) {
        const scene::Scene scene = catalogue::make_catalogue_scene(name);
        std::vector<scene::View> views;
        for (const scene::Camera& camera : scene.cameras)
            views.push_back({camera, 480, 270});
        const auto rows = study(scene, views, motes(), 40);
        SCOPED_TRACE(name);
        compared += expect_within_two_points(totals_of(rows, true));
        compared += expect_within_two_points(totals_of(rows, false));
        EXPECT_GE(crease_total(rows).n_truth, 3 * kEnough_px);
    }
    EXPECT_GE(compared, 3 * 3 * 4) << "contours and creases, in bins and together";
}

/// A roof whose normals differ in x less y alone: by weights that are alike its code is one code.
RoofImage diagonal_roof() {
    scene::Mesh mesh;
    add_roof({.deviation_rad = 85 * kDegree_rad,
              .roll_rad = 45 * kDegree_rad,
              .half_length = 40,
              .half_width = 30},
             mesh);
    return image_of(std::move(mesh), 160, 160);
}

TEST(Cancellation, ACreaseAcrossWhichTheCodeDoesNotChangeIsPredictedMissed) {
    const RoofImage roof = diagonal_roof();
    const method::MethodConfig alike{&methods::find_method("mote4"), {{"sky", "255"}}};
    const CancellationCount missed = crease_total(study(roof.scene, {roof.view}, {alike}, 40));
    // 80 px along a diagonal are 57 pixels; at both ends the outline's ink is in reach.
    EXPECT_GE(missed.n_truth, 50);
    EXPECT_GE(missed.predicted_false_negatives, missed.n_truth - 10);
    EXPECT_EQ(missed.both_false_negatives, missed.predicted_false_negatives);
}

TEST(Cancellation, TheSameCreaseIsPredictedSeenByUnlikeWeights) {
    const RoofImage roof = diagonal_roof();
    const method::MethodConfig unlike{&methods::find_method("mote4"),
                                      {{"sky", "255"}, {"range_ny", "0"}}};
    const CancellationCount seen = crease_total(study(roof.scene, {roof.view}, {unlike}, 40));
    EXPECT_GE(seen.n_truth, 50);
    EXPECT_EQ(seen.predicted_false_negatives, 0);
    EXPECT_EQ(seen.measured_false_negatives, 0);
}

TEST(Cancellation, ThePredictionNeverReadsTheImage) {
    const RoofImage roof = diagonal_roof();
    truth::SceneModel model(roof.scene, {});
    const harness::ViewTruth truth = harness::trace_view(model, roof.view, {});
    harness::MissPredictor predictor(roof.scene);
    std::vector<harness::Evaluation> evaluations(2);
    for (harness::Evaluation& evaluation : evaluations) {
        evaluation.code.emplace();
        evaluation.code->normal_weight[0] = 60;
        evaluation.threshold = 8;
        evaluation.row.n_truth = 1;
        evaluation.image = edge::EdgeImage(160, 160);
    }
    evaluations[1].image.fill(255);
    const auto rows = study_cancellation(truth, roof.view, predictor, evaluations);
    ASSERT_FALSE(rows.empty());
    ASSERT_EQ(rows.size() % 2, 0U);
    const std::size_t half = rows.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
        EXPECT_EQ(rows[i].count.predicted_missed, rows[half + i].count.predicted_missed);
        EXPECT_EQ(rows[i].count.predicted_false_negatives,
                  rows[half + i].count.predicted_false_negatives);
        EXPECT_EQ(rows[i].count.measured_missed, rows[i].count.n_truth) << "nothing was drawn";
    }
}

TEST(Cancellation, MethodsWithoutACodeAndFailedOnesHaveNoRows) {
    const RoofImage roof = diagonal_roof();
    truth::SceneModel model(roof.scene, {});
    const harness::ViewTruth truth = harness::trace_view(model, roof.view, {});
    harness::MissPredictor predictor(roof.scene);
    std::vector<harness::Evaluation> evaluations(2);
    evaluations[1].code.emplace();
    evaluations[1].row.status = "out of ink";
    EXPECT_TRUE(study_cancellation(truth, roof.view, predictor, evaluations).empty());
}

score::PixelList pixels_at(const std::vector<score::Pixel>& pixels) {
    core::Image<std::uint8_t> image(20, 3);
    for (const auto& [x, y] : pixels)
        image.at(x, y) = 1;
    return score::PixelList(image);
}

TEST(CancellationCount, CountsWhatEachInkMissesAndWhatBothDo) {
    // True pixels 0 1 9 14; predicted ink reaches 0 and 1 once, measured ink 9.
    const auto kind = pixels_at({{0, 1}, {1, 1}, {9, 1}, {14, 1}});
    CountedInk predicted(pixels_at({{1, 2}}), score::Disk(2));
    CountedInk measured(pixels_at({{10, 1}, {11, 1}}), score::Disk(2));
    const CancellationCount count = count_cancellation(kind, predicted, measured);
    EXPECT_EQ(count.n_truth, 4);
    EXPECT_EQ(count.predicted_missed, 3) << "one ink pixel is matched once";
    EXPECT_EQ(count.measured_missed, 3);
    EXPECT_EQ(count.predicted_false_negatives, 2);
    EXPECT_EQ(count.measured_false_negatives, 3);
    EXPECT_EQ(count.both_false_negatives, 1) << "the last one";
}

TEST(CancellationTable, HasNoBinForBoundaries) {
    CancellationRow row{0, 7.25, {LineClass::crease, 40}, {9, 3, 2, 2, 1, 1}};
    EXPECT_EQ(cancellation_table().line(3, row), "3,7.25,crease,40,50,9,3,2,2,1,1\n");
    row.kind = {LineClass::boundary, std::nullopt};
    EXPECT_EQ(cancellation_table().line(3, row), "3,7.25,boundary,,,9,3,2,2,1,1\n");
}

TEST(CancellationLaw, FacetsAreSilentBelowTheLeastStepThatFiresWhenSeenTwice) {
    method::LinearCode code;
    code.normal_weight[2] = 100;
    code.response.clip_bits = 0;
    // |L| = 8 fires: 2 * 100 sin(deviation / 2) = 8.
    EXPECT_NEAR(silent_deviation_rad(code, 8), 2 * std::asin(0.04), 1e-12);
    code.response.clip_bits = 2;  // 5, 6, 7 become 4
    EXPECT_NEAR(silent_deviation_rad(code, 5), 2 * std::asin(0.04), 1e-12);
    code.normal_weight[0] = 60;
    code.normal_weight[2] = 80;
    EXPECT_NEAR(silent_deviation_rad(code, 8), 2 * std::asin(0.04), 1e-12) << "the length counts";
    EXPECT_NEAR(silent_deviation_rad(code, 250), std::numbers::pi, 1e-12) << "200 is the most";
    EXPECT_NEAR(silent_deviation_rad({}, 1), std::numbers::pi, 1e-12) << "no normal in it";
}

}  // namespace
}  // namespace ink::linear_code
