#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>

namespace ink::core {

/// Lets one of several threads have the machine to itself: it asks, the others come to it between
/// two steps of their work and wait there, and it begins when all have come.
///
/// A thread is inside from enter() to leave(). One that waits for another thread must leave first,
/// or nobody ever gets to be alone. Of several that ask, one after the other is alone, before
/// anybody else goes on.
class QuietGate {
  public:
    /// With so many threads inside.
    explicit QuietGate(int inside) : inside_(inside) {}
    QuietGate(const QuietGate&) = delete;
    QuietGate& operator=(const QuietGate&) = delete;

    /// Waits until nobody is alone or asks for it.
    void enter();
    void leave();

    /// Whether somebody is alone or asks for it: who is inside should pause().
    [[nodiscard]] bool is_closed() const { return asking_.load(std::memory_order_relaxed) > 0; }

    /// For threads inside, between two steps: stands still while somebody else is alone.
    void pause() {
        leave();
        enter();
    }

    /// From one to the other the caller, who is inside, is the only one who is.
    void begin_alone();
    void end_alone();

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int inside_;
    std::atomic<int> asking_ = 0;  ///< written under the mutex: those who wait to be alone, or are
    bool is_taken_ = false;        ///< somebody is alone
};

}  // namespace ink::core
