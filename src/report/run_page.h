#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/run_data.h"

namespace ink::report {

/// The page of `runs`, one at least: a single HTML file that needs no other and no
/// network. Several runs stand beside each other.
///
/// What it shows is drawn by its own scripts (page/) from the runs' tables and images, which it
/// holds as JSON. Live pages that lie in a run's folder (live_page_path) are linked to, from a page
/// in `page_folder`; "": the first run's. Images are shrunk, then left out for the last views,
/// where the page would be larger than 20 MB. Throws core::Error (where = the file) for images that
/// cannot be read.
[[nodiscard]] std::string run_page(const std::vector<experiment::RunData>& runs,
                                   std::filesystem::path page_folder = {});

/// Writes run_page() to `file`, whole or not at all. Throws core::Error if it cannot be written.
void write_run_page(const std::vector<experiment::RunData>& runs,
                    const std::filesystem::path& file);

}  // namespace ink::report
