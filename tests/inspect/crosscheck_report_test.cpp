#include "inspect/crosscheck_report.h"

#include <gmock/gmock.h>

namespace ink::inspect {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A check of 100 px of contours, of which so many are the truth's alone.
harness::Crosscheck check(double lacking_px) {
    harness::Crosscheck check;
    harness::ClassAgreement& contours = check.agreement.by_class[0];
    contours.truth_px = contours.crosscheck_px = 100;
    contours.truth_covered_px = 100 - lacking_px;
    contours.crosscheck_covered_px = 100;
    return check;
}

TEST(CrosscheckSummary, DoesNotReadAFailedCheckAsAConfirmation) {
    ASSERT_FALSE(check(10).agreement.is_agreed());
    EXPECT_THAT(crosscheck_summary(check(10), {}),
                AllOf(HasSubstr("disagreement 5.000 % of both lengths, where a third construction "
                                "sides against the truth"),
                      HasSubstr("disagree\n"),
                      Not(HasSubstr("confirmed"))));
}

TEST(CrosscheckSummary, SaysThatNothingIsApart) {
    ASSERT_TRUE(check(0).agreement.is_agreed());
    EXPECT_THAT(crosscheck_summary(check(0), {}),
                AllOf(HasSubstr("disagreement 0.000 %"), Not(HasSubstr("disagree\n"))));
}

}  // namespace
}  // namespace ink::inspect
