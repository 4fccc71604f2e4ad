#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <thread>

#include "tests/program/run_program.h"

// Ctrl-C, whatever is being worked on: a scene of a million triangles is prepared and traced for a
// minute and more, without a step at which anybody asks.

namespace ink::program {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Clock = std::chrono::steady_clock;

constexpr int kInterrupted = 130;
/// The program promises two seconds. A machine whose cores are all taken wakes it later, and what
/// it has written to a slow disk it waits for.
constexpr std::chrono::duration<double> kMost = std::chrono::seconds(2 + 4);

/// Ctrl-C, a while after `is_begun`; measures how long the program takes over it.
class CtrlC {
  public:
    CtrlC(const Desk& desk, std::function<bool()> is_begun, double wait_s)
        : desk_(desk), is_begun_(std::move(is_begun)), wait_s_(wait_s) {}

    [[nodiscard]] Outcome during(const Words& words) {
        const Outcome outcome = desk_.run_until(words, [&] { return is_time(); });
        took_ = Clock::now() - asked_.value_or(Clock::now());
        return outcome;
    }
    /// From the signal to the end.
    [[nodiscard]] std::chrono::duration<double> took() const { return took_; }
    [[nodiscard]] bool was_sent() const { return asked_.has_value(); }

  private:
    bool is_time() {
        if (!begun_ && is_begun_()) begun_ = Clock::now();
        if (!begun_ || Clock::now() - *begun_ < std::chrono::duration<double>(wait_s_))
            return false;
        asked_ = Clock::now();
        return true;
    }

    const Desk& desk_;
    std::function<bool()> is_begun_;
    double wait_s_;
    std::optional<Clock::time_point> begun_;
    std::optional<Clock::time_point> asked_;
    std::chrono::duration<double> took_{};
};

/// Whether a process is there, and not one that is dead and was not buried.
bool is_running(int process) {
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    std::string number, name, state;
    return stat >> number >> name >> state && state != "Z" && state != "X";
}

TEST(CtrlC, EndsWorkOnALargeSceneInTwoSeconds) {
    const struct {
        Words words;
        std::string begun;  ///< by when it has begun: this is there
        double wait_s;
        std::string said;
    } cases[] = {
        {"compare --scenes globe --no-cache --out out", "out/run.toml", 0, "command goes on\n"},
        {"compare --scenes globe --no-cache --out out", "out/run.toml", 3, "command goes on\n"},
        {"tune mote4 --scenes scan --out out", "out", 1, "command goes on from there\n"},
        {"timedemo globe --methods surface8", "", 2, "interrupted; nothing is written\n"},
        {"advise globe --no-cache", "", 2, "interrupted; nothing is written\n"},
        {"truth globe --no-cache -o truth.png", "", 0.5, ""},
        {"draw globe -o drawn.png", "", 0.5, ""},
        {"explain globe", "", 0.5, ""}};
    for (const auto& [words, begun, wait_s, said] : cases) {
        SCOPED_TRACE(testing::PrintToString(words));
        const Desk desk;
        CtrlC ctrl_c(
            desk, [&] { return std::filesystem::exists(desk.work() / begun); }, wait_s);
        const Outcome outcome = ctrl_c.during(words);
        if (!ctrl_c.was_sent()) {
            EXPECT_EQ(said, "") << "done before: " << outcome.err;
            continue;
        }
        EXPECT_EQ(outcome.exit_code, kInterrupted) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(said));
        EXPECT_LT(ctrl_c.took(), kMost);
        EXPECT_EQ(desk.inventory().empty(), begun.empty());
    }
}

TEST(CtrlC, SavesWhatIsFinishedWhileALargeSceneIsWorkedOn) {
    const Desk desk;
    const Words words =
        "compare --scenes cube,globe --methods mote4 --size 320x180 --lanes 2 --no-sweep --images "
        "none --no-cache --out out";
    const auto is_begun = [&] {
        return std::filesystem::exists(desk.work() / "out/blocks/000000/block.toml");
    };
    CtrlC ctrl_c(desk, is_begun, 0);
    const Outcome outcome = ctrl_c.during(words);
    if (!ctrl_c.was_sent()) GTEST_SKIP() << "one lane only: the large scene comes first";
    EXPECT_EQ(outcome.exit_code, kInterrupted) << outcome.err;
    EXPECT_LT(ctrl_c.took(), kMost);
    const Table rows = rows_of(desk);
    // A view of the large scene may be finished too, where its lane was the faster one.
    EXPECT_TRUE(
        std::ranges::any_of(rows, [](const auto& row) { return row.at("scene") == "cube"; }));
    EXPECT_THAT(desk.read("out/run.toml"), HasSubstr("unfinished"));
    EXPECT_THAT(desk.read("out/verdict.md"), StartsWith("This run is not finished: "));
}

TEST(CtrlC, EndsAProgramFromOutsideWithWhatItStartedAndItsFolder) {
    const Desk desk;
    // Its name, its view and a process of its own: what is to be gone.
    desk.write("slow.sh",
               "#!/bin/sh\nsleep 300 &\necho $! $(dirname $1) > " +
                   (desk.work() / "begun").string() + "\nwait\n");
    std::filesystem::permissions(desk.work() / "slow.sh", std::filesystem::perms::owner_all);
    const auto is_begun = [&] { return desk.read("begun").ends_with("\n"); };
    CtrlC ctrl_c(desk, is_begun, 0);
    const Outcome outcome =
        ctrl_c.during("compare --scenes cube --methods mote4 --entrant slow=./slow.sh --out out");
    ASSERT_TRUE(ctrl_c.was_sent()) << outcome.err;
    EXPECT_EQ(outcome.exit_code, kInterrupted) << outcome.err;
    EXPECT_LT(ctrl_c.took(), kMost);
    std::istringstream begun(desk.read("begun"));
    int sleeper = 0;
    std::string folder;
    begun >> sleeper >> folder;
    ASSERT_GT(sleeper, 0);
    const auto end = Clock::now() + kMost;
    while (is_running(sleeper) && Clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_FALSE(is_running(sleeper));
    EXPECT_FALSE(std::filesystem::exists(folder)) << folder;
}

}  // namespace
}  // namespace ink::program
