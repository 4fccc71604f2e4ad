#include "report/page_skips.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/summary/skip_totals.h"
#include "harness/skip_switches.h"
#include "report/page.h"
#include "tests/report/made_up_report.h"
#include "tests/report/markup.h"

namespace ink::report {
namespace {

using raster::Skip;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr auto kHidden = static_cast<std::size_t>(Skip::occlusion_culling);
constexpr auto kBacks = static_cast<std::size_t>(Skip::back_face_culling);

harness::Row counting_row(const std::string& method,
                          const std::string& scene,
                          raster::SkipCount hidden) {
    harness::Row row;
    row.method = method;
    row.scene = scene;
    row.view = "front";
    row.skips_off = "temporal_reuse";
    row.skips.emplace();
    (*row.skips)[kHidden] = hidden;
    return row;
}

std::vector<harness::Row> some_rows() {
    std::vector<harness::Row> rows = {counting_row("mote4", "torus", {10, 100}),
                                      counting_row("decaudin", "torus", {0, 100}),
                                      counting_row("mote4", "knot <i>", {80, 200}),
                                      counting_row("mote4", "failed", {100, 100}),
                                      counting_row("none", "torus", {})};
    rows[3].status = "out of ink";
    rows[4].skips.reset();
    return rows;
}

TEST(SkipTotals, PoolCountsAndKnowWhereMostWasSkipped) {
    const std::vector<harness::Row> rows = some_rows();
    const auto totals = experiment::skip_totals(rows);
    ASSERT_EQ(totals.size(), 2U) << "no baseline";
    EXPECT_EQ(totals[0].method, "mote4");
    EXPECT_EQ(totals[0].of_skip[kHidden].count.skipped, 90U);
    EXPECT_EQ(totals[0].of_skip[kHidden].count.of, 300U);
    EXPECT_EQ(totals[0].of_skip[kHidden].most, &rows[2]) << "40 % there, 10 % on the torus";
    EXPECT_EQ(totals[0].of_skip[kBacks].most, nullptr) << "it applies nowhere";
    EXPECT_EQ(totals[1].of_skip[kHidden].most, &rows[1]);
    EXPECT_TRUE(experiment::skip_totals({}).empty());
}

TEST(ShareOf, NothingToDoIsNothing) {
    EXPECT_EQ(experiment::share_of({0, 0}), 0);
    EXPECT_EQ(experiment::share_of({1, 4}), 0.25);
}

studies::SkipTime timed(std::optional<Skip> skip, studies::SkipArm arm, std::int64_t min_ns) {
    studies::SkipTime time;
    time.scene = skip ? "behind_a_wall" : "view_empty";
    time.skip = skip;
    time.method = "mote4";
    time.arm = arm;
    time.triangles = 81922;
    time.draw_ns = 2 * min_ns;
    time.draw_ns_min = min_ns;
    time.counts[kHidden] = {arm == studies::SkipArm::on ? 75U : 0U, 100};
    return time;
}

std::vector<studies::SkipTime> some_study() {
    return {timed(Skip::occlusion_culling, studies::SkipArm::on, 2'000'000),
            timed(Skip::occlusion_culling, studies::SkipArm::one_off, 5'000'000),
            timed(Skip::occlusion_culling, studies::SkipArm::all_off, 9'000'000),
            timed(std::nullopt, studies::SkipArm::on, 1'000'000),
            timed(std::nullopt, studies::SkipArm::all_off, 8'000'000)};
}

TEST(SkipsHtml, SaysWhatShareWasSkippedAndWhereMost) {
    const std::string html = skips_html(some_rows(), {});
    EXPECT_EQ(nesting_error(html), "");
    EXPECT_THAT(html, HasSubstr("<td>30.0 %<small>40.0 %<br>knot &lt;i&gt;<br>front</small></td>"));
    EXPECT_THAT(html, HasSubstr("Not allowed while these rows were timed: temporal_reuse."));
    EXPECT_THAT(html, HasSubstr("--skip-study")) << "how to measure what it is worth";
    EXPECT_THAT(html, Not(HasSubstr("behind_a_wall")));
}

TEST(SkipsHtml, SaysWhatEachIsWorthByTheLeastTimes) {
    const std::string html = skips_html(some_rows(), some_study());
    EXPECT_EQ(nesting_error(html), "");
    EXPECT_THAT(html,
                HasSubstr("occlusion_culling</th><td class=\"text\">behind_a_wall<small>81922 "
                          "triangles</small></td>"));
    EXPECT_THAT(html,
                HasSubstr("<b>× 2.50</b><small>5.00 → 2.00 ms</small><small>75.0 % skipped<br>no "
                          "skips: 9.00 ms</small>"));
    EXPECT_THAT(html, HasSubstr("<b>× 8.00</b><small>8.00 → 1.00 ms</small></td>"));
    EXPECT_THAT(html, Not(HasSubstr("--skip-study")));
}

TEST(SkipsHtml, NeitherBoastsNorHidesWhatFailed) {
    auto study = some_study();
    study[1].draw_ns_min = 2'020'000;
    EXPECT_THAT(skips_html(some_rows(), study), HasSubstr("<td>× 1.01<small>"));
    study[0].counts[kHidden].skipped = 0;
    EXPECT_THAT(skips_html(some_rows(), study),
                HasSubstr("<td>0<small>2.00 ms</small><small>nothing skipped"));
    study[1].status = "differs: \"so\"";
    const std::string html = skips_html(some_rows(), study);
    EXPECT_THAT(html, HasSubstr("title=\"differs: &quot;so&quot;\"><strong>failed</strong>"));
    study = some_study();
    for (studies::SkipTime& time : study)
        time.counts[kHidden] = {};
    EXPECT_THAT(skips_html(some_rows(), study), HasSubstr("nothing of the kind to skip"));
}

TEST(SkipsHtml, IsNothingWhereNobodyCounts) {
    EXPECT_EQ(skips_html({}, {}), "");
    EXPECT_EQ(skips_html(made_up_report({}).rows, {}), "");
}

TEST(ReportPage, HasAPartOnSkipsWhereThereAreCounts) {
    ReportData data = made_up_report({});
    EXPECT_THAT(report_page(data), Not(HasSubstr("id=\"skips\"")));
    for (harness::Row& row : data.rows) {
        if (row.draw_ns) row.skips.emplace();
    }
    data.skip_study = some_study();
    const std::string page = report_page(data);
    EXPECT_THAT(page, AllOf(HasSubstr("id=\"skips\""), HasSubstr("href=\"#skips\"")));
    EXPECT_EQ(nesting_error(page), "");
}

}  // namespace
}  // namespace ink::report
