#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using namespace ink::core;

TEST(Lanes, RunEachOnAThreadOfItsOwn) {
    std::vector<std::thread::id> threads(3);
    std::vector<int> lanes(3, -1);
    run_lanes(3, [&](int lane) {
        threads[static_cast<std::size_t>(lane)] = std::this_thread::get_id();
        lanes[static_cast<std::size_t>(lane)] = this_lane();
    });
    EXPECT_EQ(lanes, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(std::set(threads.begin(), threads.end()).size(), 3U);
    EXPECT_EQ(this_lane(), 0);
}

TEST(Lanes, OneIsTheCallingThreadWithAllThreads) {
    run_lanes(1, [&, caller = std::this_thread::get_id()](int) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_EQ(share_of_threads(), hardware_threads());
    });
}

TEST(Lanes, ShareTheMachineAmongThoseThatRun) {
    const int lanes = 2 * hardware_threads();
    std::atomic<int> begun = 0;
    run_lanes(lanes, [&](int) {
        ++begun;
        while (begun < lanes)
            std::this_thread::yield();
        if (this_lane() != 0) return;
        while (share_of_threads() < hardware_threads())
            std::this_thread::yield();  // until the others have ended
    });
    EXPECT_EQ(share_of_threads(), hardware_threads());
}

TEST(Lanes, KeepALoopOnTheirThreadWhileAllAreBusy) {
    const int lanes = hardware_threads() + 1;
    std::atomic<int> looped = 0;
    run_lanes(lanes, [&](int) {
        const auto own = std::this_thread::get_id();
        parallel_for(50, hardware_threads(), [&](std::size_t) {
            EXPECT_EQ(std::this_thread::get_id(), own);
        });
        ++looped;
        while (looped < lanes)
            std::this_thread::yield();
    });
}

TEST(Lanes, PassOnWhatOneThrows) {
    std::atomic<int> ended = 0;
    EXPECT_THROW(run_lanes(3,
                           [&](int lane) {
                               ++ended;
                               if (lane == 1) throw std::runtime_error("broken");
                           }),
                 std::runtime_error);
    EXPECT_EQ(ended, 3);
}

TEST(ParallelFor, CallsEachOnce) {
    std::vector<int> calls(1000);
    parallel_for(calls.size(), 2, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(1000, 1));
}

}  // namespace
