#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/error.h"
#include "harness/tables/csv.h"
#include "harness/tables/csv_table.h"
#include "harness/tables/table.h"

namespace ink::harness {

/// A value as a field: text quoted where it must be, numbers in the shortest form that reads back
/// to the same value, whatever the locale; nothing is an empty field.
template <class T>
[[nodiscard]] std::string csv_text(const T& value) {
    if constexpr (std::is_convertible_v<T, std::string_view>) {
        return csv_field(std::string(value));
    } else {
        return fmt::format("{}", value);
    }
}
template <class T>
[[nodiscard]] std::string csv_text(const std::optional<T>& value) {
    return value ? csv_text(*value) : "";
}

/// A table of records: what its columns are called and mean, how a record writes each, and how each
/// is read back. One list, so that the three cannot drift apart.
template <class Record>
class TableOf {
  public:
    using Write = std::function<std::string(const Record&)>;
    using Read = std::function<void(const CsvField&, Record&)>;

    TableOf(std::string file, std::string doc) : info_{std::move(file), std::move(doc), {}} {}

    /// A column that holds what `place` finds in a record: a callable that gives a reference into
    /// the (constant or changing) record.
    template <class Place>
    void add(Column column, Place place) {
        add(
            std::move(column),
            [place](const Record& record) { return csv_text(place(record)); },
            [place](const CsvField& field, Record& record) { field.read(place(record)); });
    }
    /// A column with a writer and a reader of its own.
    void add(Column column, Write write, Read read) {
        info_.columns.push_back(std::move(column));
        writers_.push_back(std::move(write));
        readers_.push_back(std::move(read));
    }
    /// A column that follows from others; it is written and not read.
    template <class Value>
    void add_derived(Column column, Value value_of) {
        add(
            std::move(column),
            [value_of](const Record& record) { return csv_text(value_of(record)); },
            [](const CsvField&, Record&) {});
    }

    /// A column with its writer and reader, to stand in another table too.
    struct Field {
        Column column;
        Write write;
        Read read;
    };
    void add(Field field) {
        add(std::move(field.column), std::move(field.write), std::move(field.read));
    }
    /// The column of that name, which must be there.
    [[nodiscard]] Field field(const std::string& name) const {
        for (std::size_t i = 0; i < info_.columns.size(); ++i) {
            if (info_.columns[i].name == name) return {info_.columns[i], writers_[i], readers_[i]};
        }
        throw core::Error(info_.file, "it has no column " + name, heading(info_));
    }

    [[nodiscard]] const TableInfo& info() const { return info_; }

    /// One line with its line break.
    [[nodiscard]] std::string line(const Record& record) const {
        std::string text;
        for (const Write& write : writers_) {
            if (&write != &writers_.front()) text += ',';
            text += write(record);
        }
        return text + '\n';
    }

    /// The record number `i` of a table whose columns were checked. Throws core::Error for a field
    /// that does not hold what its column asks for.
    [[nodiscard]] Record read_record(const CsvTable& table, std::size_t i) const {
        Record record{};
        for (std::size_t column = 0; column < readers_.size(); ++column)
            readers_[column](CsvField(table, i, column), record);
        return record;
    }

    /// All records. Throws core::Error for other columns than these, or a wrong field.
    [[nodiscard]] std::vector<Record> read(const CsvTable& table) const {
        check_columns(table, info_);
        std::vector<Record> records;
        records.reserve(table.records.size());
        for (std::size_t i = 0; i < table.records.size(); ++i)
            records.push_back(read_record(table, i));
        return records;
    }

  private:
    TableInfo info_;
    std::vector<Write> writers_;
    std::vector<Read> readers_;
};

}  // namespace ink::harness
