#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/tables/csv_table.h"
#include "experiment/run_data.h"

namespace ink::report {

/// `text` as a JSON string that may stand in a script element: "<" is written as an escape.
[[nodiscard]] std::string json_text(std::string_view text);

/// A column of a CSV table as JSON, as page/tables.js reads it: an array; {"constant": value} if
/// all lines hold the same; {"words": [...], "at": [...]} for texts that repeat (at: index of the
/// word, -1 for an empty field).
///
/// Numbers keep their digits; inf and -inf stand among them as texts, nan and empty fields as null.
/// A column is of texts if one field is neither number nor flag, or is a whole number of more than
/// 15 digits, which JavaScript would round.
[[nodiscard]] std::string packed_column(const std::vector<std::string>& fields);

/// A CSV table as JSON: {"lines": count, "columns": {name: packed}}.
[[nodiscard]] std::string packed_table(const core::CsvTable& table);

/// The images of each run as JSON, as page/images.js reads them: an array with an object per run,
/// from "scene\nview" to {"width", "height", "truth": PNG, "images": [PNG], "inks": [PNG or null],
/// "methods": {name: index}}; PNGs are base64 of 8-bit grey with a code a pixel (draw::Mark;
/// truth::LineClass for the truth), and of images of ink also with the ink.
///
/// Where they would take more than `budget_bytes`, all are shrunk by 2, 4, then 8 (errors and lines
/// win over paper), without ink; where even that is too much, the last views of each scene are left
/// out, and then the last scenes. Throws core::Error for an image that cannot be read.
[[nodiscard]] std::string packed_images(const std::vector<experiment::RunData>& runs,
                                        std::size_t budget_bytes);

}  // namespace ink::report
