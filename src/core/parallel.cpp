#include "core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace ink::core {
namespace {

/// Lanes that have not ended; 1 where there are none.
std::atomic<int> busy_lanes = 1;

using Range = std::function<void(std::size_t first, std::size_t end)>;

#ifdef __SANITIZE_THREAD__

/// The thread sanitizer does not know what orders the tasks of oneTBB, which is not built with it.
/// For it loops run on threads that it sees.
void divide(std::size_t count, int threads, const Range& range) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++)
                range(i, i + 1);
        } catch (...) {
            next = count;
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i)
        others.emplace_back(work);
    work();
    for (std::thread& other : others)
        other.join();
    if (failure) std::rethrow_exception(failure);
}

#else

/// An arena for so many threads that no other loop uses meanwhile. It is kept for later loops: a
/// new one would have to wake its workers for every loop, which is long beside a frame of a
/// millisecond. Never destroyed: workers outlive main.
class Arena {
  public:
    explicit Arena(int threads) : threads_(threads) {
        const std::lock_guard lock(mutex());
        std::vector<tbb::task_arena*>& kept = free()[threads];
        arena_ = kept.empty() ? new tbb::task_arena(threads) : kept.back();
        if (!kept.empty()) kept.pop_back();
    }
    ~Arena() {
        const std::lock_guard lock(mutex());
        free()[threads_].push_back(arena_);
    }
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;

    tbb::task_arena* operator->() { return arena_; }

  private:
    static std::mutex& mutex() {
        static std::mutex mutex;
        return mutex;
    }
    /// By threads.
    static std::map<int, std::vector<tbb::task_arena*> >& free() {
        static auto& arenas = *new std::map<int, std::vector<tbb::task_arena*> >();
        return arenas;
    }

    int threads_;
    tbb::task_arena* arena_;
};

void divide(std::size_t count, int threads, const Range& range) {
    Arena(threads)->execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                          [&](const auto& part) { range(part.begin(), part.end()); });
    });
}

#endif

}  // namespace

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    assert(threads >= 1);
    const auto run = [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i)
            body(i);
    };
    // More threads than the machine has would only wait, and oneTBB warns of it on stderr.
    if (threads > 1 && count > 1) threads = std::min(threads, share_of_threads());
    threads == 1 || count <= 1 ? run(0, count) : divide(count, threads, run);
}

int hardware_threads() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void run_lanes(int count, const std::function<void()>& body) {
    assert(count >= 1 && busy_lanes == 1);
    if (count == 1) return body();
    std::vector<std::exception_ptr> failures(static_cast<std::size_t>(count));
    std::vector<std::thread> threads;
    busy_lanes = count;
    for (std::exception_ptr& failure : failures) {
        threads.emplace_back([&] {
            try {
                body();
            } catch (...) {
                failure = std::current_exception();
            }
            --busy_lanes;
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    busy_lanes = 1;
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

int share_of_threads() {
    return std::max(1, hardware_threads() / std::max(1, busy_lanes.load()));
}

}  // namespace ink::core
