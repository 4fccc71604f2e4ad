#include "core/disturbance.h"

#include <algorithm>
#include <atomic>
#include <barrier>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include "core/work_clock.h"

namespace ink::core {
namespace {

constexpr std::size_t kPlane = std::size_t{1} << 20;  // floats
constexpr int kPairs = 21;
constexpr int kPasses = 4;

/// A plane that is read and written from end to end.
class Plane {
  public:
    void pass() {
        for (float& value : values_)
            value = value * 0.999F + 0.5F;
    }

  private:
    std::vector<float> values_ = std::vector<float>(kPlane, 1.0F);
};

/// Threads that work on planes of their own between begin() and end().
class Neighbours {
  public:
    explicit Neighbours(int count) : meeting_(count + 1) {
        for (int i = 0; i < count; ++i)
            threads_.emplace_back([this] { work(); });
    }
    ~Neighbours() {
        is_over_ = true;
        meeting_.arrive_and_wait();
    }
    Neighbours(const Neighbours&) = delete;
    Neighbours& operator=(const Neighbours&) = delete;

    /// They work once this has returned.
    void begin() {
        is_at_work_ = true;
        meeting_.arrive_and_wait();
    }
    /// They stand still once this has returned.
    void end() {
        is_at_work_ = false;
        meeting_.arrive_and_wait();
    }

  private:
    void work() {
        Plane plane;
        for (;;) {
            meeting_.arrive_and_wait();
            if (is_over_) return;
            while (is_at_work_)
                plane.pass();
            meeting_.arrive_and_wait();
        }
    }

    std::atomic<bool> is_at_work_ = false;
    std::atomic<bool> is_over_ = false;
    std::barrier<> meeting_;
    std::vector<std::jthread> threads_;
};

std::int64_t passes_ns(Plane& plane) {
    plane.pass();  // what somebody else has put into the caches is no longer there
    const Spent spent = spent_on([&] {
        for (int i = 0; i < kPasses; ++i)
            plane.pass();
    });
    return spent.cpu_ns;
}

}  // namespace

double measure_disturbance(int others) {
    assert(others >= 0);
    Plane plane;
    Neighbours neighbours(others);
    std::vector<double> ratios;
    for (int i = 0; i < kPairs; ++i) {
        const auto alone_ns = static_cast<double>(passes_ns(plane));
        neighbours.begin();
        const auto beside_ns = static_cast<double>(passes_ns(plane));
        neighbours.end();
        ratios.push_back(beside_ns / alone_ns);
    }
    std::nth_element(ratios.begin(), ratios.begin() + kPairs / 2, ratios.end());
    return ratios[kPairs / 2];
}

}  // namespace ink::core
