#pragma once

namespace ink::harness {

/// While one of these lives, Ctrl-C (SIGINT) and SIGTERM ask for an orderly end instead of killing:
/// work in hand is finished, what is done is written. A second one kills at once.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
};

/// Whether an end was asked for since the guard was made.
[[nodiscard]] bool is_interrupted();

}  // namespace ink::harness
