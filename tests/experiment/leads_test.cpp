#include "experiment/leads.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ink::experiment {
namespace {

/// `k` of 100 true pixels found with 100 drawn.
harness::Row row_of(const std::string& method, const std::string& scene, std::int64_t k) {
    harness::Row row;
    row.method = method;
    row.scene = scene;
    row.view = "front";
    row.k_2px = k;
    row.n_pred = row.n_truth = 100;
    row.f_2px = static_cast<double>(k) / 100;
    return row;
}

std::vector<harness::Row> twelve_scenes() {
    std::vector<harness::Row> rows;
    for (int i = 0; i < 12; ++i) {
        const std::string scene = std::to_string(i);
        rows.push_back(row_of("even", scene, 50 + i));
        rows.push_back(row_of("better", scene, 52 + i));
        rows.push_back(row_of("moody", scene, i % 2 == 0 ? 40 + i : 62 + i));
        rows.push_back(row_of("oracle", scene, 100));
    }
    return rows;
}

TEST(LeadOf, IsSureWhereEverySceneAgreesAndOnlyThere) {
    const auto sure = lead_of(twelve_scenes(), "better", "even");
    ASSERT_TRUE(sure && sure->range);
    EXPECT_NEAR(sure->difference, 0.02, 1e-12);
    EXPECT_NEAR(sure->range->low, 0.02, 1e-12) << "paired: every scene differs by the same";
    EXPECT_NEAR(sure->range->high, 0.02, 1e-12);
    EXPECT_TRUE(sure->is_beyond_chance());
    const auto unsure = lead_of(twelve_scenes(), "moody", "even");
    ASSERT_TRUE(unsure && unsure->range);
    EXPECT_LT(unsure->range->low, 0);
    EXPECT_GT(unsure->range->high, 0);
    EXPECT_FALSE(unsure->is_beyond_chance());
    EXPECT_FALSE(lead_of(twelve_scenes(), "better", "absent"));
}

TEST(LeadOf, OneSceneGivesADifferenceWithoutInterval) {
    std::vector<harness::Row> rows;
    for (int i = 0; i < 5; ++i) {
        for (const char* method : {"a", "b"}) {
            harness::Row row = row_of(method, "cube", method[0] == 'a' ? 80 : 70);
            row.view = std::to_string(i);
            rows.push_back(row);
        }
    }
    const auto lead = lead_of(rows, "a", "b");
    ASSERT_TRUE(lead);
    EXPECT_NEAR(lead->difference, 0.1, 1e-12);
    EXPECT_FALSE(lead->range);
    EXPECT_FALSE(lead->is_beyond_chance());
}

TEST(LeadOf, ComparesOnlyViewsThatBothHave) {
    std::vector<harness::Row> rows = {row_of("a", "cube", 80), row_of("b", "cube", 70)};
    rows.push_back(row_of("a", "torus", 10));
    rows.push_back(row_of("b", "torus", 90));
    rows.back().status = "failed: out of ink";
    EXPECT_NEAR(lead_of(rows, "a", "b")->difference, 0.1, 1e-12);
}

TEST(AllLeads, AreEveryOrderedPairOfMethodsBestFirst) {
    std::vector<std::string> pairs;
    for (const Lead& lead : all_leads(twelve_scenes()))
        pairs.push_back(lead.a + ">" + lead.b);
    EXPECT_THAT(pairs,
                testing::ElementsAre("better>moody",
                                     "better>even",
                                     "moody>better",
                                     "moody>even",
                                     "even>better",
                                     "even>moody"));
    EXPECT_TRUE(all_leads({}).empty());
}

TEST(AllLeads, OfAPairTurnedRoundIsTheOpposite) {
    const auto leads = all_leads(twelve_scenes());
    EXPECT_NEAR(leads[0].difference, -leads[2].difference, 1e-12);
    EXPECT_NEAR(leads[0].range->low, -leads[2].range->high, 1e-12);
}

}  // namespace
}  // namespace ink::experiment
