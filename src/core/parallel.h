#pragma once

#include <cstddef>
#include <functional>

namespace ink::core {

/// Calls `body(i)` once for each i in [0, count), on at most `threads` threads, and waits.
///
/// `threads` = 1 is a plain loop on the calling thread, in order: no library is entered. With more,
/// the order is unspecified, so `body` must write only what belongs to its own i. The first
/// exception that a body throws is rethrown here. `threads` < 1 is a caller's bug. On a lane
/// (run_lanes) no more threads are used than its share.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// The number of hardware threads, at least 1: the default of every `--threads`.
[[nodiscard]] int hardware_threads();

/// Calls `body(lane)` for each lane in [0, count), each on a thread of its own, and waits.
///
/// Lanes share the machine: what runs on one gets the hardware threads divided by the lanes that
/// have not ended yet, so that one does not disturb what another one times. A single lane is the
/// calling thread. The first exception that a lane throws is rethrown here once all have ended.
/// `count` < 1, or lanes within a lane, are a caller's bug.
void run_lanes(int count, const std::function<void(int)>& body);

/// The lane on which the caller runs; 0 outside of lanes.
[[nodiscard]] int this_lane();

/// How many threads what runs here may use: hardware_threads(), on a lane its share of them.
[[nodiscard]] int share_of_threads();

}  // namespace ink::core
