#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ink::import {

/// What a child process may use up before it is stopped.
struct ChildLimits {
    double wall_s = 60;
    std::uint64_t memory_bytes = 8ULL << 30;  ///< not held under AddressSanitizer
    bool counts_reserved = true;  ///< memory is address space; else what it may write to, alone
    std::uint64_t output_bytes = 2ULL << 30;
    std::uint64_t file_bytes = 0;  ///< of any file that it writes; 0: it writes none
    bool keeps_errors = false;     ///< its error output counts as output; else it is discarded
    int threads = 1;               ///< that it may keep busy: so many times wall_s of CPU time
    bool leads_group = false;      ///< it is killed with all that it started
};

/// How a child process came to its end.
enum class ChildEnd {
    exited,       ///< by itself; `code` is its exit status
    signalled,    ///< `code` is the signal, which was not ours
    timed_out,    ///< killed here after `wall_s`
    flooded,      ///< killed here after `output_bytes`
    not_started,  ///< `code` is errno
};

/// The end of a child process and all that it wrote.
struct ChildOutcome {
    ChildEnd end = ChildEnd::not_started;
    int code = 0;
    std::vector<std::byte> output;
    /// Of its threads and of the processes that it has started and waited for; 0 if it was killed
    /// here.
    std::int64_t cpu_ns = 0;
};

/// Runs `program arguments...` to its end and returns what it wrote to its standard output.
///
/// The child has no input, it cannot write larger files than its limits say or dump core, it dies
/// when this process dies, and it is always reaped, also when an exception leaves this function.
/// No shell is involved. Safe to call from several threads.
[[nodiscard]] ChildOutcome run_child(const std::filesystem::path& program,
                                     const std::vector<std::string>& arguments,
                                     const ChildLimits& limits);

}  // namespace ink::import
