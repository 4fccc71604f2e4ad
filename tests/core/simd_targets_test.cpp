#include "core/simd.h"

#include <gtest/gtest.h>

#include <hwy/highway.h>
#include <cstdio>
#include <vector>

namespace ink::core {
namespace {

/// Highway's targets are bits; a better one has a lower bit.
std::int64_t best_of(std::int64_t targets) {
    return targets & -targets;
}

TEST(SimdTargets, EveryOneThatWasCompiledAndThisMachineHasIsRun) {
    const std::int64_t supported = hwy::SupportedTargets();
    std::int64_t run = 0;
    std::printf("SIMD targets run:");
    for (const SimdTarget& target : simd_targets()) {
        const ForcedSimdTarget forced(target);
        EXPECT_EQ(current_simd_target().bit, target.bit);
        EXPECT_EQ(hwy::SupportedTargets(), target.bit);
        run |= target.bit;
        std::printf(" %s", target.name.c_str());
    }
    std::printf("\n");
    EXPECT_EQ(run, supported & HWY_TARGETS);
    // Newer Highways emulate vectors of 128 bits where older ones have single numbers.
    EXPECT_NE(run & (HWY_SCALAR | HWY_EMU128), 0) << "the target that the others must equal";
}

TEST(SimdTargets, TheMachineHasNoneBetterThanTheBestRun) {
#ifndef NDEBUG
    GTEST_SKIP() << "skipped: the best targets are compiled where speed is measured (release)";
#endif
    const std::vector<SimdTarget> targets = simd_targets();
    ASSERT_FALSE(targets.empty());
    // Those above AVX3 have no more lanes, and shuffle bytes in ways that no kernel uses.
    const std::int64_t no_better = targets.front().bit == HWY_AVX3 ? HWY_AVX3 - 1 : 0;
    const std::int64_t better = hwy::SupportedTargets() & (targets.front().bit - 1) & ~no_better;
    EXPECT_EQ(better, 0) << "this machine has " << hwy::TargetName(best_of(better))
                         << ", kernels were compiled for " << targets.front().name << " at best";
}

TEST(SimdTargets, ForcingOneEndsWithItsScope) {
    const std::int64_t best = current_simd_target().bit;
    {
        const ForcedSimdTarget forced(simd_targets().back());
        EXPECT_EQ(current_simd_target().bit, simd_targets().back().bit);
    }
    EXPECT_EQ(current_simd_target().bit, best);
}

}  // namespace
}  // namespace ink::core
