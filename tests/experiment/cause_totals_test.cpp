#include "experiment/summary/cause_totals.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "draw/palette.h"
#include "report/cause_chart.h"
#include "report/page_causes.h"

namespace ink::experiment {
namespace {

using score::Cause;
using testing::HasSubstr;
using testing::Not;

harness::Row row_of(const std::string& method,
                    std::int64_t false_negatives,
                    std::int64_t false_positives) {
    harness::Row row;
    row.method = method;
    row.n_truth = 1000;
    row.n_pred = 500;
    row.false_negatives = false_negatives;
    row.false_positives = false_positives;
    row.unmatched_truth = 10;
    row.unmatched_duplicates = 20;
    score::CauseCounts& causes = row.causes.emplace();
    causes[Cause::cancelled] = false_negatives - 1;
    causes[Cause::thinned] = 1;
    causes[Cause::other] = false_positives;
    return row;
}

TEST(CauseTotals, AddRowsOfAMethodUp) {
    harness::Row failed = row_of("a", 900, 400);
    failed.status = "out of memory";
    const auto totals =
        cause_totals({row_of("a", 100, 50), row_of("b", 30, 5), failed, row_of("a", 200, 0)});
    ASSERT_EQ(totals.size(), 2U);
    EXPECT_EQ(totals[0].method, "a");
    EXPECT_EQ(totals[0].n_truth, 2000);
    EXPECT_EQ(totals[0].n_pred, 1000);
    EXPECT_EQ(totals[0].false_negatives, 300);
    EXPECT_EQ(totals[0].false_positives, 50);
    EXPECT_EQ(totals[0].unmatched_truth, 20);
    EXPECT_EQ(totals[0].unmatched_duplicates, 40);
    EXPECT_EQ(totals[0].causes[Cause::cancelled], 298);
    EXPECT_EQ(totals[0].causes[Cause::thinned], 2);
    EXPECT_EQ(totals[0].causes[Cause::other], 50);
    EXPECT_EQ(totals[1].method, "b");
}

TEST(CauseTotals, KeepSampledOfTheBaselinesAndPutItLast) {
    const auto totals = cause_totals({row_of("sampled", 1, 0),
                                      row_of("none", 1000, 0),
                                      row_of("oracle", 1, 0),
                                      row_of("a", 1, 0)});
    ASSERT_EQ(totals.size(), 2U);
    EXPECT_EQ(totals[0].method, "a");
    EXPECT_EQ(totals[1].method, "sampled");
}

TEST(CauseTotals, EveryCauseHasWordsAndAColourOfItsOwn) {
    std::set<std::string> labels;
    std::set<std::string_view> meanings;
    std::set<std::string_view> colours;
    for (std::size_t i = 0; i < score::kCauseCount; ++i) {
        const auto cause = static_cast<Cause>(i);
        labels.insert(label_of(cause));
        meanings.insert(meaning_of(cause));
        const draw::Colour colour = draw::colour_of(cause);
        colours.insert(colour.hex);
        EXPECT_EQ(fmt::format("#{:02x}{:02x}{:02x}", colour.rgb.r, colour.rgb.g, colour.rgb.b),
                  colour.hex);
    }
    EXPECT_EQ(labels.size(), 11U);
    EXPECT_EQ(meanings.size(), 11U);
    EXPECT_EQ(colours.size(), 11U);
}

TEST(CauseTable, ShowsCountsWithTheirShares) {
    const std::string table = report::cause_table_html(cause_totals({row_of("a<b", 101, 50)}));
    EXPECT_THAT(table, HasSubstr("a&lt;b"));
    EXPECT_THAT(table, HasSubstr("<td>101<small>10.1 %</small></td>")) << "missing of 1000 true";
    EXPECT_THAT(table, HasSubstr("<td>100<small>10.0 %</small></td>")) << "cancelled";
    EXPECT_THAT(table, HasSubstr("<td>50<small>10.0 %</small></td>")) << "off line of 500 drawn";
    EXPECT_THAT(table, HasSubstr("<td>–</td>")) << "no pixel is a dash";
    EXPECT_THAT(report::cause_table_html({}), HasSubstr("No method"));
}

TEST(CauseChart, NamesEachPieceAndItsShare) {
    const std::string svg = report::cause_chart(cause_totals({row_of("a", 101, 50)})).file("t");
    EXPECT_THAT(svg, HasSubstr("<title>cancelled: 100 px, 10.00 %</title>"));
    EXPECT_THAT(svg, HasSubstr("<title>thinned: 1 px, 0.10 %</title>"));
    EXPECT_THAT(svg, HasSubstr("<title>other: 50 px, 10.00 %</title>"));
    EXPECT_THAT(svg,
                HasSubstr("<title>unmatched truth beside a drawn line: 10 px, 1.00 %</title>"));
    EXPECT_THAT(svg, HasSubstr("11.1 %")) << "false negatives and unmatched truth";
    EXPECT_THAT(svg, HasSubstr("14.0 %")) << "false positives and unmatched duplicates";
    EXPECT_THAT(svg, Not(HasSubstr("sub pixel"))) << "nothing of it";
    EXPECT_THAT(report::cause_chart({}).file("t"), HasSubstr("No method"));
}

}  // namespace
}  // namespace ink::experiment
