#pragma once

#include <string_view>

namespace ink::report {

/// The files of page/ and D3, as they were when the program was built.
struct PageFiles {
    std::string_view
        index;  ///< HTML with {{title}}, {{style}}, {{d3}}, {{scripts}}, {{data}}, {{images}}
    std::string_view style;    ///< CSS
    std::string_view scripts;  ///< JavaScript, all files in their order
    std::string_view d3;       ///< D3 5, minified
};

/// Lives as long as the program.
[[nodiscard]] const PageFiles& page_files();

}  // namespace ink::report
