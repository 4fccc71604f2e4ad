// Which weights the linear bound asks about, and what of the stencils it keeps for them.

#include "linear_code/linear_bound_domain.h"

#include <gtest/gtest.h>

#include <random>

#include "core/error.h"
#include "linear_code/linear_bound.h"
#include "methods/registry.h"

namespace ink::linear_code {
namespace {

TEST(LinearStencils, SparesOnlyCandidatesThatChangeNothing) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> step(-2, 2);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const bool is_signed : {false, true}) {
        for (const auto response : {edge::Response::absolute, edge::Response::positive}) {
            const WeightDomain domain{is_signed, 12, response, 0};
            LinearStencils stencils(domain);
            std::vector<std::vector<StencilVector>> pixels(300);
            for (auto& candidates : pixels) {
                for (int i = 0; i < 6; ++i) {
                    StencilVector v{};
                    for (float& part : v)
                        part = static_cast<float>(step(random)) / 4;
                    candidates.push_back(v);
                }
                stencils.add_truth_pixel(candidates);
            }
            EXPECT_LT(stencils.candidates().size(), 300U * 6);
            for (int trial = 0; trial < 100; ++trial) {
                LinearWeights w{};
                for (double& weight : w)
                    weight = 3 * unit(random) * (is_signed && unit(random) < 0.5 ? -1 : 1);
                int found = 0;
                for (const auto& candidates : pixels) {
                    bool fires = false;
                    for (const StencilVector& v : candidates) {
                        const double r = w[0] * v[0] + w[1] * v[1] + w[2] * v[2] + w[3] * v[3];
                        const bool is_negative_line = response == edge::Response::absolute;
                        fires = fires || r >= 1 || (is_negative_line && r <= -1);
                    }
                    found += fires;
                }
                ASSERT_EQ(linear_count(stencils, w).found, found);
            }
        }
    }
}

TEST(WeightDomain, OfMote4IsItsByteOverTheLeastLine) {
    const auto code = *methods::find_method("mote4").make({})->code();
    // Two clipped bits: |L| of 4 is the least that draws; of 8 the least that reaches edge
    // response 6.
    EXPECT_EQ(threshold_in_codes(code.response, 1), 4);
    EXPECT_EQ(threshold_in_codes(code.response, 6), 8);
    EXPECT_EQ(threshold_in_codes({.scale_bits = -15}, 8), std::nullopt);
    EXPECT_DOUBLE_EQ(weight_domain("mote4", code, false, 0).most_sum, 63.75);
    EXPECT_DOUBLE_EQ(weight_domain("mote4", code, false, 10).most_sum, 25.5);
    EXPECT_EQ(weights_of(code, 6), (LinearWeights{7.875, 7.875, 7.875, 7.875}));
}

TEST(WeightDomain, RefusesCodesThatAreNotLinear) {
    for (const core::ParamValues& settings : {core::ParamValues{{"overflow", "wrap"}},
                                              {{"response", "wrap"}},
                                              {{"depth_sign", "far_high"}},
                                              {{"sky", "3"}}}) {
        const auto code = *methods::find_method("mote4").make(settings)->code();
        EXPECT_THROW((void)weight_domain("mote4", code, false, 0), core::Error);
    }
}

}  // namespace
}  // namespace ink::linear_code
