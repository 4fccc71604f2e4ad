#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ink::core {

/// A column of a table of a run folder.
struct Column {
    Column(std::string_view called,
           std::string_view measured_in,
           std::string_view meaning,
           bool holds_time = false);
    Column(const Column&);
    Column(Column&&) noexcept;
    Column& operator=(const Column&);
    Column& operator=(Column&&) noexcept;
    ~Column();  // all of them compiled once: tables have hundreds of columns

    std::string name;
    std::string unit;  ///< "px", "ns", "0..1"; empty for text and plain counts
    std::string doc;   ///< what it means, in a sentence or less
    /// It holds a time or follows from one: two runs of one plan may differ in such columns and in
    /// no others.
    bool is_time = false;
    bool is_text = false;  ///< what it holds is no number and no yes or no
};

/// A table of a run folder, as the data dictionary tells of it.
struct TableInfo {
    std::string file;  ///< "rows.csv"
    std::string doc;   ///< what one line of it is
    std::vector<Column> columns;
};

/// The first line of the table's file, with its line break.
[[nodiscard]] std::string heading(const TableInfo& table);

/// A section of the data dictionary: the file's name, what it is, and a row per column with name,
/// unit and meaning, as Markdown.
[[nodiscard]] std::string dictionary_section(const TableInfo& table);

}  // namespace ink::core
