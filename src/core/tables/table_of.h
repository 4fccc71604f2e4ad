#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/named.h"
#include "core/tables/csv.h"
#include "core/tables/csv_table.h"
#include "core/tables/table.h"

namespace ink::core {

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

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <class Record>
class TableOf;

/// A part of a table's records, to add columns of it: `find` gives a pointer to it, null where a
/// record has none, and `make` a reference to it, made if need be. What a record has not is an
/// empty field, and an empty field makes nothing.
///
/// Members and further parts are named by a `place`: a pointer to a member, or a callable that
/// gives a reference into the (constant or changing) part.
template <class Record, class Find, class Make, bool kMayLack>
class PartOf {
  public:
    PartOf(TableOf<Record>& table, Find find, Make make)
        : table_(&table), find_(find), make_(make) {}

    /// A column that holds what `place` finds in the part.
    template <class Place>
    void add(Column column, Place place) const {
        column.is_text = kIsText<Place>;
        table_->add(std::move(column), write(place), read([place](const CsvField& field, auto& of) {
                        field.read(std::invoke(place, of));
                    }));
    }
    /// A column that holds one of `names`: that of the number, or the enumerator, at `place`.
    /// Another word is refused.
    template <class Place>
    void add_named(Column column, Place place, std::vector<std::string> names) const {
        const auto name_of = [=](const auto& of) {
            return names.at(static_cast<std::size_t>(std::invoke(place, of)));
        };
        column.is_text = true;
        table_->add(
            std::move(column), write(name_of), read([=](const CsvField& field, auto& of) {
                const auto at = std::find(names.begin(), names.end(), field.text());
                if (at == names.end()) field.refuse(fmt::format("{}", fmt::join(names, ", ")));
                auto& value = std::invoke(place, of);
                value = static_cast<std::remove_reference_t<decltype(value)>>(at - names.begin());
            }));
    }
    /// A column that follows from others; it is written and not read.
    template <class Value>
    void add_derived(Column column, Value value_of) const {
        column.is_text = kIsText<Value>;
        table_->add(std::move(column), write(value_of), [](const CsvField&, Record&) {});
    }

    /// What lies at `place` in this part; an optional may lack.
    template <class Place>
    [[nodiscard]] auto part(Place place) const {
        const auto find = [find = find_, place](const Record& record) {
            const auto* whole = find(record);
            return whole == nullptr ? nullptr : present(std::invoke(place, *whole));
        };
        const auto make = [make = make_, place](Record& record) -> decltype(auto) {
            return made(std::invoke(place, make(record)));
        };
        using Of = std::invoke_result_t<Place, std::invoke_result_t<Make, Record&>>;
        constexpr bool kMayLackIt = kMayLack || kIsOptional<std::remove_cvref_t<Of>>;
        return PartOf<Record, decltype(find), decltype(make), kMayLackIt>(*table_, find, make);
    }
    /// The same part, which lacks where `condition` does not hold of it.
    template <class Condition>
    [[nodiscard]] auto part_if(Condition condition) const {
        const auto find = [find = find_, condition](const Record& record) {
            const auto* of = find(record);
            return of != nullptr && std::invoke(condition, *of) ? of : nullptr;
        };
        return PartOf<Record, decltype(find), Make, true>(*table_, find, make_);
    }

  private:
    using Part = std::remove_reference_t<std::invoke_result_t<Make, Record&>>;
    template <class Value>
    static constexpr bool kIsText =
        std::is_convertible_v<std::invoke_result_t<Value, const Part&>, std::string_view>;

    template <class T>
    static const T* present(const T& value) {
        return &value;
    }
    template <class T>
    static const T* present(const std::optional<T>& value) {
        return value ? &*value : nullptr;
    }
    template <class T>
    static T& made(T& value) {
        return value;
    }
    template <class T>
    static T& made(std::optional<T>& value) {
        return value ? *value : value.emplace();
    }

    template <class Value>
    [[nodiscard]] auto write(Value value_of) const {
        return [find = find_, value_of](const Record& record) {
            const auto* of = find(record);
            return of == nullptr ? std::string() : csv_text(std::invoke(value_of, *of));
        };
    }
    template <class ReadPart>
    [[nodiscard]] auto read(ReadPart read_part) const {
        return [make = make_, read_part](const CsvField& field, Record& record) {
            if (!kMayLack || !field.is_empty()) read_part(field, make(record));
        };
    }

    TableOf<Record>* table_;
    Find find_;
    Make make_;
};

/// A table of records: what its columns are called and mean, how a record writes each, and how each
/// is read back. One list, so that the three cannot drift apart.
template <class Record>
class TableOf {
  public:
    using Write = std::function<std::string(const Record&)>;
    using Read = std::function<void(const CsvField&, Record&)>;

    TableOf(std::string file, std::string doc) : info_{std::move(file), std::move(doc), {}} {}

    /// A column with a writer and a reader of its own.
    void add(Column column, Write write, Read read) {
        info_.columns.push_back(std::move(column));
        writers_.push_back(std::move(write));
        readers_.push_back(std::move(read));
    }

    // Columns and parts of the whole record: see PartOf.
    template <class Place>
    void add(Column column, Place place) {
        whole().add(std::move(column), place);
    }
    template <class Place>
    void add_named(Column column, Place place, std::vector<std::string> names) {
        whole().add_named(std::move(column), place, std::move(names));
    }
    template <class Value>
    void add_derived(Column column, Value value_of) {
        whole().add_derived(std::move(column), value_of);
    }
    template <class Place>
    [[nodiscard]] auto part(Place place) {
        return whole().part(place);
    }
    template <class Condition>
    [[nodiscard]] auto part_if(Condition condition) {
        return whole().part_if(condition);
    }

    /// Adds the column of that name of another table, which must be there, as it is written and
    /// read there: of a table of the same records, or of what they are derived from.
    template <class Base>
    void add_like(const TableOf<Base>& other, const std::string& name) {
        const auto& columns = other.info_.columns;
        const Column* at = find_named(columns, name);
        if (at == nullptr)
            throw Error(other.info_.file, "it has no column " + name, heading(other.info_));
        const auto i = static_cast<std::size_t>(at - columns.data());
        add(*at, other.writers_[i], other.readers_[i]);
    }

    [[nodiscard]] const TableInfo& info() const { return info_; }
    operator const TableInfo&() const { return info_; }  // what plans and dictionaries take

    /// One line with its line break.
    [[nodiscard]] std::string line(const Record& record) const {
        std::string text;
        for (const Write& write : writers_) {
            if (&write != &writers_.front()) text += ',';
            text += write(record);
        }
        return text + '\n';
    }

    /// The whole file: heading, and a line per record.
    [[nodiscard]] std::string file(const std::vector<Record>& records) const {
        std::string text = heading(info_);
        for (const Record& record : records)
            text += line(record);
        return text;
    }

    /// Reads line `i` of a table whose columns were checked into `record`: what no column holds
    /// stays as it is. Throws Error for a field that does not hold what its column asks for.
    void read_into(const CsvTable& table, std::size_t i, Record& record) const {
        for (std::size_t column = 0; column < readers_.size(); ++column)
            readers_[column](CsvField(table, i, column), record);
    }

    /// All records. Throws Error for other columns than these, or a wrong field.
    [[nodiscard]] std::vector<Record> read(const CsvTable& table) const {
        check_columns(table, info_);
        std::vector<Record> records(table.records.size());
        for (std::size_t i = 0; i < records.size(); ++i)
            read_into(table, i, records[i]);
        return records;
    }

  private:
    template <class Other>
    friend class TableOf;

    [[nodiscard]] auto whole() {
        const auto find = [](const Record& record) { return &record; };
        const auto make = [](Record& record) -> Record& { return record; };
        return PartOf<Record, decltype(find), decltype(make), false>(*this, find, make);
    }

    TableInfo info_;
    std::vector<Write> writers_;
    std::vector<Read> readers_;
};

}  // namespace ink::core
