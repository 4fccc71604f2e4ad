#include "report/page_cost.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/page.h"
#include "tests/report/made_up_report.h"
#include "tests/report/markup.h"

namespace ink::report {
namespace {

using testing::HasSubstr;
using testing::Not;

harness::Row cost_row(const std::string& method, std::int64_t measured_ns, double residual) {
    harness::Row row;
    row.method = method;
    method::Cost cost;
    cost.passes = 1;
    cost.interpolants = 3;
    cost.values_per_vertex = 2;
    cost.buffer_bytes_per_px = 5;
    cost.fill = {4, 5, 12};
    cost.filter = {1, 1, 17};
    row.cost = harness::CostFacts{cost, {}};
    row.draw_ns_min = measured_ns;
    row.predicted_ns = 2'000'000;
    row.cost_residual = residual;
    return row;
}

studies::ScalingPoint scaling_point(double x, std::int64_t ns) {
    studies::ScalingPoint point;
    point.method = "a<b";
    point.x = x;
    point.draw_ns_min = ns;
    point.covered_share = 0.25;
    point.width_px = 1280;
    point.height_px = 720;
    return point;
}

TEST(CostPage, PutsTheModelBesideTheTimeWithItsResidual) {
    ReportData data;
    data.rows = {cost_row("a<b", 3'000'000, -0.25),
                 cost_row("a<b", 4'000'000, 0.5),
                 cost_row("a<b", 9'000'000, 0.75)};
    data.cost_fit = {{1, 2, 3, 4, 5, 6, 0.125}, 3, "scene"};
    const std::string html = cost_html(data);
    EXPECT_EQ(nesting_error(html), "");
    EXPECT_THAT(html,
                HasSubstr("<th scope=\"row\">a&lt;b</th><td class=\"group\">1</td><td>2</td>"
                          "<td>3</td><td class=\"group\">9</td><td>12</td>"
                          "<td class=\"group\">7</td><td>17</td><td class=\"group\">4.00</td>"
                          "<td>2.00</td><td class=\"group\">+50.0 %</td>"
                          "<td class=\"range\">+12.5 % to +62.5 %</td>"));
    EXPECT_THAT(html, HasSubstr("left out all cells of its scene"));
    EXPECT_THAT(html, HasSubstr("<th scope=\"row\">byte</th><td>0.125</td>"));
}

TEST(CostPage, SaysThatNothingIsPredictedWithoutAFit) {
    ReportData data;
    data.rows = {cost_row("a", 3'000'000, 0)};
    data.rows[0].predicted_ns.reset();
    data.rows[0].cost_residual.reset();
    const std::string html = cost_html(data);
    EXPECT_THAT(html, HasSubstr("nothing is predicted"));
    EXPECT_THAT(html, HasSubstr("<td class=\"range\">-</td>"));
    EXPECT_THAT(html, Not(HasSubstr("nan")));
    EXPECT_EQ(cost_html({}), "");
}

TEST(CostPage, ShowsHowTimesGrowInWordsChartAndTable) {
    ReportData data;
    data.scaling = {scaling_point(100, 1'000'000),
                    scaling_point(1000, 2'000'000),
                    scaling_point(10000, 60'000'000)};
    const std::string html = scaling_html(data);
    EXPECT_EQ(nesting_error(html), "");
    EXPECT_THAT(
        html,
        HasSubstr("Worse than linear in 1 of 2 steps. The steepest: a&lt;b from 1000 to 10 k"));
    EXPECT_THAT(html, HasSubstr("A sphere that covers 25 % of 1280 x 720 px."));
    EXPECT_THAT(html, HasSubstr("<svg "));
    EXPECT_THAT(html, HasSubstr("<td>0.30</td><td><b>1.48</b></td>"));
    EXPECT_EQ(scaling_html({}), "");
}

TEST(ReportPage, HasTheSectionOnCostOnlyWhereAMethodDeclaresIt) {
    ReportData data = made_up_report({});
    EXPECT_THAT(report_page(data), Not(HasSubstr("id=\"cost\"")));
    data.rows.front().cost = cost_row("a", 1, 0).cost;
    EXPECT_THAT(report_page(data), HasSubstr("<section id=\"cost\"><h2>Cost</h2>"));
    EXPECT_EQ(nesting_error(report_page(data)), "");
}

}  // namespace
}  // namespace ink::report
