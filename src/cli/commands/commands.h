#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// One function per subcommand: it adds itself to the program; its callback runs when it is chosen.
///
/// A callback throws core::Error for bad input (exit 2) and CLI::RuntimeError(1) when it ran but a
/// check failed.
namespace ink::cli {

void add_bound_command(CLI::App& app);
void add_compare_command(CLI::App& app);
void add_diff_command(CLI::App& app);
void add_draw_command(CLI::App& app);
void add_truth_command(CLI::App& app);
void add_score_command(CLI::App& app);
void add_entrant_test_command(CLI::App& app);
void add_export_command(CLI::App& app);
void add_explain_command(CLI::App& app);
void add_figures_command(CLI::App& app);
void add_completions_command(CLI::App& app);
void add_help_command(CLI::App& app);
void add_list_command(CLI::App& app);
void add_merge_command(CLI::App& app);
void add_new_method_command(CLI::App& app);
void add_run_command(CLI::App& app);
void add_report_command(CLI::App& app);
void add_timedemo_command(CLI::App& app);
void add_tune_command(CLI::App& app);
void add_stress_command(CLI::App& app);

/// The names of all subcommands.
[[nodiscard]] std::vector<std::string> command_names(const CLI::App& app);

}  // namespace ink::cli
