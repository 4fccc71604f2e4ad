#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "core/parallel.h"
#include "core/quiet_gate.h"

namespace {

using namespace ink::core;

/// Long enough for others to do something, if they were to.
void dawdle() {
    for (int i = 0; i < 10; ++i)
        std::this_thread::yield();
}

/// How many threads are at work, and whether any was where one had to be alone.
struct Watch {
    std::atomic<int> busy = 0;
    std::atomic<int> disturbed = 0;
    std::atomic<int> alone = 0;

    void work() {
        ++busy;
        dawdle();
        --busy;
    }
    void work_alone() {
        run_alone([&] {
            ++alone;
            disturbed += busy != 0;
            ++busy;
            dawdle();
            disturbed += busy != 1;
            --busy;
        });
    }
};

class RunAlone : public testing::TestWithParam<int> {};

TEST_P(RunAlone, OthersStandStillBetweenTheirSteps) {
    Watch watch;
    run_lanes(GetParam(), [&](int) {
        for (int i = 0; i < 10; ++i) {
            parallel_for(5, hardware_threads(), [&](std::size_t) { watch.work(); });
            watch.work_alone();
        }
    });
    EXPECT_EQ(watch.alone, 10 * GetParam());
    EXPECT_EQ(watch.disturbed, 0);
}

TEST_P(RunAlone, WaitsForNobodyWhoHasEnded) {
    Watch watch;
    run_lanes(GetParam(), [&](int lane) {
        for (int i = 0; i < lane; ++i)
            watch.work_alone();
    });
    EXPECT_EQ(watch.alone, GetParam() * (GetParam() - 1) / 2);
    EXPECT_EQ(watch.disturbed, 0);
}

TEST_P(RunAlone, LetsOthersGoOnWhenItThrows) {
    Watch watch;
    std::atomic<int> thrown = 0;
    run_lanes(GetParam(), [&](int lane) {
        for (int i = 0; i < 5; ++i) {
            try {
                run_alone([&] {
                    watch.work();
                    if (lane == 0) throw std::runtime_error("broken");
                });
            } catch (const std::runtime_error&) {
                ++thrown;
            }
            watch.work_alone();
        }
    });
    EXPECT_EQ(thrown, 5);
    EXPECT_EQ(watch.alone, 5 * GetParam());
    EXPECT_EQ(watch.disturbed, 0);
}

TEST_P(RunAlone, ALaneThatThrowsHoldsNobodyUp) {
    Watch watch;
    EXPECT_THROW(run_lanes(GetParam(),
                           [&](int lane) {
                               watch.work_alone();
                               if (lane == 0) throw std::runtime_error("broken");
                               watch.work_alone();
                           }),
                 std::runtime_error);
    EXPECT_EQ(watch.alone, 2 * GetParam() - 1);
    EXPECT_EQ(watch.disturbed, 0);
}

TEST_P(RunAlone, LoopsWithinItHaveTheWholeMachine) {
    std::atomic<int> calls = 0;
    run_lanes(GetParam(), [&](int) {
        run_alone([&] {
            EXPECT_EQ(share_of_threads(), hardware_threads());
            parallel_for(40, hardware_threads(), [&](std::size_t) {
                run_alone([&] { ++calls; });  // is alone already
            });
        });
    });
    EXPECT_EQ(calls, 40 * GetParam());
}

INSTANTIATE_TEST_SUITE_P(Lanes, RunAlone, testing::Values(1, 2, 3, 8));

TEST_P(RunAlone, OneAtATimeIsAloneWhereOthersWorkOn) {
    std::atomic<int> alone = 0, most = 0, calls = 0;
    run_lanes(
        GetParam(),
        [&](int) {
            for (int i = 0; i < 10; ++i) {
                run_alone([&] {
                    most = std::max(most.load(), ++alone);
                    run_alone(dawdle);  // is alone already
                    ++calls;
                    --alone;
                });
            }
        },
        Others::work_on);
    EXPECT_EQ(calls, 10 * GetParam());
    EXPECT_EQ(most, 1);
}

TEST_P(RunAlone, OthersWorkOnMeanwhile) {
    std::atomic<int> steps = 0;
    run_lanes(
        GetParam(),
        [&](int lane) {
            if (lane > 0) {
                parallel_for(10, hardware_threads(), [&](std::size_t) { ++steps; });
                return;
            }
            run_alone([&] {
                while (steps < 10 * (GetParam() - 1))
                    std::this_thread::yield();  // for ever, if they stood still
            });
        },
        Others::work_on);
    EXPECT_EQ(steps, 10 * (GetParam() - 1));
}

TEST(RunAlone, KeepsItsShareOfTheMachineWhereOthersWorkOn) {
    std::atomic<int> here = 0;
    run_lanes(
        2,
        [&](int) {
            ++here;
            run_alone([&] {
                while (here < 2)
                    std::this_thread::yield();
                EXPECT_EQ(share_of_threads(), std::max(1, hardware_threads() / 2));
            });
            ++here;
            while (here < 4)
                std::this_thread::yield();  // else the other would have the whole machine
        },
        Others::work_on);
}

TEST(RunAlone, IsAPlainCallOutsideOfLanes) {
    const double before_s = waited_s();
    const auto caller = std::this_thread::get_id();
    run_alone([&] { EXPECT_EQ(std::this_thread::get_id(), caller); });
    ink::core::pause();
    EXPECT_EQ(waited_s(), before_s);
}

/// Threads that work for one another, as a loop's do: the one that waits for them is outside.
TEST(QuietGate, ThreadsThatAreWaitedForPauseToo) {
    QuietGate gate(2);
    Watch watch;
    std::atomic<int> disturbed = 0;
    const auto helper = [&] {
        gate.enter();
        for (int i = 0; i < 50; ++i) {
            watch.work();
            if (gate.is_closed()) gate.pause();
        }
        gate.leave();
    };
    std::thread looping([&] {
        gate.leave();
        std::thread one(helper), two(helper);
        one.join();
        two.join();
        gate.enter();
        gate.leave();
    });
    for (int i = 0; i < 20; ++i) {
        gate.begin_alone();
        disturbed += watch.busy != 0;
        dawdle();
        disturbed += watch.busy != 0;
        gate.end_alone();
        std::this_thread::yield();
    }
    gate.leave();
    looping.join();
    EXPECT_EQ(disturbed, 0);
}

}  // namespace
