#pragma once

#include <cstddef>
#include <functional>

namespace ink::core {

/// Calls `body(i)` once for each i in [0, count), on at most `threads` threads, and waits.
///
/// `threads` = 1 is a plain loop on the calling thread, in order: no library is entered. With more,
/// the order is unspecified, so `body` must write only what belongs to its own i. The first
/// exception that a body throws is rethrown here. `threads` < 1 is a caller's bug. On a lane
/// (run_lanes) no more threads are used than its share, and it calls pause() between two calls: who
/// holds a lock that another lane may want does not come here.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// The number of hardware threads, at least 1: the default of every `--threads`.
[[nodiscard]] int hardware_threads();

/// What the other lanes do while one is alone (run_alone).
enum class Others {
    stand_still,  ///< they stop, so that nothing disturbs it
    work_on,      ///< they go on, on cores of their own; only to be alone they wait
};

/// Calls `body(lane)` for each lane in [0, count), each on a thread of its own, and waits.
///
/// Lanes share the machine: what runs on one gets the hardware threads divided by the lanes that
/// have not ended yet, so that one does not disturb what another one times. A single lane is the
/// calling thread. The first exception that a lane throws is rethrown here once all have ended.
/// `count` < 1, or lanes within a lane, are a caller's bug.
void run_lanes(int count,
               const std::function<void(int)>& body,
               Others others = Others::stand_still);

/// Calls `work` while no other lane does such work, so that nothing disturbs what it times.
///
/// With Others::stand_still the other lanes do nothing at all: they stop between two calls of a
/// parallel_for, where they pause(), or when they end. Meanwhile the caller has all hardware
/// threads. With Others::work_on it keeps its share. What `work` throws is thrown here. Outside of
/// lanes, and within such work, this only calls it.
void run_alone(const std::function<void()>& work);

/// Stands still while another lane is alone; with Others::work_on it does nothing. Long work
/// without a parallel_for calls this between its steps, or the others wait for it.
void pause();

/// Seconds that the calling thread has stood still so far, or waited to be alone.
[[nodiscard]] double waited_s();

/// The lane on which the caller runs; 0 outside of lanes.
[[nodiscard]] int this_lane();

/// How many threads what runs here may use: hardware_threads(), on a lane beside others that do
/// not stand still its share of them.
[[nodiscard]] int share_of_threads();

}  // namespace ink::core
