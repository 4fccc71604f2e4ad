#include "summary/paired_differences.h"

#include <gmock/gmock.h>

#include <random>

#include "summary/summary_csv.h"

namespace ink::summary {
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

/// That of a over b; nothing without a view in common.
std::optional<PairedDifference> paired_difference_of(const std::vector<harness::Row>& rows,
                                                     const std::string& a,
                                                     const std::string& b) {
    for (const PairedDifference& paired : compare_methods(rows).differences) {
        if (paired.a == a && paired.b == b) return paired;
    }
    return std::nullopt;
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

TEST(PairedDifferenceOf, IsSureWhereEverySceneAgreesAndOnlyThere) {
    const auto sure = paired_difference_of(twelve_scenes(), "better", "even");
    ASSERT_TRUE(sure && sure->range);
    EXPECT_NEAR(sure->difference, 0.02, 1e-12);
    EXPECT_NEAR(sure->range->low, 0.02, 1e-12) << "paired: every scene differs by the same";
    EXPECT_NEAR(sure->range->high, 0.02, 1e-12);
    EXPECT_TRUE(sure->is_significant());
    const auto unsure = paired_difference_of(twelve_scenes(), "moody", "even");
    ASSERT_TRUE(unsure && unsure->range);
    EXPECT_LT(unsure->range->low, 0);
    EXPECT_GT(unsure->range->high, 0);
    EXPECT_FALSE(unsure->is_significant());
    EXPECT_FALSE(paired_difference_of(twelve_scenes(), "better", "absent"));
}

TEST(PairedDifferenceOf, OneSceneGivesADifferenceWithoutInterval) {
    std::vector<harness::Row> rows;
    for (int i = 0; i < 5; ++i) {
        for (const char* method : {"a", "b"}) {
            harness::Row row = row_of(method, "cube", method[0] == 'a' ? 80 : 70);
            row.view = std::to_string(i);
            rows.push_back(row);
        }
    }
    const auto paired = paired_difference_of(rows, "a", "b");
    ASSERT_TRUE(paired);
    EXPECT_NEAR(paired->difference, 0.1, 1e-12);
    EXPECT_FALSE(paired->range);
    EXPECT_FALSE(paired->is_significant());
}

TEST(PairedDifferenceOf, ComparesOnlyViewsThatBothHave) {
    std::vector<harness::Row> rows = {row_of("a", "cube", 80), row_of("b", "cube", 70)};
    rows.push_back(row_of("a", "torus", 10));
    rows.push_back(row_of("b", "torus", 90));
    rows.back().status = "failed: out of ink";
    EXPECT_NEAR(paired_difference_of(rows, "a", "b")->difference, 0.1, 1e-12);
}

TEST(AllPairedDifferences, AreEveryOrderedPairOfMethodsBestFirst) {
    std::vector<std::string> pairs;
    for (const PairedDifference& paired : compare_methods(twelve_scenes()).differences)
        pairs.push_back(paired.a + ">" + paired.b);
    EXPECT_THAT(pairs,
                testing::ElementsAre("better>moody",
                                     "better>even",
                                     "moody>better",
                                     "moody>even",
                                     "even>better",
                                     "even>moody"));
    EXPECT_TRUE(compare_methods({}).differences.empty());
}

TEST(AllPairedDifferences, OfAPairTurnedRoundIsTheOpposite) {
    const auto differences = compare_methods(twelve_scenes()).differences;
    EXPECT_NEAR(differences[0].difference, -differences[2].difference, 1e-12);
    EXPECT_NEAR(differences[0].range->low, -differences[2].range->high, 1e-12);
}

TEST(AllPairedDifferences, SayOnHowManyScenesEitherIsBetter) {
    const auto moody = paired_difference_of(twelve_scenes(), "moody", "even");
    ASSERT_TRUE(moody);
    EXPECT_EQ(moody->scenes, 12);
    EXPECT_EQ(moody->better, 6);
    EXPECT_EQ(moody->worse, 6);
    EXPECT_EQ(paired_difference_of(twelve_scenes(), "better", "even")->better, 12);
}

TEST(DifferencesCsv, HasALineAPairAndEmptyFieldsWithoutAnInterval) {
    const std::string heading =
        "method,other,difference,lo,hi,lo_of_all,hi_of_all,scenes,better,worse\n";
    EXPECT_EQ(differences_table().file({}), heading);
    const statistics::Interval range{0.125, 0.5}, of_all{0.0625, 0.75};
    EXPECT_EQ(differences_table().file(
                  {{"a", "b", 0.25, range, of_all, 9, 6, 3}, {"b", "a", -0.25, std::nullopt}}),
              heading + "a,b,0.25,0.125,0.5,0.0625,0.75,9,6,3\n" + "b,a,-0.25,,,,,0,0,0\n");
}

}  // namespace
}  // namespace ink::summary
