#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/tables/csv_table.h"
#include "experiment/run_data.h"

namespace ink::report {

/// A column of a CSV table as JSON, as page/tables.js reads it: an array; {"constant": value} if
/// all lines hold the same; {"words": [...], "at": [...]} for texts that repeat (at: index of the
/// word, -1 for an empty field).
///
/// Numbers keep their digits; inf and -inf stand among them as texts, nan and empty fields as null.
/// A column is of texts if one field is neither number nor flag, or is a whole number of more than
/// 15 digits, which JavaScript would round.
[[nodiscard]] std::string packed_column(const std::vector<std::string>& fields);

/// The columns of a CSV table as JSON: {name: packed}.
[[nodiscard]] std::string packed_columns(const core::CsvTable& table);

/// A CSV table as JSON: {"lines": count, "columns": packed_columns() in zlib's format, by base64}.
[[nodiscard]] nlohmann::ordered_json packed_table(const core::CsvTable& table);

/// The images of runs for a page, as page/images.js reads them.
struct PackedImages {
    /// An array with an object per run, from "scene\nview" to {"width", "height", "truth": PNG,
    /// "images": [PNG], "inks": [PNG or null], "methods": {name: index}}; PNGs are base64 of 8-bit
    /// grey with a code a pixel (draw::Mark; truth::LineClass for the truth), and of what draws ink
    /// its share, too. {"width", "height", "methods", "beside": address of a script} where truth,
    /// images and inks lie beside the page.
    std::string json;
    std::map<std::filesystem::path, std::string> beside;  ///< these scripts, in the runs' folders
};

/// Images stay in the page, which is to lie in `page_folder`, as long as they are within
/// `budget_bytes`: the first views of all scenes before any second one. Throws core::Error for an
/// image that cannot be read.
[[nodiscard]] PackedImages packed_images(const std::vector<experiment::RunData>& runs,
                                         const std::filesystem::path& page_folder,
                                         std::size_t budget_bytes);

}  // namespace ink::report
