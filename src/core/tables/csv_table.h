#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/tables/table.h"

namespace ink::core {

/// A CSV field: quoted as RFC 4180 has it if it holds a comma, a quote or a line break.
[[nodiscard]] std::string csv_field(const std::string& text);

/// A number in the shortest form that reads back to the same value, whatever the locale.
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string number_text(std::int64_t value);
[[nodiscard]] std::string number_text(std::uint64_t value);

/// A value as a field: text quoted where it must be, numbers as number_text has them; nothing is an
/// empty field.
template <class T>
[[nodiscard]] std::string csv_text(const T& value) {
    if constexpr (std::is_convertible_v<T, std::string_view>) {
        return csv_field(std::string(value));
    } else if constexpr (std::is_same_v<T, bool>) {
        return value ? "true" : "false";
    } else if constexpr (std::is_same_v<T, double>) {
        return number_text(value);
    } else if constexpr (std::unsigned_integral<T>) {
        return number_text(std::uint64_t{value});
    } else {
        return number_text(std::int64_t{value});
    }
}
template <class T>
[[nodiscard]] std::string csv_text(const std::optional<T>& value) {
    return value ? csv_text(*value) : "";
}

/// A CSV table as text: the fields keep their quotes, so that what is not changed is written again
/// to the same bytes.
struct CsvTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> records;
    std::string where = {};               ///< its file, for messages
    std::vector<std::size_t> lines = {};  ///< of the file, on which each record begins; from 1

    /// Index of the column called `name`, or columns.size().
    [[nodiscard]] std::size_t find(std::string_view name) const;
};

/// Splits a table with its heading (RFC 4180, "\n" line ends). Text without a heading is a table
/// without columns. Throws Error (where = `where` and the line) if a record has more or fewer
/// fields than the heading, or if the last line is not ended: it was cut off.
[[nodiscard]] CsvTable split_csv(std::string_view text, const std::string& where);

/// Throws Error that names the first wrong column unless the table has just the columns of
/// `info`, in their order.
void check_columns(const CsvTable& table, const TableInfo& info);

/// A field without its quotes.
[[nodiscard]] std::string unquoted(const std::string& field);

/// One field of a table, to be read; what it cannot be read as is an error that names file, line,
/// column and value.
class CsvField {
  public:
    /// Borrows the table.
    CsvField(const CsvTable& table, std::size_t record, std::size_t column)
        : table_(table), record_(record), column_(column) {}

    [[nodiscard]] bool is_empty() const { return raw().empty(); }
    [[nodiscard]] std::string text() const { return unquoted(raw()); }

    /// Reads the field into `value`, which must hold all of it: "1.5" is no integer.
    void read(std::string& value) const { value = text(); }
    void read(bool& value) const;  ///< true, false
    /// int, double, std::int64_t or std::uint64_t.
    template <class T>
    requires std::is_arithmetic_v<T>
    void read(T& value) const;
    /// Nothing for an empty field.
    template <class T>
    void read(std::optional<T>& value) const {
        value.reset();
        if (is_empty()) return;
        T held{};
        read(held);
        value = std::move(held);
    }
    template <class T>
    [[nodiscard]] T as() const {
        T value{};
        read(value);
        return value;
    }

    /// Throws Error: this field is wrong, `accepted` would have been right.
    [[noreturn]] void refuse(const std::string& accepted) const;

  private:
    [[nodiscard]] const std::string& raw() const { return table_.records[record_][column_]; }

    const CsvTable& table_;
    std::size_t record_;
    std::size_t column_;
};

}  // namespace ink::core
