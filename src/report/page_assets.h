#pragma once

#include <string_view>

namespace ink::report {

/// The style sheet of the report.
[[nodiscard]] std::string_view page_style();

/// The script of the report: dividers, method pickers, sortable tables. The page reads without it.
[[nodiscard]] std::string_view page_script();

/// The mark beside the title: a cube in outline, contours dark, creases green.
[[nodiscard]] std::string_view page_mark();

}  // namespace ink::report
