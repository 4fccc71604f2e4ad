// The best threshold of a whole set, against the independent scorer in Python.

#include <gtest/gtest.h>

#include <algorithm>
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
    std::array<score::CurveCount, 99> pool{};
    for (const auto& image : expected["images"]) {
        const auto folder = oracle_file("cases");
        const auto prediction = image_io::read_gray(folder / image["pred"].get<std::string>());
        const auto labels = image_io::read_gray(folder / image["gt"].get<std::string>());
        const score::ScoreOptions options{.tolerance_px = image["tol"], .thin = image["thin"]};
        const auto truth = score::prepare_truth(labels, options, false);
        const auto curve = score::score_curve(prediction, truth, options);
        for (std::size_t i = 0; i < pool.size(); ++i)
            pool[i] += curve[i];
    }
    ASSERT_EQ(expected["images"].size(), 32U);
    const auto& ods = expected["dataset"]["ODS"];
    const auto best = std::ranges::max_element(pool, {}, &score::CurveCount::f);
    EXPECT_NEAR(best->f(), ods["F"].get<double>(), 1e-9);
    EXPECT_EQ(best_threshold(pool),
              static_cast<int>(std::ceil(255 * ods["threshold"].get<double>() - 1e-9)));
}

INSTANTIATE_TEST_SUITE_P(Expected,
                         OdsOracle,
                         testing::Values("tol1", "tol2", "tol3", "tol2_raw"),
                         [](const auto& value) { return value.param; });

}  // namespace
}  // namespace ink::statistics
