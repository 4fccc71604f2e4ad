#include "report/text/diff_text.h"

#include <gmock/gmock.h>

namespace ink::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

experiment::MethodDiff changed_method() {
    experiment::MethodDiff method;
    method.method = "mote4";
    method.settings = "threshold 20 -> 25";
    method.cells = 12;
    method.changed_images = 11;
    method.changed_scores = 10;
    method.f = {0.91, 0.9, -0.01, statistics::Interval{-0.012, -0.008}};
    method.time_ratio = 0.5;
    return method;
}

experiment::MethodDiff same_method() {
    experiment::MethodDiff method;
    method.method = "ids";
    method.cells = 12;
    return method;
}

TEST(DiffText, SaysWhatChangedAndCountsWhatDidNot) {
    experiment::RunDiff diff;
    diff.methods = {changed_method(), same_method()};
    diff.asked = {{"methods.mote4.threshold", "20", "25"}};
    EXPECT_THAT(diff_text(diff),
                AllOf(HasSubstr("methods.mote4.threshold: 20 -> 25"),
                      HasSubstr("-.010 [-.012, -.008]"),
                      HasSubstr("x 0.50"),
                      HasSubstr("threshold 20 -> 25; worse"),
                      HasSubstr("1 methods are the same"),
                      Not(HasSubstr("ids"))));
}

TEST(DiffText, HasSoftFWhereBothRunsHaveIt) {
    experiment::RunDiff diff;
    diff.methods = {changed_method()};
    EXPECT_THAT(diff_text(diff), Not(HasSubstr("soft F")));
    diff.methods[0].soft_f = {0.7, 0.75, 0.05, std::nullopt};
    EXPECT_THAT(diff_text(diff),
                AllOf(HasSubstr("soft F before"), HasSubstr(".750"), HasSubstr("+.050")));
}

TEST(DiffText, IsShortWhereNothingDiffers) {
    experiment::RunDiff diff;
    diff.methods = {same_method()};
    EXPECT_EQ(diff_text(diff), "Nothing differs: 0 cells of 1 methods\n");
}

TEST(DiffText, SaysWhyTimesAreMissing) {
    experiment::RunDiff diff;
    diff.methods = {changed_method()};
    diff.times_obstacle = "the processor differs: one, two";
    EXPECT_THAT(diff_text(diff),
                AllOf(HasSubstr("Times do not compare: the processor differs: one, two"),
                      Not(HasSubstr("x 0.50"))));
}

}  // namespace
}  // namespace ink::report
