#include "core/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using namespace ink::core;

TEST(Lanes, RunEachOnAThreadOfItsOwn) {
    std::mutex mutex;
    std::set<std::thread::id> threads;
    run_lanes(3, [&] {
        const std::lock_guard lock(mutex);
        threads.insert(std::this_thread::get_id());
    });
    EXPECT_EQ(threads.size(), 3U);
}

TEST(Lanes, OneIsTheCallingThreadWithAllThreads) {
    run_lanes(1, [&, caller = std::this_thread::get_id()] {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_EQ(share_of_threads(), hardware_threads());
    });
}

TEST(Lanes, ShareTheMachineAmongThoseThatRun) {
    const int lanes = 2 * hardware_threads();
    std::atomic<int> begun = 0;
    run_lanes(lanes, [&] {
        const bool is_last = ++begun == lanes;
        while (begun < lanes)
            std::this_thread::yield();
        while (is_last && share_of_threads() < hardware_threads())
            std::this_thread::yield();  // until the others have ended
    });
    EXPECT_EQ(share_of_threads(), hardware_threads());
}

TEST(Lanes, KeepALoopOnTheirThreadWhileAllAreBusy) {
    const int lanes = hardware_threads() + 1;
    std::atomic<int> looped = 0;
    run_lanes(lanes, [&] {
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
                           [&] {
                               if (++ended == 2) throw std::runtime_error("broken");
                           }),
                 std::runtime_error);
    EXPECT_EQ(ended, 3);
    EXPECT_EQ(share_of_threads(), hardware_threads());
}

TEST(ParallelFor, CallsEachOnce) {
    std::vector<int> calls(1000);
    parallel_for(calls.size(), 2, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(1000, 1));
}

TEST(ParallelFor, MayBeWithinAnother) {
    std::vector<std::atomic<int>> calls(20);
    parallel_for(calls.size(), 2, [&](std::size_t i) {
        parallel_for(30, 2, [&](std::size_t) { ++calls[i]; });
    });
    for (const std::atomic<int>& count : calls)
        EXPECT_EQ(count, 30);
}

}  // namespace
