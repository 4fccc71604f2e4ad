#pragma once

#include <cstddef>
#include <functional>

namespace ink::core {

/// Calls `body(i)` once for each i in [0, count), on at most `threads` threads, and waits.
///
/// `threads` = 1 is a plain loop on the calling thread, in order: no library is entered. With more,
/// the order is unspecified, so `body` must write only what belongs to its own i. The first
/// exception that a body throws is rethrown here. `threads` < 1 is a caller's bug.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// The number of hardware threads, at least 1: the default of every `--threads`.
[[nodiscard]] int hardware_threads();

}  // namespace ink::core
