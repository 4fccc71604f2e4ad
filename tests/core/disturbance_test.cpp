#include "core/disturbance.h"

#include <gtest/gtest.h>

#include "core/parallel.h"

namespace {

using namespace ink;

TEST(Disturbance, IsARatioOfTimesForAnyNumberOfNeighbours) {
    // What it is depends on the machine; that its neighbours begin and end does not.
    for (const int others : {0, 1, core::hardware_threads() + 1}) {
        const double ratio = core::measure_disturbance(others);
        EXPECT_GT(ratio, 0) << others;
        EXPECT_LT(ratio, 1e6) << others;
    }
}

}  // namespace
