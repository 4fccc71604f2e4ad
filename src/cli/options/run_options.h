#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>

#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "experiment/experiment.h"
#include "experiment/experiment_run.h"

namespace ink::cli {

/// Where a run goes and what is shown of it.
struct RunFolderOptions {
    std::string out = {};
    std::string shard = "1/1";
    bool is_forced = false;
    std::optional<int> lanes = {};  ///< none: as many as there are cores for
    bool no_times = false;
    bool is_dry = false;
    bool is_status = false;
};

/// Adds --out, --shard, --force, --no-times, --lanes, --quiet, --dry-run and --status to a
/// command.
void add_run_folder_options(CLI::App& command, RunFolderOptions& options);

/// What a command that measures is asked: what, how, and where the run goes.
struct MeasureArgs {
    /// Of the command `name`, whose runs go to `out` unless told otherwise.
    MeasureArgs(const std::string& name, const std::string& out);

    ExperimentOptions options;
    SceneOptions scenes;
    std::vector<std::string> methods;
    std::vector<std::string> settings;
    CacheOptions cache;
    RunFolderOptions folder;

    /// The experiment: of all methods if none is named. Throws core::Error for methods and settings
    /// that do not fit each other.
    [[nodiscard]] experiment::Experiment read() const;
};

/// Computes an experiment into its folder and shows what came of it, as conclude() does; lists the
/// blocks alone if --dry-run asks for that, or how far it has come for --status. Ends the program
/// by CLI::RuntimeError where its exit code is not 0.
///
/// An experiment that does not say which command asked for it was asked for by `command`: by what
/// the user typed, less what says where results go and how they are shown. That is the same for a
/// run, its shards and its continuation.
void run_to_end(const CLI::App& command,
                experiment::Experiment experiment,
                const RunFolderOptions& options,
                const CacheOptions& cache);

/// Shows what came of a run in `folder`: the table of methods with the verdict, or that of
/// stress; every view without a score with its reason and a remedy; where page and tables are.
///
/// Writes report.html, and verdict.md of a comparison, from the folder alone. Ends the program by
/// CLI::RuntimeError: 1 for an invalid run, 3 for views without a score, 130 if it was interrupted.
void conclude(const experiment::RunOutcome& outcome, const std::filesystem::path& folder);

}  // namespace ink::cli
