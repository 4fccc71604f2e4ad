#pragma once

#include <filesystem>
#include <string>

#include "harness/clock/outside_method.h"

namespace ink::entrants {

/// The image in a file as edge responses (harness/images/outline_image.h). Throws core::Error that
/// names the file if it cannot be read or has another size than the view.
[[nodiscard]] edge::EdgeImage read_entrant_image(const std::filesystem::path& path,
                                                 const scene::View& view);

/// Images `folder/<scene>/<view>.png`, and their times from `folder/times.csv` if it is there.
/// Throws core::Error for a times.csv that cannot be read.
[[nodiscard]] harness::OutsideSource image_folder_source(const std::filesystem::path& folder);

/// A hash of all files in a folder, names and bytes.
[[nodiscard]] std::string folder_hash(const std::filesystem::path& folder);

/// A hash of a file's bytes; that of nothing if it cannot be read.
[[nodiscard]] std::string file_hash(const std::filesystem::path& file);

}  // namespace ink::entrants
