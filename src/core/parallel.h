#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace ink::core {

/// Calls `body(i)` once for each i in [0, count), on at most `threads` threads, and waits.
///
/// `threads` = 1 is a plain loop on the calling thread, in order: no library is entered. With more,
/// the order is unspecified, so `body` must write only what belongs to its own i. The first
/// exception that a body throws is rethrown here. `threads` < 1 is a caller's bug. No more threads
/// are used than share_of_threads().
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// The same, `chunk` of the i at a time: for bodies that are short.
template <class Body>
void parallel_for_chunks(std::size_t count, std::size_t chunk, int threads, const Body& body) {
    parallel_for((count + chunk - 1) / chunk, threads, [&](std::size_t part) {
        const std::size_t end = std::min(count, (part + 1) * chunk);
        for (std::size_t i = part * chunk; i < end; ++i)
            body(i);
    });
}

/// Calls `body(begin, end, part)` for each chunk of `chunk` of the i, with a part of its own, and
/// returns the parts in order.
template <class Part, class Body>
std::vector<Part> parallel_parts(std::size_t count,
                                 std::size_t chunk,
                                 int threads,
                                 const Body& body) {
    std::vector<Part> parts((count + chunk - 1) / chunk);
    parallel_for(parts.size(), threads, [&](std::size_t i) {
        body(i * chunk, std::min(count, (i + 1) * chunk), parts[i]);
    });
    return parts;
}

/// The number of hardware threads, at least 1: the default of every `--threads`.
[[nodiscard]] int hardware_threads();

/// Calls `body` once on each of `count` lanes, which are threads of their own, and waits.
///
/// Lanes share the machine: each gets the hardware threads divided by the lanes that have not ended
/// yet. A single lane is the calling thread. The first exception that a lane throws is rethrown
/// here once all have ended. `count` < 1, or lanes beside other lanes, are a caller's bug.
void run_lanes(int count, const std::function<void()>& body);

/// How many threads a lane may use; hardware_threads() where there are no lanes.
[[nodiscard]] int share_of_threads();

}  // namespace ink::core
