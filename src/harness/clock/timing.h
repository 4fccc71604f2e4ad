#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/work_clock.h"
#include "harness/rows/row.h"

namespace ink::harness {

/// Names of clocks, as rows have them.
inline constexpr const char* kThreadClock = "thread";      ///< processor time of the one thread
inline constexpr const char* kWallClock = "wall";          ///< on the wall, of several threads
inline constexpr const char* kChildrenClock = "children";  ///< processor time of another program
inline constexpr const char* kOwnClock = "own";            ///< what somebody outside says

/// The clock of what is drawn here on so many threads, and whose processor time stands beside it.
[[nodiscard]] inline const char* clock_of(int threads) {
    return threads == 1 ? kThreadClock : kWallClock;
}
[[nodiscard]] inline core::Worker worker_of(int threads) {
    return threads == 1 ? core::Worker::thread : core::Worker::process;
}

/// Nanoseconds that `work` took by the clock of so many threads.
template <class Work>
std::int64_t time_ns(Work work, int threads = 1) {
    const core::Spent spent = core::spent_on(work, worker_of(threads));
    return threads == 1 ? spent.cpu_ns : spent.wall_ns;
}

/// How far the median lies above the least, as a share of that: the spread of the lower half, in
/// which nothing counts that is slow by chance. `times_ns` may not be empty.
[[nodiscard]] double lower_spread(std::vector<std::int64_t> times_ns);

/// Times of one method on one view, as they were taken.
struct DrawTimes {
    std::vector<core::Spent> draws = {};
    /// Of each drawing the time of the yardstick beside it; empty where it was not timed.
    std::vector<std::int64_t> yardsticks_ns = {};
    std::int64_t yardstick_ns = 0;  ///< the least while the view was drawn; 0: it was not timed
    std::string clock = {};         ///< that counts, by its name; "" where nothing is timed
    std::string failure = {};       ///< why there are none, or ""
    raster::SkipCounts skips = {};  ///< of the last timed drawing

    /// By the clock that counts. Processor time of one thread is what it would have been at the
    /// speed that the machine had at its best: where the yardstick beside a drawing took half as
    /// long again as its least, two thirds of the drawing's time count.
    [[nodiscard]] std::vector<std::int64_t> draws_ns() const;
};

/// Writes what was measured into `row`, and whether it is in doubt; no draws leave it empty.
void fill_times(const DrawTimes& times, Row& row);

/// "busy machine: times of 14 of 81 cells are uncertain"; "" where none are.
[[nodiscard]] std::string uncertain_times(std::span<const Row> rows);

/// Runs a method's stage; what it throws becomes the cell's status instead of ending the run. ""
/// if it throws nothing.
template <class Work>
std::string failure_of(Work work) {
    try {
        work();
    } catch (const std::bad_alloc&) {
        return "out of memory";
    } catch (const core::Error& error) {
        return error.what();
    } catch (const std::exception& error) {
        return fmt::format("failed: {}", error.what());
    }
    return "";
}

}  // namespace ink::harness
