#pragma once

#include <benchmark/benchmark.h>

#include <string>

namespace ink::bench {

/// Why a run was broken off (State::SkipWithError), "" if it was not: never empty for one that was.
///
/// Google Benchmark 1.8 put `skipped` and `skip_message` in the place of `error_occurred` and
/// `error_message`; here alone is what depends on its version.
template <class Run>
[[nodiscard]] std::string error_of(const Run& run) {
    bool has_failed = false;
    std::string message;
    if constexpr (requires { run.error_occurred; }) {
        has_failed = run.error_occurred;
        message = run.error_message;
    } else {
        has_failed = static_cast<bool>(run.skipped);
        message = run.skip_message;
    }
    if (!has_failed) return "";
    return message.empty() ? "broken off" : message;
}

}  // namespace ink::bench
