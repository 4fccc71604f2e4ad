#include "cli/options/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "cli/options/command_rows.h"
#include "core/error.h"
#include "core/escape.h"
#include "core/interrupt.h"
#include "core/progress.h"

namespace ink::cli {
CLI::Option* add_out_folder_option(CLI::App& command, std::string& out, const std::string& doc) {
    return CommandRows(command)
        .text("-o,--out", out, "DIR", doc)
        ->check([](const std::string& folder) {
            return std::string(folder.empty() ? "an empty name is no folder" : "");
        });
}

void add_quiet_option(CLI::App& command) {
    command.add_flag_callback(
        "-q,--quiet",
        [] { core::progress_display().is_quiet = true; },
        "Show no progress (default: a line on a terminal, else one every ten seconds)");
}

void end_interrupted(const std::string& what_is_left) {
    fmt::print(stderr, "inkbench: interrupted; {}\n", what_is_left);
    throw CLI::RuntimeError(core::kInterrupted);
}

std::string recorded_command(const CLI::App& command, const std::vector<std::string>& left_out) {
    std::string line = "inkbench " + command.get_name();
    for (const CLI::Option* option : command.get_options()) {
        const auto is_it = [&](const std::string& name) { return option->check_name(name); };
        const bool is_left_out =
            is_it("--quiet") || std::any_of(left_out.begin(), left_out.end(), is_it);
        if (option->count() == 0 || is_left_out) continue;
        const bool is_flag = option->get_expected_max() == 0;
        for (const std::string& value : option->results()) {
            if (!option->get_positional()) line += " " + option->get_name();
            if (!is_flag) line += " " + core::shell_word(value);
        }
    }
    return line;
}

void add_cache_options(CLI::App& command, CacheOptions& options) {
    CommandRows rows(command);
    rows.text("--cache",
              options.folder,
              "DIR",
              "Folder of traced truths (default: $XDG_CACHE_HOME/inkbench, or ~/.cache/inkbench)");
    rows.flag("--no-cache", options.none, "Trace every truth again and keep none");
}

std::filesystem::path cache_folder(const CacheOptions& options) {
    if (options.none) return {};
    if (!options.folder.empty()) return options.folder;
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg != nullptr && *xdg != '\0') {
        return std::filesystem::path(xdg) / "inkbench";
    }
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        return std::filesystem::path(home) / ".cache" / "inkbench";
    }
    return {};
}

void check_output_path(const std::filesystem::path& path,
                       const std::vector<std::string>& extensions) {
    if (std::find(extensions.begin(), extensions.end(), path.extension()) == extensions.end()) {
        throw core::Error(path.string(),
                          "this is not the name of such a file",
                          fmt::format("a name that ends in {}", fmt::join(extensions, " or ")));
    }
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder)) {
        throw core::Error(
            path.string(), "its folder does not exist", "a file in an existing folder");
    }
    if (std::filesystem::is_directory(path) || access(folder.c_str(), W_OK) != 0) {
        throw core::Error(path.string(), "it cannot be written", "a file in a writable folder");
    }
}

}  // namespace ink::cli
