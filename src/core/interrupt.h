#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace ink::core {

/// The exit code of a program that was asked to end: 128 + SIGINT, as shells have it.
inline constexpr int kInterrupted = 130;

/// Seconds from Ctrl-C to the end of the program, whatever is being worked on.
inline constexpr double kMostUntilEnd_s = 1.8;

/// While one of these lives, Ctrl-C (SIGINT) and SIGTERM ask for an orderly end instead of killing:
/// work in hand is finished, what is done is written. A second signal kills at once.
///
/// Work that goes on for half of kMostUntilEnd_s is given up. Then `save`, if there is one, writes
/// down what is done, on another thread and beside that work; at the latest after kMostUntilEnd_s
/// the program says "inkbench: interrupted; `what_is_left`" on stderr and ends with kInterrupted.
/// So whatever is written under a guard must stand a kill (write_whole_file does).
///
/// Guards may lie within each other. The innermost that has a text, or a `save`, is heard.
class InterruptGuard {
  public:
    explicit InterruptGuard(std::string what_is_left = {}, std::function<void()> save = {});
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
};

/// Whether an end was asked for since the outermost guard was made.
[[nodiscard]] bool is_interrupted();

/// Calls `work`, which writes what a guard's `save` would write; never both. Once that is at work
/// this does not return: the program ends.
void write_unless_cut_off(const std::function<void()>& work);

/// While one of these lives, `clear_up` is called if the program is cut off, the last first: for
/// what would outlive it. It runs beside all else, and so takes no lock.
class CutOffGuard {
  public:
    explicit CutOffGuard(std::function<void()> clear_up);
    ~CutOffGuard();
    CutOffGuard(const CutOffGuard&) = delete;
    CutOffGuard& operator=(const CutOffGuard&) = delete;

  private:
    std::uint64_t number_;
};

}  // namespace ink::core
