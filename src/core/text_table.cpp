#include "core/text_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace ink::core {

std::string aligned(const Cells& cells) {
    std::vector<std::size_t> widths(cells[0].size(), 0);
    for (const auto& line : cells) {
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], line[i].size());
    }
    std::string text;
    for (const auto& line : cells) {
        text += fmt::format("{:<{}}", line[0], widths[0]);
        for (std::size_t i = 1; i < line.size(); ++i)
            text += fmt::format("  {:>{}}", line[i], widths[i]);
        text += '\n';
    }
    return text;
}

std::string markdown(const Cells& cells) {
    std::string text;
    for (const auto& line : cells) {
        text += fmt::format("| {} |\n", fmt::join(line, " | "));
        if (&line != &cells.front()) continue;
        text += "|---|";
        for (std::size_t i = 1; i < line.size(); ++i)
            text += "--:|";
        text += '\n';
    }
    return text;
}

std::string format_share(const std::optional<double>& share) {
    if (!share) return "-";
    const std::string text = fmt::format("{:.3f}", *share);
    return text[0] == '0' ? text.substr(1) : text;
}

}  // namespace ink::core
