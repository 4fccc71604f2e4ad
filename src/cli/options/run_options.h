#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/options/options.h"
#include "cli/options/scene_options.h"
#include "experiment/experiment.h"

namespace ink::cli {

/// Where a run goes and what is shown of it.
struct RunFolderOptions {
    std::string out = {};
    std::string shard = "1/1";
    bool is_forced = false;
    int lanes = 0;  ///< 0: as many as there are cores for
    bool no_times = false;
    bool is_json = false;
    bool is_dry = false;
    bool is_status = false;
};

/// Adds --out, --shard, --force, --no-times, --lanes, --quiet, --json, --dry-run and --status to a
/// command.
void add_run_folder_options(CLI::App& command, RunFolderOptions& options);

/// Puts the methods that a command names, all if none, and their settings into an experiment.
/// Throws core::Error for one that does not fit the other.
void take_methods(const std::vector<std::string>& methods,
                  const std::vector<std::string>& settings,
                  experiment::Experiment& experiment);

/// Puts the scenes that a command names and from where they are seen into an experiment.
void take_views(const ViewOptions& views,
                const SceneOptions& scenes,
                experiment::Experiment& experiment);

/// What the user typed after `command`'s name, less what says where results go and how they are
/// shown: the same for a run, its shards and its continuation.
[[nodiscard]] std::string run_command_text(const CLI::App& command);

/// Computes an experiment into its folder and shows what came of it, as conclude() does; lists the
/// blocks alone if --dry-run asks for that, or how far it has come for --status. Ends the program
/// by CLI::RuntimeError where its exit code is not 0.
void run_to_end(experiment::Experiment experiment,
                const RunFolderOptions& options,
                const CacheOptions& cache);

}  // namespace ink::cli
