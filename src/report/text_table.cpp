#include "report/text_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/verdict.h"

namespace ink::report {

TextColumn share_column(std::string heading,
                        std::optional<double> experiment::MethodSummary::*field) {
    return {std::move(heading),
            [field](const experiment::MethodSummary& s) { return format_share(s.*field); }};
}

TextColumn name_column() {
    return {"method", [](const experiment::MethodSummary& s) {
                constexpr std::size_t kLongest = 16;
                const std::string name = s.method + (s.is_bracket ? " *" : "");
                return name.size() <= kLongest ? name : name.substr(0, kLongest - 2) + "..";
            }};
}

core::Cells cells_of(const std::vector<TextColumn>& columns,
                     const std::vector<experiment::MethodSummary>& summaries) {
    core::Cells cells(1);
    for (const TextColumn& column : columns)
        cells[0].push_back(column.heading);
    for (const experiment::MethodSummary& s : summaries) {
        std::vector<std::string>& line = cells.emplace_back();
        for (const TextColumn& column : columns)
            line.push_back(column.text(s));
    }
    return cells;
}

std::string aligned(const core::Cells& cells) {
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

std::string markdown(const core::Cells& cells) {
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

}  // namespace ink::report
