#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiment/run_data.h"

namespace ink::report {

/// A page, and what is too much for it.
struct RunPage {
    std::string html;
    std::map<std::filesystem::path, std::string> beside;  ///< scripts with images, in runs' folders
};

/// The page of `runs`, one at least: an HTML file that needs no network, and no other file but for
/// images that are too many for it. Several runs stand beside each other.
///
/// What it shows is drawn by its own scripts (page/) from the runs' tables and images, which it
/// holds as JSON. Live pages that lie in a run's folder (live_page_path) are linked to, from a page
/// in `page_folder`; "": the first run's. Throws core::Error (where = the file) for images that
/// cannot be read.
[[nodiscard]] RunPage run_page(const std::vector<experiment::RunData>& runs,
                               std::filesystem::path page_folder = {});

/// Writes run_page() to `file`, and what lies beside it, each whole or not at all. Throws
/// core::Error if one cannot be written.
void write_run_page(const std::vector<experiment::RunData>& runs,
                    const std::filesystem::path& file);

/// What a reader can do with the answer of a comparison.
struct TakeHome {
    std::string method;   ///< what the answer's method does, in a sentence; "" where nobody says
    std::string address;  ///< of its page, seen from a folder; "" where that is not there
    /// What each gives, and its line for a shell: on the run's first model; none without an answer.
    std::vector<std::pair<std::string, std::string>> commands;
};
[[nodiscard]] TakeHome take_home(const experiment::RunData& run,
                                 const std::filesystem::path& page_folder);

}  // namespace ink::report
