#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace ink::cli {

/// What exit code 3 of a run means, for the help texts.
inline constexpr const char* kUnscoredCode =
    "3 some views have no score (crowded ones do not count)";

/// Adds --out DIR, or -o DIR: the folder that a command writes; `doc` says what into it.
CLI::Option* add_out_folder_option(CLI::App& command, std::string& out, const std::string& doc);

/// Adds --quiet, which silences every core::Progress of the process.
void add_quiet_option(CLI::App& command);

/// Says on stderr "inkbench: interrupted; `what_is_left`" and ends the command with exit code 130.
[[noreturn]] void end_interrupted(const std::string& what_is_left);

/// The command as it was given, ready for a shell, without options that a name in `left_out` (and
/// --quiet) is of. To be asked in the command's callback.
[[nodiscard]] std::string recorded_command(const CLI::App& command,
                                           const std::vector<std::string>& left_out = {});

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
