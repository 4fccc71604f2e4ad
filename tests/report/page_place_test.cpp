#include "report/page_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace ink::report {
namespace {

using testing::HasSubstr;
using testing::Not;

harness::Row row_of(const std::string& method, std::int64_t n_found, std::int64_t n_false) {
    harness::Row row;
    row.method = method;
    harness::LineScores lines;
    lines.cracks.n_drawn = 100;
    lines.cracks.n_beside = 50;
    lines.cracks.all = {n_found, 100};
    lines.offsets.all.add(0.5);
    lines.offsets.all.add(-0.25);
    lines.widths.all.add(2);
    lines.positives = {200, n_false};
    lines.bins = {{2, 30, 60, n_found, 100},
                  {1,
                   std::numeric_limits<double>::infinity(),
                   std::numeric_limits<double>::infinity(),
                   1,
                   4}};
    row.lines = lines;
    return row;
}

TEST(PlacePage, PoolsCountsOverViews) {
    const std::string html = place_html({row_of("mote4", 90, 3), row_of("mote4", 30, 1)});
    EXPECT_THAT(html, HasSubstr("<td>.500</td><td>.600</td>"));  // 100 of 200, 120 of 200
    EXPECT_THAT(html, HasSubstr(">.545</td>"));                  // their harmonic mean
    EXPECT_THAT(html, HasSubstr(">+0.12</td>"));                 // 0.125
    EXPECT_THAT(html, HasSubstr(">2.00</td><td>0.00</td>"));
    EXPECT_THAT(html, HasSubstr(">.010</td>"));  // 4 of 400
}

TEST(PlacePage, PutsBaselinesLastAndLeavesFailedRowsOut) {
    harness::Row failed = row_of("broken", 1, 1);
    failed.status = "out of memory";
    const std::string html = place_html({row_of("oracle", 100, 0), failed, row_of("mote2", 90, 3)});
    EXPECT_LT(html.find("mote2"), html.find("oracle"));
    EXPECT_THAT(html, Not(HasSubstr("broken")));
    EXPECT_EQ(place_html({failed}), "");
    EXPECT_EQ(place_html({}), "");
}

TEST(PlacePage, ShowsRecallPerBin) {
    const std::string html = bins_html({row_of("mote4", 90, 3), row_of("mote4", 30, 1)});
    EXPECT_THAT(html, HasSubstr("view_angle_deg"));
    EXPECT_THAT(html, HasSubstr("title=\"120 of 200 px\">.600</td>"));
    EXPECT_THAT(html, HasSubstr("<th scope=\"col\">sky</th>"));
    EXPECT_THAT(html, HasSubstr("title=\"2 of 8 px\">.250</td>"));
    EXPECT_THAT(html, Not(HasSubstr("dihedral_deg")));
}

}  // namespace
}  // namespace ink::report
