#include "harness/tables/table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/named.h"

namespace ink::harness {
namespace {

/// Text of a cell of a Markdown table.
std::string cell_text(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

}  // namespace

std::string heading(const TableInfo& table) {
    return fmt::format("{}\n", fmt::join(core::names_of(table.columns), ","));
}

std::string dictionary_section(const TableInfo& table) {
    std::string text = fmt::format("## {}\n\n{}\n\n", table.file, table.doc);
    text += "| name | unit | meaning |\n|---|---|---|\n";
    for (const Column& column : table.columns) {
        text += fmt::format("| `{}` | {}{} | {} |\n",
                            column.name,
                            cell_text(column.unit),
                            column.is_time ? " *time*" : "",
                            cell_text(column.doc));
    }
    return text;
}

}  // namespace ink::harness
