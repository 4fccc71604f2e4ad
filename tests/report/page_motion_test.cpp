#include "report/page_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "report/motion_chart.h"
#include "report/page.h"
#include "studies/motion_table.h"
#include "tests/report/made_up_report.h"
#include "tests/report/markup.h"

namespace ink::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

studies::MotionRow made_up_row(const std::string& method, const std::string& scene) {
    studies::MotionRow row{.scene = scene, .path = "orbit", .method = method, .params = "k=1"};
    row.width_px = 640;
    row.height_px = 360;
    row.frames = 10;
    row.step_px = 0.25;
    row.flicker = {.appeared = 30, .disappeared = 20, .excused = 7, .n_counted = 10'000};
    row.pops = {.pops = 2, .runs = 5, .steps = 60};
    row.lives = {4, 0, 1, 1};
    row.lives_cut = 2;
    row.images_hash = "abc";
    return row;
}

std::vector<studies::MotionRow> some_rows() {
    std::vector<studies::MotionRow> rows = {made_up_row("mote4", "torus"),
                                            made_up_row("mote4", "knot <i>"),
                                            made_up_row("decaudin", "torus"),
                                            made_up_row("decaudin", "knot <i>")};
    rows[3].status = "out of, ink";
    return rows;
}

TEST(MotionTable, IsEmptyBehindTheSequenceWhereACellFailed) {
    studies::MotionRow row = made_up_row("mote4", "torus");
    EXPECT_EQ(studies::motion_line(4, row), "4,10,60,0.25,0.005,30,20,7,10000,2,2,5,60,6,2,1\n");
    EXPECT_EQ(studies::life_lines(4, row), "4,1,4\n4,3,1\n4,4,1\n");
    row.status = "failed";
    EXPECT_EQ(studies::motion_line(4, row), "4,10,60,0.25,,,,,,,,,,,,\n");
}

TEST(MotionTotals, PoolCountsAndLeaveFailuresOut) {
    const auto totals = studies::motion_totals(some_rows());
    ASSERT_EQ(totals.size(), 2U);
    EXPECT_EQ(totals[0].method, "mote4");
    EXPECT_EQ(totals[0].sequences, 2);
    EXPECT_EQ(totals[0].frames, 20);
    EXPECT_EQ(totals[0].flicker.n_counted, 20'000);
    EXPECT_EQ(totals[0].pops.pops, 4);
    EXPECT_EQ(totals[0].lives, (std::vector<std::int64_t>{8, 0, 2, 2}));
    EXPECT_EQ(totals[0].false_lines(), 12);
    EXPECT_EQ(totals[1].sequences, 1);
    EXPECT_EQ(totals[1].failed, 1);
    EXPECT_TRUE(studies::motion_totals({}).empty());
}

TEST(MotionFaults, NameATruthThatIsNotPerfect) {
    studies::MotionRow row = made_up_row("oracle", "torus");
    EXPECT_EQ(studies::motion_faults({row}).size(), 1U);
    row.lives.clear();
    row.pops.pops = 0;
    EXPECT_THAT(studies::motion_faults({row}).front(), HasSubstr("50 px of flicker"));
    row.flicker = {.excused = 9, .n_counted = 100};
    EXPECT_TRUE(studies::motion_faults({row}).empty());
    EXPECT_TRUE(studies::motion_faults(some_rows()).empty()) << "methods may be as bad as they are";
}

TEST(LivesByClass, SumsUpFramesByTheChartsClasses) {
    EXPECT_EQ(lives_by_class({1, 2, 4, 8, 0, 0, 16, 32, 64}),
              (std::array<std::int64_t, 4>{1, 6, 24, 96}));
    EXPECT_EQ(lives_by_class({}), (std::array<std::int64_t, 4>{}));
}

TEST(MotionChart, HasABarPerMethodAndScore) {
    const std::string svg =
        motion_chart(studies::motion_totals(some_rows())).inline_element("motion");
    EXPECT_EQ(nesting_error(svg), "");
    EXPECT_THAT(svg, HasSubstr(">5</text>")) << "per mille";
    EXPECT_THAT(svg, HasSubstr("<title>appeared: 60 px</title>"));
    EXPECT_THAT(svg, HasSubstr("<title>4 pops of 10 features</title>"));
    EXPECT_THAT(svg, HasSubstr(">120</text>")) << "pops per feature and minute";
    EXPECT_THAT(svg, HasSubstr("<title>1 frame: 8 lines</title>"));
    EXPECT_THAT(svg, HasSubstr(">0.6</text>")) << "false lines per frame";
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(motion_chart({}).inline_element("x"), HasSubstr("No sequence was drawn."));
}

TEST(MotionHtml, EscapesNamesAndShowsFailures) {
    const std::string html = motion_html(some_rows(), {});
    EXPECT_EQ(nesting_error(html), "");
    EXPECT_THAT(html, AllOf(HasSubstr("knot &lt;i&gt;"), Not(HasSubstr("knot <i>"))));
    EXPECT_THAT(html, HasSubstr("title=\"out of, ink\"><strong>failed</strong>"));
    EXPECT_THAT(html, HasSubstr("<td>5.00</td>"));
    EXPECT_THAT(html, Not(HasSubstr("The cube roll")));
    EXPECT_EQ(motion_html({}, {}), "");
}

TEST(MotionHtml, SaysWhereCreasesMustVanishAndDid) {
    studies::RollCurve curve{.method = "m&m", .params = "", .crease = 0, .is_predicted = true};
    curve.samples = {{.length_px = 10, .covered_px = 10}, {.length_px = 10, .is_blind = true}};
    curve.vanishing = {{0.5, 0.51, 0.0}, {1.5, std::nullopt, 0.25}};
    studies::RollCurve blind = curve;
    blind.crease = 1;
    blind.vanishing.clear();
    blind.samples = {{.length_px = 10, .is_blind = true}};
    const std::string html = motion_html({}, {curve, blind});
    EXPECT_EQ(nesting_error(html), "");
    EXPECT_THAT(html, HasSubstr("m&amp;m"));
    EXPECT_THAT(html, HasSubstr("28.6°<small>at 29.2°</small>"));
    EXPECT_THAT(html, HasSubstr("85.9°<small>recall 0.25 there</small>"));
    EXPECT_THAT(html, HasSubstr("<td>at every angle</td>"));
}

TEST(ReportPage, HasAPartOnMotionIfItWasStudied) {
    ReportData data = made_up_report({});
    EXPECT_THAT(report_page(data), Not(HasSubstr("id=\"motion\"")));
    data.motion = some_rows();
    const std::string page = report_page(data);
    EXPECT_THAT(page, AllOf(HasSubstr("id=\"motion\""), HasSubstr("href=\"#motion\"")));
    EXPECT_EQ(nesting_error(page), "");
}

}  // namespace
}  // namespace ink::report
