#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ink::harness {

/// A CSV table as text: the fields keep their quotes, so that what is not changed is written again
/// to the same bytes.
struct CsvTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> records;

    /// Index of the column called `name`, or columns.size().
    [[nodiscard]] std::size_t find(std::string_view name) const;
};

/// Splits a table with its heading (RFC 4180, "\n" line ends). Text without a heading is a table
/// without columns. Throws core::Error (where = `where` and the record's number) if a record has
/// more or fewer fields than the heading.
[[nodiscard]] CsvTable split_csv(std::string_view text, const std::string& where);

/// The table as text again, heading first, every line ended.
[[nodiscard]] std::string join_csv(const CsvTable& table);

/// A field without its quotes.
[[nodiscard]] std::string unquoted(const std::string& field);

/// The columns, of any table, that hold times or follow from them: two runs of one plan differ in
/// these and in nothing else.
[[nodiscard]] const std::set<std::string>& time_columns();

/// `lines` (no heading, every line ended) of a table with `heading`, with the fields of time
/// columns empty.
[[nodiscard]] std::string without_times(const std::string& heading, const std::string& lines);

}  // namespace ink::harness
