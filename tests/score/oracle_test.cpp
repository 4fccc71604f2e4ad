// Our scorer against the independent one in Python: every integer it left behind.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "image_io/image_file.h"
#include "score/score.h"
#include "tests/score/oracle_files.h"

namespace {

using ink::score::CurveCount;
using ink::score::ScoreOptions;
using nlohmann::json;

json load_json(const std::filesystem::path& path) {
    std::ifstream file(path);
    return json::parse(file);
}

/// The curve in full, from the entries [k, K, nP] at which the counts change.
std::array<CurveCount, 99> expand_curve(const json& changes, std::int64_t n_truth) {
    std::array<CurveCount, 99> curve;
    std::size_t next = 0;
    CurveCount now;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        if (next < changes.size() && changes[next][0].get<std::size_t>() == i + 1) {
            now = {.k = changes[next][1], .n_pred = changes[next][2], .n_truth = n_truth};
            ++next;
        }
        curve[i] = now;
    }
    EXPECT_EQ(next, changes.size());
    return curve;
}

void expect_curve(const json& expected, const std::array<CurveCount, 99>& curve) {
    const auto wanted = expand_curve(expected["curve"], expected["n_gt"]);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        EXPECT_EQ(curve[i].k, wanted[i].k) << "threshold " << i + 1;
        EXPECT_EQ(curve[i].n_pred, wanted[i].n_pred) << "threshold " << i + 1;
        EXPECT_EQ(curve[i].n_truth, wanted[i].n_truth) << "threshold " << i + 1;
    }
    EXPECT_NEAR(ink::score::average_precision(curve), expected["AP"].get<double>(), 1e-9);
}

void expect_score(const json& expected, const ink::score::Score& score) {
    const json& best = expected["best"];
    EXPECT_EQ(score.k, best["K"].get<std::int64_t>());
    EXPECT_EQ(score.n_pred, best["nP"].get<std::int64_t>());
    EXPECT_EQ(score.n_truth, best["nG"].get<std::int64_t>());
    EXPECT_NEAR(score.f(), best["F"].get<double>(), 1e-9);
    EXPECT_EQ(score.precision().has_value(), !best["P"].is_null());
    EXPECT_EQ(score.recall().has_value(), !best["R"].is_null());
    if (score.precision()) {
        EXPECT_NEAR(*score.precision(), best["P"].get<double>(), 1e-9);
    }
    if (score.recall()) {
        EXPECT_NEAR(*score.recall(), best["R"].get<double>(), 1e-9);
    }

    const json& at_best = expected["at_best"];
    EXPECT_EQ(score.n_pred - score.false_positives, at_best["relaxed_tp_pred"].get<std::int64_t>());
    EXPECT_EQ(score.n_truth - score.false_negatives, at_best["relaxed_tp_gt"].get<std::int64_t>());

    ASSERT_EQ(score.classes.size(), expected["classes"].size());
    for (const ink::score::ClassCount& c : score.classes) {
        const json& wanted = expected["classes"].at(std::to_string(c.label));
        EXPECT_EQ(c.k, wanted["K"].get<std::int64_t>()) << "class " << c.label;
        EXPECT_EQ(c.n_truth, wanted["nG"].get<std::int64_t>()) << "class " << c.label;
    }
}

void expect_case(const json& expected, std::optional<int> ignore_label) {
    SCOPED_TRACE(expected["pred"].get<std::string>());
    const auto folder = oracle_file("cases");
    const auto prediction = ink::image_io::read_gray(folder / expected["pred"]);
    const auto labels = ink::image_io::read_gray(folder / expected["gt"]);
    const ScoreOptions options{.tolerance_px = expected["tol"],
                               .threshold = expected["best"]["cut"],
                               .thin = expected["thin"],
                               .ignore_label = ignore_label};
    const auto truth = ink::score::prepare_truth(labels, options, false);
    expect_curve(expected, ink::score::score_curve(prediction, truth, options));
    const auto score = ink::score::score(prediction, truth, options);
    expect_score(expected, score);
    // The oracle counts the width after it dropped what lies under the ignore map; we count it
    // before.
    const json& width = expected["at_best"]["mean_width"];
    if (!ignore_label) {
        EXPECT_NEAR(score.mean_width_px, width.is_null() ? 0 : width.get<double>(), 1e-9);
    }
}

class Oracle : public testing::TestWithParam<std::string> {};

TEST_P(Oracle, AgreesToTheLastInteger) {
    const json expected = load_json(oracle_file("expected/" + GetParam() + ".json"));
    ASSERT_EQ(expected["images"].size(), 32U);
    for (const json& image : expected["images"])
        expect_case(image, std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(Expected,
                         Oracle,
                         testing::Values("tol1", "tol2", "tol3", "tol2_raw"),
                         [](const auto& value) { return value.param; });

TEST(OracleIgnore, AgreesToTheLastInteger) {
    expect_case(load_json(oracle_file("expected/ignore7_tol2.json")), 7);
}

}  // namespace
