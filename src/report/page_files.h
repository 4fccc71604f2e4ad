#pragma once

#include <string_view>

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

}  // namespace ink::report
