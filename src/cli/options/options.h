#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiment/experiment.h"
#include "harness/suite.h"
#include "harness/tracing.h"

namespace ink::cli {

/// What exit code 3 of a run means, for the help texts.
inline constexpr const char* kUnscoredCode =
    "3 some views have no score (crowded ones do not count)";

/// The options by which every command says which views it means, as text until `view_request` reads
/// them.
struct ViewOptions {
    std::string size = "1280x720";
    std::string views;  ///< a number, or "file"
    std::vector<std::string> eyes;
    std::vector<std::string> targets;
    std::optional<std::string> up;  ///< only with eyes, as the next
    std::optional<double> fov_deg;
    std::optional<double> time_s;
    std::optional<int> frame;
    std::string fit;  ///< "", "sphere" or "box"
    std::optional<double> margin;
    std::vector<std::string> objects;
    std::string animation;
    std::string seams = "objects";
};

/// Adds --size, --views, --fit, --margin, --object, --eye, --target, --up, --fov, --time, --frame,
/// --animation and --seams to a command.
void add_view_options(CLI::App& command, ViewOptions& options);

/// What the options ask for. Throws core::Error (where = the option) for text that means nothing.
[[nodiscard]] harness::ViewRequest view_request(const ViewOptions& options);

/// Adds --out DIR, or -o DIR: the folder that a command writes; `doc` says what into it.
CLI::Option* add_out_folder_option(CLI::App& command, std::string& out, const std::string& doc);

/// Adds --threads; `doc` says whose.
void add_threads_option(CLI::App& command, int& threads, const std::string& doc);

/// Adds --seed; `doc` says of what. `parse_seed` reads it.
void add_seed_option(CLI::App& command, std::string& seed, const std::string& doc);

/// Adds --quiet, which silences every core::Progress of the process.
void add_quiet_option(CLI::App& command);

/// Says on stderr "inkbench: interrupted; `what_is_left`" and ends the command with exit code 130.
[[noreturn]] void end_interrupted(const std::string& what_is_left);

/// The command as it was given, ready for a shell, without options that a name in `left_out` (and
/// --quiet) is of. To be asked in the command's callback.
[[nodiscard]] std::string recorded_command(const CLI::App& command,
                                           const std::vector<std::string>& left_out = {});

/// --threads as given, or an Error unless 1..256.
[[nodiscard]] int checked_threads(int threads);

/// --seed as given, or an Error unless it is a whole number of 64 bits. As text, because the option
/// parser would turn -1 into the largest one without a word.
[[nodiscard]] std::uint64_t parse_seed(const std::string& text);

/// What a command lets its user say of the truth.
struct TruthSettings {
    double crease_deg = 40;
    double weld_epsilon = 0;
    std::string intersections = "above_crease";
};

/// Adds --crease, --weld-epsilon and --intersections to a command.
void add_truth_settings(CLI::App& command, TruthSettings& settings);

/// Adds --intersections alone.
void add_intersections_option(CLI::App& command, std::string& intersections);

/// Writes the settings into `trace`, or what an experiment asks of its truths. Throws core::Error
/// (where = the option) for numbers out of range, or a word that is no choice.
void apply(const TruthSettings& settings, harness::TraceOptions& trace);
void apply(const TruthSettings& settings, experiment::Experiment& experiment);

/// Where traced truths are kept.
struct CacheOptions {
    std::string folder;  ///< "" is $XDG_CACHE_HOME/inkbench, or ~/.cache/inkbench
    bool none = false;
};

/// Adds --cache and --no-cache to a command.
void add_cache_options(CLI::App& command, CacheOptions& options);

/// The folder the options mean; empty if truths are not to be kept or there is no home for them.
[[nodiscard]] std::filesystem::path cache_folder(const CacheOptions& options);

/// Throws core::Error unless a file can be written to `path`: its name ends in one of `extensions`
/// (".png", ".exr", ...), and its folder is there and writable. Called before any work, so that an
/// hour is not lost to a typing error.
void check_output_path(const std::filesystem::path& path,
                       const std::vector<std::string>& extensions);

}  // namespace ink::cli
