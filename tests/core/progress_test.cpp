#include "core/progress.h"

#include <gtest/gtest.h>

namespace ink::core {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// A display that writes to memory, and a clock that moves when it is told to.
class ProgressTest : public testing::Test {
  protected:
    ProgressTest() {
        display_.stream = open_memstream(&bytes_, &size_);
        display_.now = [this] { return time_; };
    }
    ~ProgressTest() override {
        std::fclose(display_.stream);
        std::free(bytes_);
    }
    std::string written() {
        std::fflush(display_.stream);
        return {bytes_, size_};
    }
    ProgressDisplay display_;
    std::chrono::steady_clock::time_point time_{seconds(1000)};

  private:
    char* bytes_ = nullptr;
    std::size_t size_ = 0;
};

TEST_F(ProgressTest, ALogGetsALineEveryTenSecondsAndNoneMore) {
    Progress progress("compare", 40, display_);
    for (int tenth = 0; tenth < 400; ++tenth) {  // 40 s, a step each second
        progress.report(tenth / 10, "torus view1");
        time_ += milliseconds(100);
    }
    EXPECT_EQ(written(),
              "compare: 10/40, 30 s left, torus view1\n"
              "compare: 20/40, 20 s left, torus view1\n"
              "compare: 30/40, 10 s left, torus view1\n");
}

TEST_F(ProgressTest, WorkThatFollowsOrIsInsideSharesTheTenSeconds) {
    for (int work = 0; work < 3; ++work) {
        Progress outer("outer", 4, display_);
        for (int step = 0; step < 4; ++step) {
            Progress inner("inner", 1, display_);
            outer.report(step, "");
            inner.report(0, "x");
            time_ += seconds(1);
        }
    }
    EXPECT_EQ(written(), "outer: 2/4, 2 s left\n") << "12 s in all";
}

TEST_F(ProgressTest, ShortWorkLeavesALogEmpty) {
    {
        Progress progress("draw", 9, display_);
        for (int step = 0; step < 9; ++step) {
            progress.report(step, "a");
            time_ += seconds(1);
        }
    }
    EXPECT_EQ(written(), "");
}

TEST_F(ProgressTest, ATerminalsLineIsDrawnAgainAndWiped) {
    display_.is_terminal = true;
    {
        Progress progress("tune", 3, display_);
        progress.report(0, "first");
        time_ += milliseconds(50);
        progress.report(0, "too soon");
        time_ += milliseconds(950);
        progress.report(1, std::string(80, 'w'));
    }
    EXPECT_EQ(
        written(),
        "\r\033[Ktune 0/3  first\r\033[Ktune 1/3, 2 s left  " + std::string(60, 'w') + "\r\033[K");
}

TEST_F(ProgressTest, APlainTerminalIsOneThatTakesNoLineBack) {
    EXPECT_TRUE(moves_cursor("xterm-256color"));
    EXPECT_FALSE(moves_cursor("dumb"));
    EXPECT_FALSE(moves_cursor(""));
    EXPECT_FALSE(moves_cursor(nullptr));
}

TEST_F(ProgressTest, AFullLogEndsNoWork) {
    std::FILE* full = std::fopen("/dev/full", "w");
    ASSERT_NE(full, nullptr);
    std::setbuf(full, nullptr);
    display_.is_terminal = true;
    std::swap(display_.stream, full);
    EXPECT_NO_THROW(Progress("compare", 3, display_).report(1, "torus"));
    std::swap(display_.stream, full);
    std::fclose(full);
}

TEST_F(ProgressTest, AQuietDisplayStaysEmpty) {
    display_.is_quiet = true;
    for (const bool is_terminal : {false, true}) {
        display_.is_terminal = is_terminal;
        Progress progress("compare", 3, display_);
        time_ += seconds(60);
        progress.report(1, "a");
    }
    EXPECT_EQ(written(), "");
}

TEST_F(ProgressTest, NoStepsSayNothing) {
    Progress progress("compare", 0, display_);
    time_ += seconds(60);
    progress.report(0, "a");
    EXPECT_EQ(written(), "");
}

TEST(RoughTime, IsInTheUnitPeopleUse) {
    EXPECT_EQ(rough_time(-3), "0 s");
    EXPECT_EQ(rough_time(7.6), "8 s");
    EXPECT_EQ(rough_time(99.4), "99 s");
    EXPECT_EQ(rough_time(118), "2 min");
    EXPECT_EQ(rough_time(3599), "1 h 0 min");
    EXPECT_EQ(rough_time(7500), "2 h 5 min");
}

}  // namespace
}  // namespace ink::core
