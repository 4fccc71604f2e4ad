#pragma once

#include <cstdint>

namespace ink::core {

/// What some work took: time on the wall, and processor time. Also a reading of the clock, from
/// whatever beginning.
struct Spent {
    std::int64_t wall_ns = 0;
    std::int64_t cpu_ns = 0;

    friend Spent operator-(const Spent& a, const Spent& b) {
        return {a.wall_ns - b.wall_ns, a.cpu_ns - b.cpu_ns};
    }
};

/// Whose processor time is read.
enum class Worker {
    thread,  ///< the calling thread's: of work on one thread, whatever else the machine does
    /// All threads' of this process. Of work on several threads, as long as nothing else of the
    /// process works meanwhile: methods on several threads are timed one at a time, without lanes
    /// beside them. Threads of a pool that spin while they wait count as work.
    process,
};

/// The one clock. Tests have others, which tell made-up times.
class WorkClock {
  public:
    WorkClock() = default;
    WorkClock(const WorkClock&) = delete;
    WorkClock& operator=(const WorkClock&) = delete;
    virtual ~WorkClock() = default;

    /// What has been spent until now.
    [[nodiscard]] virtual Spent now(Worker worker) const = 0;
};

/// The machine's.
[[nodiscard]] const WorkClock& machine_clock();

/// What `work` took.
template <class Work>
Spent spent_on(Work work,
               Worker worker = Worker::thread,
               const WorkClock& clock = machine_clock()) {
    const Spent before = clock.now(worker);
    work();
    return clock.now(worker) - before;
}

}  // namespace ink::core
