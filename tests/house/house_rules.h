#pragma once

#include <string>
#include <vector>

#include "tests/house/source_tree.h"

/// The rules of the house, each a function from a tree to what breaks it: "path:line: what".
///
/// No finding, no breach. They read text, not a compiler's mind: an include inside `#if 0` counts.
namespace ink::house {

using Findings = std::vector<std::string>;

/// The rooms of the table: folders of src/, and methods.
[[nodiscard]] std::vector<std::string> room_names();

/// Rooms include only what the table of the design's section 2 allows, by path from src/ or the
/// root; a method includes no other method.
[[nodiscard]] Findings check_arrows(const SourceTree& tree);

/// One file includes Embree (those of bench/ beside it), one OpenImageIO, one Assimp; OpenCV stays
/// in score, draw, report, methods, tests and bench, and CLI11 in cli.
[[nodiscard]] Findings check_libraries(const SourceTree& tree);

/// No folder of a room holds more than 60 files or 4300 lines of code: what is larger is two rooms,
/// or one with folders in it.
[[nodiscard]] Findings check_sizes(const SourceTree& tree);

/// Every folder of src/ is a room of the table and has its CMakeLists.txt, as have methods, tests
/// and bench; no folder is called utils, common or helpers.
[[nodiscard]] Findings check_folders(const SourceTree& tree);

/// Every method folder has its .h, .cpp and page, an entry in registry.cpp and a line of CMake.
[[nodiscard]] Findings check_methods(const SourceTree& tree);

/// Headers begin with `#pragma once`, before any code.
[[nodiscard]] Findings check_headers(const SourceTree& tree);

/// No build file asks for the machine's own instruction set or for loose arithmetic: both would
/// change images.
[[nodiscard]] Findings check_flags(const SourceTree& tree);

/// No text names a path of one machine or a host that packages come from.
[[nodiscard]] Findings check_words(const SourceTree& tree);

/// README.md has at most 600 words, those of its tables and commands among them.
[[nodiscard]] Findings check_readme(const SourceTree& tree);

/// Pages (*.md) have none of the words and turns on a short list, each of which has a plainer one,
/// and no fraction without its leading zero. Code is not read.
[[nodiscard]] Findings check_prose(const SourceTree& tree);

}  // namespace ink::house
