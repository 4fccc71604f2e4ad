#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/parallel.h"
#include "truth/limits.h"

namespace ink::truth {

/// Calls `task(i)` for each i below `count`, every kPilotShare-th one first, then those halfway
/// between, and so on; stops before the next round if `is_hopeless(stride)` says so, of the tasks
/// done so far: all multiples of `stride`. True if all were called. will_exceed() answers for it.
template <class Task, class IsHopeless>
bool run_pilots_first(std::size_t count, int threads, Task&& task, IsHopeless&& is_hopeless) {
    for (std::size_t stride = kPilotShare; stride >= 1; stride /= 2) {
        // After the first round, only what lies halfway between those done.
        const std::size_t first = stride == kPilotShare ? 0 : stride;
        const std::size_t step = stride == kPilotShare ? stride : 2 * stride;
        const std::size_t tasks = count > first ? (count - first + step - 1) / step : 0;
        core::parallel_for(tasks, threads, [&](std::size_t i) { task(first + i * step); });
        if (stride > 1 && is_hopeless(stride)) return false;
    }
    return true;
}

/// What `count` tasks surely cost together, as every `stride`-th of them shows: nine tenths of the
/// total that their mean points to, less three standard errors. `cost(i)` is that of task i. 0
/// where fewer than 16 say too little. The same for every thread count.
template <class Cost>
[[nodiscard]] double least_total(std::size_t count, std::size_t stride, Cost&& cost) {
    constexpr std::size_t kFewest = 16;
    constexpr double kErrors = 3;
    constexpr double kShare = 0.9;  // what was not met yet may be cheap
    const std::size_t done = (count + stride - 1) / stride;
    if (done < kFewest) return 0;
    const auto n = static_cast<double>(done);
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < count; i += stride) {
        const auto c = static_cast<double>(cost(i));
        sum += c;
        squares += c * c;
    }
    const double mean = sum / n;
    const double variance = std::max(squares / n - mean * mean, 0.0) * n / (n - 1);
    const double least = kShare * mean - kErrors * std::sqrt(variance / n);
    return std::max(least, 0.0) * static_cast<double>(count);
}

/// Whether `count` tasks will cost more than `limit` together, as every `stride`-th of them shows:
/// surely (least_total), or by kSureExcess times if the others cost as much as those.
template <class Cost>
[[nodiscard]] bool will_exceed(std::size_t count,
                               std::size_t stride,
                               std::size_t limit,
                               Cost&& cost) {
    std::size_t done = 0;
    for (std::size_t i = 0; i < count; i += stride)
        done += cost(i);
    return done > limit / std::max<std::size_t>(stride / kSureExcess, 1) ||
           least_total(count, stride, cost) > static_cast<double>(limit);
}

}  // namespace ink::truth
