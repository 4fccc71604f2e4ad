#pragma once

#include <string>
#include <string_view>

namespace ink::core {

/// `text` as it may stand between tags or inside a quoted attribute of HTML or SVG: the five marks
/// & < > " ' become entities, control characters other than tab and line break vanish.
///
/// Every name that comes from outside (scenes are called after users' files) goes through here.
[[nodiscard]] std::string escape(std::string_view text);

/// `text` as it may stand in a cell of a Markdown table, which a bar would end.
[[nodiscard]] std::string markdown_cell(std::string_view text);

/// A word as a shell reads it back.
[[nodiscard]] std::string shell_word(std::string_view word);

}  // namespace ink::core
