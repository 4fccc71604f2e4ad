#include "harness/clock/timing.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ink::harness {
namespace {

/// From here on a time is in doubt: half as much again.
constexpr double kDoubtful = 1.5;

/// Nearest rank, so that a quantile is always a time that was measured. The lower quartile stays
/// where it is while a load beside delays up to three drawings of four.
std::int64_t quantile(std::vector<std::int64_t>& times_ns, double q) {
    assert(!times_ns.empty());
    std::sort(times_ns.begin(), times_ns.end());
    return times_ns[static_cast<std::size_t>(
        std::lround(q * static_cast<double>(times_ns.size() - 1)))];
}

bool exceeds(std::int64_t time_ns, std::int64_t other_ns) {
    return static_cast<double>(time_ns) > kDoubtful * static_cast<double>(other_ns);
}

std::vector<std::int64_t> only(const std::vector<core::Spent>& draws,
                               std::int64_t core::Spent::*time) {
    std::vector<std::int64_t> times_ns;
    for (const core::Spent& draw : draws)
        times_ns.push_back(draw.*time);
    return times_ns;
}

/// Why the times of `row`, which it has, are uncertain; "" if they are not.
std::string doubt_of(const DrawTimes& times, const Row& row) {
    if (times.clock == kThreadClock && exceeds(*row.draw_wall_ns, *row.draw_cpu_ns))
        return "waited";
    if (exceeds(*row.draw_ns_median, *row.draw_ns_min)) return "spread";
    return "";
}

}  // namespace

double lower_spread(std::vector<std::int64_t> times_ns) {
    const auto median = static_cast<double>(quantile(times_ns, 0.5));
    const auto least = static_cast<double>(times_ns.front());
    return (median - least) / std::max(least, 1.0);
}

std::vector<std::int64_t> DrawTimes::draws_ns() const {
    const bool is_cpu = clock == kThreadClock || clock == kChildrenClock;
    std::vector<std::int64_t> times_ns =
        only(draws, is_cpu ? &core::Spent::cpu_ns : &core::Spent::wall_ns);
    if (clock != kThreadClock || yardsticks_ns.size() != draws.size()) return times_ns;
    for (std::size_t i = 0; i < times_ns.size(); ++i) {
        if (yardsticks_ns[i] <= 0) continue;
        const double speed =
            static_cast<double>(yardstick_ns) / static_cast<double>(yardsticks_ns[i]);
        times_ns[i] = std::llround(speed * static_cast<double>(times_ns[i]));
    }
    return times_ns;
}

void fill_times(const DrawTimes& times, Row& row) {
    row.draw_n = static_cast<int>(times.draws.size());
    if (times.draws.empty()) return;
    row.clock = times.clock;
    std::vector<std::int64_t> draws_ns = times.draws_ns();
    row.draw_ns = quantile(draws_ns, 0.25);
    row.draw_ns_median = quantile(draws_ns, 0.5);
    row.draw_ns_q75 = quantile(draws_ns, 0.75);
    row.draw_ns_min = draws_ns.front();
    if (times.yardstick_ns > 0) row.yardstick_ns = times.yardstick_ns;
    if (times.clock == kOwnClock) return;
    std::vector<std::int64_t> wall_ns = only(times.draws, &core::Spent::wall_ns);
    std::vector<std::int64_t> cpu_ns = only(times.draws, &core::Spent::cpu_ns);
    row.draw_wall_ns = quantile(wall_ns, 0.25);
    row.draw_cpu_ns = quantile(cpu_ns, 0.25);
    row.time_doubt = doubt_of(times, row);
}

std::string uncertain_times(std::span<const Row> rows) {
    const auto timed = std::ranges::count_if(
        rows, [](const Row& row) { return row.draw_n > 0 && !row.has_own_clock(); });
    const auto uncertain =
        std::ranges::count_if(rows, [](const Row& row) { return !row.time_doubt.empty(); });
    if (uncertain == 0) return "";
    return fmt::format("busy machine: times of {} of {} cells are uncertain", uncertain, timed);
}

}  // namespace ink::harness
