#include "core/interrupt.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

namespace ink::core {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// On a machine that does much else a thread may wake late.
constexpr double kLate_s = 3;

/// Work that never ends and asks nobody whether it should.
[[noreturn]] void work_for_ever() {
    static std::atomic<std::uint64_t> steps = 0;
    while (true)
        ++steps;
}

/// Whether a process is there, and not one that is dead and was not buried.
bool is_running(pid_t process) {
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    std::string number, name, state;
    return stat >> number >> name >> state && state != "Z" && state != "X";
}

class Interrupt : public testing::Test {
  protected:
    Interrupt() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
    ~Interrupt() override { std::filesystem::remove(file_); }

    /// Told by the test's process and by the one that dies in it.
    const std::filesystem::path file_ =
        std::filesystem::temp_directory_path() /
        (std::string("ink-interrupt-") +
         testing::UnitTest::GetInstance()->current_test_info()->name());
};
using InterruptDeath = Interrupt;

TEST_F(Interrupt, WorkThatEndsInTimeEndsInOrder) {
    {
        const InterruptGuard guard("never said");
        EXPECT_FALSE(is_interrupted());
        std::raise(SIGINT);
        EXPECT_TRUE(is_interrupted());
        bool is_written = false;
        write_unless_cut_off([&] { is_written = true; });
        EXPECT_TRUE(is_written);
    }
    // Long enough for the end that did not come.
    std::this_thread::sleep_for(std::chrono::duration<double>(kMostUntilEnd_s + 0.2));
    const InterruptGuard next;
    EXPECT_FALSE(is_interrupted()) << "of another work";
}

TEST_F(Interrupt, AGuardWithinAnotherForgetsNothing) {
    const InterruptGuard outer;
    std::raise(SIGTERM);
    { const InterruptGuard inner; }
    EXPECT_TRUE(is_interrupted());
}

TEST_F(InterruptDeath, WorkThatDoesNotEndIsCutOffAndSaysWhatIsLeft) {
    const auto begin = Clock::now();
    EXPECT_EXIT(
        {
            const InterruptGuard guard("it goes on");
            const InterruptGuard inner;
            std::raise(SIGINT);
            work_for_ever();
        },
        testing::ExitedWithCode(kInterrupted),
        "^inkbench: interrupted; it goes on\n$");
    EXPECT_LT(seconds_since(begin), kMostUntilEnd_s + kLate_s);
}

TEST_F(InterruptDeath, WhatIsDoneIsSavedBesideWorkThatDoesNotEnd) {
    EXPECT_EXIT(
        {
            const InterruptGuard outer("it goes on");
            const InterruptGuard guard({}, [&] { std::ofstream(file_) << "saved"; });
            std::raise(SIGINT);
            work_for_ever();
        },
        testing::ExitedWithCode(kInterrupted),
        "it goes on");
    std::string word;
    std::ifstream(file_) >> word;
    EXPECT_EQ(word, "saved");
}

TEST_F(InterruptDeath, ASaveThatDoesNotEndIsCutOffToo) {
    const auto begin = Clock::now();
    EXPECT_EXIT(
        {
            const InterruptGuard guard("it goes on", work_for_ever);
            std::raise(SIGINT);
            work_for_ever();
        },
        testing::ExitedWithCode(kInterrupted),
        "it goes on");
    EXPECT_LT(seconds_since(begin), kMostUntilEnd_s + kLate_s);
}

TEST_F(InterruptDeath, NobodyWritesBesideASave) {
    EXPECT_EXIT(
        {
            std::atomic<bool> is_saving = false;
            const InterruptGuard guard("it goes on", [&] {
                is_saving = true;
                std::ofstream(file_) << "saved";
            });
            std::raise(SIGINT);
            while (!is_saving) {
            }
            write_unless_cut_off([&] { std::ofstream(file_) << "written"; });
        },
        testing::ExitedWithCode(kInterrupted),
        "it goes on");
    std::string word;
    std::ifstream(file_) >> word;
    EXPECT_EQ(word, "saved");
}

TEST_F(InterruptDeath, ASecondSignalKillsAtOnce) {
    EXPECT_EXIT(
        {
            const InterruptGuard guard("never said");
            std::raise(SIGINT);
            std::raise(SIGINT);
            work_for_ever();
        },
        testing::KilledBySignal(SIGINT),
        "^$");
}

TEST_F(InterruptDeath, WhatWouldOutliveUsIsClearedUp) {
    std::ofstream(file_) << std::flush;
    EXPECT_EXIT(
        {
            const pid_t leader = fork();
            if (leader == 0) {
                setpgid(0, 0);
                const pid_t started = fork();
                if (started > 0) std::ofstream(file_) << getpid() << ' ' << started;
                pause();
            }
            while (std::filesystem::file_size(file_) == 0) {
            }
            const CutOffGuard group([leader] { kill(-leader, SIGKILL); });
            const InterruptGuard guard("it goes on");
            std::raise(SIGINT);
            work_for_ever();
        },
        testing::ExitedWithCode(kInterrupted),
        "it goes on");
    pid_t leader = 0;
    pid_t started = 0;
    std::ifstream(file_) >> leader >> started;
    for (const pid_t process : {leader, started}) {
        ASSERT_GT(process, 0);
        const auto begin = Clock::now();
        while (is_running(process) && seconds_since(begin) < kLate_s)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        EXPECT_FALSE(is_running(process));
    }
}

}  // namespace
}  // namespace ink::core
