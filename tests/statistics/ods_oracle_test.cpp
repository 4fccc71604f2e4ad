// The best threshold of a whole set, against the independent scorer in Python.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "image_io/image_file.h"
#include "statistics/ods.h"
#include "tests/score/oracle_files.h"

namespace ink::statistics {
namespace {

class OdsOracle : public testing::TestWithParam<std::string> {};

TEST_P(OdsOracle, AgreesOnThresholdAndF) {
    std::ifstream file(oracle_file("expected/" + GetParam() + ".json"));
    const auto expected = nlohmann::json::parse(file);
    std::vector<CellCurve> curves;
    for (const auto& image : expected["images"]) {
        const auto folder = oracle_file("cases");
        const auto prediction = image_io::read_gray(folder / image["pred"].get<std::string>());
        const auto labels = image_io::read_gray(folder / image["gt"].get<std::string>());
        const score::ScoreOptions options{.tolerance_px = image["tol"], .thin = image["thin"]};
        const auto truth = score::prepare_truth(labels, options, false);
        curves.push_back({"oracle", true, score::score_curve(prediction, truth, options)});
    }
    ASSERT_EQ(curves.size(), 32U);
    const auto points = ods_on_training(curves);
    ASSERT_EQ(points.size(), 1U);
    const auto& ods = expected["dataset"]["ODS"];
    EXPECT_NEAR(points[0].f, ods["F"].get<double>(), 1e-9);
    EXPECT_EQ(points[0].threshold,
              static_cast<int>(std::ceil(255 * ods["threshold"].get<double>() - 1e-9)));
}

INSTANTIATE_TEST_SUITE_P(Expected,
                         OdsOracle,
                         testing::Values("tol1", "tol2", "tol3", "tol2_raw"),
                         [](const auto& value) { return value.param; });

}  // namespace
}  // namespace ink::statistics
