#pragma once

#include <cstddef>

#include "core/parallel.h"
#include "truth/limits.h"

namespace ink::truth {

/// Calls `task(i)` for each i below `count`, every kPilotShare-th one first; the others only if
/// `is_hopeless()` then says no. True if all were called.
template <class Task, class IsHopeless>
bool run_pilots_first(std::size_t count, int threads, Task&& task, IsHopeless&& is_hopeless) {
    const std::size_t pilots = count / kPilotShare;
    core::parallel_for(pilots, threads, [&](std::size_t i) { task(i * kPilotShare); });
    if (is_hopeless()) return false;
    core::parallel_for(count, threads, [&](std::size_t i) {
        const bool is_done = i % kPilotShare == 0 && i / kPilotShare < pilots;
        if (!is_done) task(i);
    });
    return true;
}

}  // namespace ink::truth
