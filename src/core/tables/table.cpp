#include "core/tables/table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/escape.h"
#include "core/named.h"

namespace ink::core {

Column::Column(std::string_view called,
               std::string_view measured_in,
               std::string_view meaning,
               bool holds_time)
    : name(called), unit(measured_in), doc(meaning), is_time(holds_time) {}
Column::Column(const Column&) = default;
Column::Column(Column&&) noexcept = default;
Column& Column::operator=(const Column&) = default;
Column& Column::operator=(Column&&) noexcept = default;
Column::~Column() = default;

std::string heading(const TableInfo& table) {
    return fmt::format("{}\n", fmt::join(names_of(table.columns), ","));
}

std::string dictionary_section(const TableInfo& table) {
    std::string text = fmt::format("## {}\n\n{}\n\n", table.file, table.doc);
    text += "| name | unit | meaning |\n|---|---|---|\n";
    for (const Column& column : table.columns) {
        text += fmt::format("| `{}` | {}{} | {} |\n",
                            column.name,
                            markdown_cell(column.unit),
                            column.is_time ? " *time*" : "",
                            markdown_cell(column.doc));
    }
    return text;
}

}  // namespace ink::core
