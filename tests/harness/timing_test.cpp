#include "harness/clock/timing.h"

#include <gmock/gmock.h>

#include "harness/cells/cell.h"
#include "harness/clock/yardstick.h"
#include "tests/harness/made_up_method.h"

namespace ink::harness {
namespace {

constexpr std::int64_t kMs = 1'000'000;

/// A clock that stands still until a drawing moves it on. It is read before and after each work;
/// what is no drawing is the yardstick.
class MadeUpClock final : public core::WorkClock {
  public:
    std::int64_t yardstick_ns = 0;

    [[nodiscard]] core::Spent now(core::Worker) const override {
        if (is_working_ && !has_drawn_) spend({yardstick_ns, yardstick_ns});
        is_working_ = !is_working_;
        has_drawn_ = false;
        return now_;
    }
    void spend(const core::Spent& more) const {
        now_.wall_ns += more.wall_ns;
        now_.cpu_ns += more.cpu_ns;
        has_drawn_ = true;
    }

  private:
    mutable core::Spent now_;
    mutable bool is_working_ = false;
    mutable bool has_drawn_ = false;
};

/// What the n-th drawing takes, the 0th being the one that warms up.
using Load = std::function<core::Spent(int n)>;
/// And the yardstick before and after it.
using Speed = std::function<std::int64_t(int n)>;

std::int64_t no_yardstick(int) {
    return 0;
}

/// The row of a method under `load`, measured as `options` say.
Row measured(const Load& load, MeasureOptions options = {}, const Speed& yardstick = no_yardstick) {
    MadeUpClock clock;
    options.clock = &clock;
    int n = 0;
    Script script{.on_draw = [&] {
        clock.spend(load(n++));
        clock.yardstick_ns = yardstick(n);
    }};
    return timed(script, options);
}

TEST(Clock, OfAQuietMachineEndsWithNineSamplesAndNoDoubt) {
    const Row row = measured([](int n) {
        return n == 0 ? core::Spent{90 * kMs, 90 * kMs} : core::Spent{kMs + 7, kMs};
    });
    EXPECT_EQ(row.clock, "thread");
    EXPECT_EQ(row.draw_n, 9) << "without the one that warms up";
    EXPECT_EQ(row.draw_ns, kMs);
    EXPECT_EQ(row.draw_cpu_ns, kMs);
    EXPECT_EQ(row.draw_wall_ns, kMs + 7);
    EXPECT_EQ(row.time_doubt, "");
}

TEST(Clock, TakesNineSamplesHoweverLongTheyAre) {
    const Row row = measured([](int) { return core::Spent{2000 * kMs, 2000 * kMs}; });
    EXPECT_EQ(row.draw_n, 9);
}

TEST(Clock, OfOneThreadGoesByProcessorTimeAndSaysThatItWaited) {
    const auto beside = [](double wall) {
        return [wall](int) { return core::Spent{static_cast<std::int64_t>(wall * kMs), kMs}; };
    };
    EXPECT_EQ(measured(beside(1.5)).time_doubt, "");
    const Row row = measured(beside(1.51));
    EXPECT_EQ(row.time_doubt, "waited");
    EXPECT_EQ(row.draw_ns, kMs) << "whatever the wall says";
    EXPECT_EQ(row.draw_wall_ns, 1'510'000);
}

TEST(Clock, OfSeveralThreadsGoesByTheWallWithTheirWorkBeside) {
    MeasureOptions options;
    options.threads = 2;
    const Row row = measured([](int) { return core::Spent{3 * kMs, kMs}; }, options);
    EXPECT_EQ(row.clock, "wall");
    EXPECT_EQ(row.draw_ns, 3 * kMs);
    EXPECT_EQ(row.draw_cpu_ns, kMs);
    EXPECT_EQ(row.time_doubt, "") << "several threads may wait for each other";
}

TEST(Clock, SpikesLeaveTheLowerQuartileAndMakeMoreSamples) {
    // Two drawings of three are slow.
    const auto spikes = [](int n) {
        const std::int64_t ns = n % 3 == 0 ? kMs : 3 * kMs;
        return core::Spent{ns, ns};
    };
    MeasureOptions options;
    options.budget_s = 1;
    options.max_repetitions = 40;
    const Row row = measured(spikes, options);
    EXPECT_EQ(row.draw_n, 40);
    EXPECT_EQ(row.draw_ns, kMs);
    EXPECT_EQ(row.draw_ns_median, 3 * kMs);
    EXPECT_EQ(row.draw_ns_min, kMs);
    EXPECT_EQ(row.time_doubt, "spread");
    options.budget_s = 0.05;
    const int n = measured(spikes, options).draw_n;
    EXPECT_TRUE(n > 20 && n < 24) << n << " samples of 2.3 ms in the mean fill 50 ms";
}

TEST(Clock, ALoadThatEndsLeavesATimeWithoutDoubt) {
    // The first six drawings are slow; quick ones come until they are more than half of all.
    const Row row = measured(
        [](int n) {
            const std::int64_t ns = n <= 6 ? 2 * kMs : kMs;
            return core::Spent{ns, ns};
        },
        {1, 9, 60, 1});
    EXPECT_EQ(row.draw_n, 13);
    EXPECT_EQ(row.draw_ns, kMs);
    EXPECT_EQ(row.time_doubt, "");
}

// Drawing 7 and those after it find the machine slower by half, yardstick and all, but for one in
// four.
TEST(Clock, OfAMachineThatChangesItsSpeedIsThatOfItsBest) {
    const auto is_slow = [](int n) { return n >= 7 && n % 4 != 0; };
    const Load load = [&](int n) {
        const std::int64_t ns = is_slow(n) ? 3 * kMs / 2 : kMs;
        return core::Spent{ns, ns};
    };
    const Speed yardstick = [&](int n) { return is_slow(n) ? 150'000 : 100'000; };
    MeasureOptions options{1, 20, 20, 1};
    for (const int first : {0, 7}) {
        const auto later = [first](const auto& by_n) {
            return [first, &by_n](int n) { return by_n(n + first); };
        };
        const Row row = measured(later(load), options, later(yardstick));
        EXPECT_EQ(row.draw_n, 20);
        EXPECT_EQ(row.yardstick_ns, 100'000);
        EXPECT_EQ(row.draw_ns, kMs);
        EXPECT_EQ(row.draw_ns_median, kMs);
        EXPECT_EQ(row.time_doubt, "");
    }
    options.threads = 2;
    EXPECT_EQ(measured(load, options, yardstick).draw_ns_q75, 3 * kMs / 2)
        << "several threads wait for each other: their time stays as it is";
}

TEST(Clock, IsTimedBesideAYardstick) {
    const Row row = measured([](int) { return core::Spent{kMs, kMs}; });
    EXPECT_FALSE(row.yardstick_ns) << "by the made-up clock it takes no time";
    Yardstick yardstick;
    EXPECT_GT(time_ns([&] { yardstick.work(); }), 10'000);
}

TEST(FillTimes, GivesQuartilesMedianAndLeastThatWereMeasured) {
    const DrawTimes times{.draws = {{50, 50}, {10, 10}, {30, 30}, {20, 20}, {40, 40}},
                          .clock = "thread"};
    Row row;
    fill_times(times, row);
    EXPECT_EQ(row.draw_ns, 20);
    EXPECT_EQ(row.draw_ns_median, 30);
    EXPECT_EQ(row.draw_ns_q75, 40);
    EXPECT_EQ(row.draw_ns_min, 10);
    EXPECT_EQ(row.draw_n, 5);
    EXPECT_EQ(row.time_doubt, "spread");
    Row none;
    fill_times({}, none);
    EXPECT_FALSE(none.draw_ns.has_value());
    EXPECT_EQ(none.clock, "");
}

TEST(FillTimes, OfAProgramOutsideAreInNoDoubt) {
    Row row;
    fill_times({.draws = {{90, 10}}, .clock = "children"}, row);
    EXPECT_EQ(row.draw_ns, 10);
    EXPECT_EQ(row.draw_wall_ns, 90);
    EXPECT_EQ(row.time_doubt, "") << "it may wait for a GPU";
    fill_times({.draws = {{70, 0}}, .clock = "own"}, row = {});
    EXPECT_EQ(row.draw_ns, 70);
    EXPECT_FALSE(row.draw_wall_ns || row.draw_cpu_ns) << "nobody measured it here";
}

TEST(UncertainTimes, AreSaidWhereThereAreAny) {
    std::vector<Row> rows(5);
    for (std::size_t i = 0; i < 4; ++i)
        rows[i].draw_n = 9;
    rows[3].clock = "own";
    EXPECT_EQ(uncertain_times(rows), "");
    rows[1].time_doubt = "waited";
    EXPECT_EQ(uncertain_times(rows), "busy machine: times of 1 of 3 cells are uncertain");
}

}  // namespace
}  // namespace ink::harness
