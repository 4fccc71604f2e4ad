#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// One function per subcommand: it adds itself to the program; its callback runs when it is chosen.
///
/// A callback throws core::Error for bad input (exit 2) and CLI::RuntimeError(1) when it ran but a
/// check failed.
namespace ink::cli {

// In the order in which help shows them.
// clang-format off
#define INK_COMMANDS(X) \
    X(compare) \
    X(advise) \
    X(draw) \
    X(truth) \
    X(score) \
    X(explain) \
    X(figures) \
    X(timedemo) \
    X(tune) \
    X(stress) \
    X(run) \
    X(report) \
    X(page) \
    X(diff) \
    X(merge) \
    X(bake) \
    X(export) \
    X(entrant_test) \
    X(new_method) \
    X(list) \
    X(help)
// clang-format on

#define INK_DECLARE(name) void add_##name##_command(CLI::App& app);
INK_COMMANDS(INK_DECLARE)
#undef INK_DECLARE

/// The names of all subcommands.
[[nodiscard]] std::vector<std::string> command_names(const CLI::App& app);

}  // namespace ink::cli
