#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <exception>
#include <new>
#include <string>

#include "core/error.h"

namespace ink::harness {

/// The one clock: nanoseconds that `work` took.
template <class Work>
std::int64_t time_ns(Work work) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    work();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start).count();
}

/// Runs a method's stage; what it throws becomes the cell's status instead of ending the run. ""
/// if it throws nothing.
template <class Work>
std::string failure_of(Work work) {
    try {
        work();
    } catch (const std::bad_alloc&) {
        return "out of memory";
    } catch (const core::Error& error) {
        return error.what();
    } catch (const std::exception& error) {
        return fmt::format("failed: {}", error.what());
    }
    return "";
}

}  // namespace ink::harness
