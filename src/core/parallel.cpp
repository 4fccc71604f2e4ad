#include "core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <mutex>
#include <thread>

namespace ink::core {
namespace {

/// The arena for so many threads, made once: a new one would have to wake its workers for every
/// loop, which is long beside a frame of a millisecond. Never destroyed: workers outlive main.
tbb::task_arena& arena_of(int threads) {
    static std::mutex mutex;
    static auto& arenas = *new std::map<int, tbb::task_arena>();
    const std::lock_guard lock(mutex);
    return arenas.try_emplace(threads, threads).first->second;
}

}  // namespace

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    assert(threads >= 1);
    if (threads == 1 || count <= 1) {
        for (std::size_t i = 0; i < count; ++i)
            body(i);
        return;
    }
    // More threads than the machine has would only wait, and oneTBB warns of it on stderr.
    arena_of(std::min(threads, hardware_threads())).execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                body(i);
        });
    });
}

int hardware_threads() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace ink::core
