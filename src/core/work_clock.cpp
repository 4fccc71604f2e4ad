#include "core/work_clock.h"

#include <ctime>

namespace ink::core {
namespace {

std::int64_t read_ns(clockid_t id) {
    constexpr std::int64_t kNsPerS = 1'000'000'000;
    timespec time{};
    clock_gettime(id, &time);
    return std::int64_t{time.tv_sec} * kNsPerS + time.tv_nsec;
}

class MachineClock final : public WorkClock {
  public:
    [[nodiscard]] Spent now(Worker worker) const override {
        const bool is_thread = worker == Worker::thread;
        return {read_ns(CLOCK_MONOTONIC),
                read_ns(is_thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID)};
    }
};

}  // namespace

const WorkClock& machine_clock() {
    static const MachineClock kClock;
    return kClock;
}

}  // namespace ink::core
