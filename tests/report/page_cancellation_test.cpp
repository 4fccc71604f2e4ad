#include "report/page_cancellation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/cancellation_chart.h"
#include "report/page.h"
#include "tests/report/made_up_report.h"
#include "tests/report/markup.h"

namespace ink::report {
namespace {

using testing::HasSubstr;
using testing::Not;
using truth::LineClass;

linear_code::CancellationRow made_up_row(const std::string& method,
                                         linear_code::LineKind kind,
                                         std::int64_t measured) {
    linear_code::CancellationRow row{
        .method = method, .scene = "knot", .view = "front", .split = "train"};
    row.silent_deg = 7.25;
    row.kind = kind;
    row.count = {1000, 250, measured, 200, 150, 100};
    return row;
}

std::vector<linear_code::CancellationRow> some_rows() {
    std::vector<linear_code::CancellationRow> rows = {
        made_up_row("mote4", {LineClass::crease, 90}, 260),
        made_up_row("mote4", {LineClass::boundary, std::nullopt}, 250),
        made_up_row("a <i> method", {LineClass::crease, 40}, 310),
        made_up_row("a <i> method", {LineClass::seam, 0}, 250),
    };
    rows[3].count.n_truth = kFewPixels - 1;
    return rows;
}

TEST(PageCancellation, SaysHowFarThePredictionIsOff) {
    const std::string html = cancellation_html(some_rows());
    EXPECT_THAT(html,
                HasSubstr("2 of 3 pairs of method and kind of line (class and ten degrees of "
                          "dihedral) agree within two points."));
    EXPECT_THAT(
        html,
        HasSubstr("Furthest off is a &lt;i&gt; method and crease of 40 to 50°: 25.0 % predicted, "
                  "31.0 % measured of 1000 px"));
    EXPECT_THAT(html, HasSubstr("One pair of fewer than 100 px is left out"));
    EXPECT_THAT(html, Not(HasSubstr("<i> method")));
    EXPECT_EQ(cancellation_html({}), "");
}

TEST(PageCancellation, HasALinePerMethodAndClass) {
    const std::string html = cancellation_html(some_rows());
    EXPECT_THAT(html,
                HasSubstr("<tr><th scope=\"row\">mote4</th><td>boundary</td><td>1000</td>"
                          "<td>25.00 %</td><td>25.00 %</td><td>+0.00</td><td>85.00 %</td></tr>"));
    EXPECT_THAT(html, HasSubstr("<td>25.00 %</td><td>26.00 %</td><td>-1.00</td>"));
}

TEST(CancellationChart, HasAPointPerKindWithEnoughPixels) {
    const std::string svg = cancellation_chart(some_rows()).file("misses");
    EXPECT_THAT(svg, HasSubstr("<title>mote4, crease, 90-100°: predicted 25.0 %, measured 26.0 %"));
    EXPECT_THAT(svg, HasSubstr("<title>mote4, boundary: predicted 25.0 %"));
    EXPECT_THAT(svg, Not(HasSubstr(", seam, ")));
    EXPECT_THAT(svg, HasSubstr("keeps dihedral deviations up to 7.2° silent"));
    EXPECT_THAT(cancellation_chart({}).file("misses"), HasSubstr("No method here declares a code"));
}

TEST(CancellationChart, HasNoLawForAMethodWhoseCodeDiffersByScene) {
    auto rows = some_rows();
    rows[0].silent_deg = 3;
    const std::string svg = cancellation_chart({rows[0], rows[1]}).file("misses");
    EXPECT_THAT(svg, Not(HasSubstr("silent")));
}

TEST(ReportPage, HasThePartOnCancellationWhereItWasStudied) {
    ReportData data = made_up_report({});
    EXPECT_THAT(report_page(data), Not(HasSubstr("id=\"cancellation\"")));
    data.cancellation = some_rows();
    const std::string page = report_page(data);
    EXPECT_THAT(page, HasSubstr("<a href=\"#cancellation\">"));
    EXPECT_THAT(page, HasSubstr("<section id=\"cancellation\">"));
    EXPECT_EQ(nesting_error(page), "");
}

}  // namespace
}  // namespace ink::report
