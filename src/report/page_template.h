#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ink::report {

/// The files of a page as they were when the program was built; empty what a page has none of.
struct PageFiles {
    std::string_view index;    ///< HTML with {{title}}, {{style}}, {{scripts}} and more in it
    std::string_view style;    ///< CSS, all files in their order
    std::string_view scripts;  ///< JavaScript, all files in their order
    std::string_view shaders;  ///< GLSL, each after a line `//// method NAME`
    std::string_view d3;       ///< D3 5, minified
};

/// Of the page of runs: page/, and D3. Lives as long as the program.
[[nodiscard]] const PageFiles& page_files();

/// Of the page that draws a model: live/, and the shaders of methods. Lives as long as the program.
[[nodiscard]] const PageFiles& live_files();

/// The template with each {{name}} replaced; one pass, so that no value is looked into. Throws
/// std::out_of_range for a name without a value.
[[nodiscard]] std::string filled(std::string_view page,
                                 const std::map<std::string, std::string>& values);

/// As text that may stand in a script element: "<" is written as an escape, and what is no UTF-8
/// replaced.
[[nodiscard]] std::string page_json(const nlohmann::ordered_json& json);

/// `bytes` in zlib's format, as a browser's DecompressionStream("deflate") reads them.
[[nodiscard]] std::vector<std::uint8_t> deflated(std::span<const std::byte> bytes);

}  // namespace ink::report
