#pragma once

#include <bit>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/tables/csv_table.h"
#include "core/tables/table.h"

namespace ink::core {

/// The way from a record to a part of it, without their types.
class Way {
  public:
    /// From a part to what lies in it: null where it lacks, unless it is to be made.
    using Step = std::function<void*(void* part, bool is_made)>;

    /// The same way, and on to a member that lies there.
    [[nodiscard]] Way to(std::ptrdiff_t offset) const;
    /// The same way and a step more; what it leads to may lack.
    [[nodiscard]] Way to(Step step, bool may_lack) const;

    /// What it leads to, null if that lacks; of a constant record it is not to be changed.
    [[nodiscard]] void* find(const void* record) const;
    /// The same, made if need be.
    [[nodiscard]] void* make(void* record) const;
    [[nodiscard]] bool may_lack() const { return may_lack_; }

  private:
    [[nodiscard]] void* follow(void* record, bool is_made) const;

    Step step_;                  ///< from the record; none: the way begins with it
    std::ptrdiff_t offset_ = 0;  ///< behind that
    bool may_lack_ = false;
};

/// How values of one type become fields, and are read back.
struct ValueType {
    bool is_text = false;
    std::string (*write)(const void* value) = nullptr;
    void (*read)(const CsvField& field, void* value) = nullptr;
};

/// How values of a type whose values are counted from 0 become numbers, and back.
struct CountedType {
    std::size_t (*load)(const void* value) = nullptr;
    void (*store)(void* value, std::size_t number) = nullptr;
};

/// The columns of a table without the type of its records, so that they are compiled once and not
/// for each type. A `void*` is a record of the table's type, or what a way leads to.
class TableColumns {
  public:
    using Write = std::function<std::string(const void*)>;
    using Read = std::function<void(const CsvField&, void*)>;

    /// What a column writes and reads.
    struct Field {
        Way way;
        Write write;
        Read read;  ///< none: the column is written and not read

        [[nodiscard]] std::string text_of(const void* record) const;
        void read_into(const CsvField& field, void* record) const;
    };

    TableColumns(std::string file, std::string doc);
    TableColumns(const TableColumns&);
    TableColumns& operator=(const TableColumns&) = delete;
    ~TableColumns();

    void add(Column column, Field field);
    void add_value(Column column, const Way& way, const ValueType& type);
    void add_named(Column column,
                   const Way& way,
                   const CountedType& type,
                   std::vector<std::string> names);

    [[nodiscard]] const TableInfo& info() const { return info_; }
    /// Throws Error if no column has that name.
    [[nodiscard]] std::size_t find(const std::string& name) const;
    [[nodiscard]] const Field& field(std::size_t i) const { return fields_[i]; }
    [[nodiscard]] std::string line(const void* record) const;
    void read_into(const CsvTable& table, std::size_t i, void* record) const;

  private:
    TableInfo info_;
    std::vector<Field> fields_;
};

template <class T>
inline constexpr bool kIsText = std::is_convertible_v<T, std::string_view>;

template <class T>
inline constexpr ValueType kValueType = {
    kIsText<T>,
    [](const void* value) { return csv_text(*static_cast<const T*>(value)); },
    [](const CsvField& field, void* value) { field.read(*static_cast<T*>(value)); }};

template <class T>
inline constexpr CountedType kCountedType = {
    [](const void* value) { return static_cast<std::size_t>(*static_cast<const T*>(value)); },
    [](void* value, std::size_t number) { *static_cast<T*>(value) = static_cast<T>(number); }};

/// A part of a table's records, to add columns of it, or the whole of them. What a record has not
/// is an empty field, and an empty field makes nothing.
///
/// Members and further parts are named by a `place`: a pointer to a member, or a callable that
/// gives a reference into the part.
template <class Part>
class PartOf {
  public:
    PartOf(TableColumns& table, Way way) : table_(&table), way_(std::move(way)) {}

    /// A column that holds what `place` finds in the part.
    template <class Place>
    void add(Column column, Place place) const {
        table_->add_value(std::move(column), way_to(place), kValueType<ValueAt<Place>>);
    }
    /// A column that holds one of `names`: that of the number, or the enumerator, at `place`.
    /// Another word is refused.
    template <class Place>
    void add_named(Column column, Place place, std::vector<std::string> names) const {
        table_->add_named(
            std::move(column), way_to(place), kCountedType<ValueAt<Place>>, std::move(names));
    }
    /// A column that follows from others; it is written and not read.
    template <class Value>
    void add_derived(Column column, Value value_of) const {
        if constexpr (std::is_member_object_pointer_v<Value>) {
            ValueType type = kValueType<ValueAt<Value>>;
            type.read = nullptr;
            table_->add_value(std::move(column), way_to(value_of), type);
        } else {
            column.is_text = kIsText<std::invoke_result_t<Value, const Part&>>;
            table_->add(
                std::move(column),
                {way_,
                 [value_of](const void* part) {
                     return csv_text(std::invoke(value_of, *static_cast<const Part*>(part)));
                 },
                 nullptr});
        }
    }

    /// What lies at `place` in this part; an optional may lack.
    template <class Place>
    [[nodiscard]] auto part(Place place) const {
        return present(way_to(place), static_cast<At<Place>*>(nullptr));
    }
    /// The same part, which lacks where `condition` does not hold of it.
    template <class Condition>
    [[nodiscard]] PartOf part_if(Condition condition) const {
        const auto step = [condition](void* part, bool is_made) {
            const bool is_there =
                is_made || std::invoke(condition, *static_cast<const Part*>(part));
            return is_there ? part : nullptr;
        };
        return {*table_, way_.to(step, true)};
    }

  private:
    template <class Place>
    using At = std::remove_reference_t<std::invoke_result_t<Place, Part&>>;
    template <class Place>
    using ValueAt = std::remove_const_t<At<Place>>;

    template <class Place>
    [[nodiscard]] Way way_to(Place place) const {
        if constexpr (std::is_member_object_pointer_v<Place>) {
            // Where it lies in the part, whatever base of it has the member; by the C++ ABI of all
            // our compilers the pointer is that number.
            const ValueAt<Place> std::remove_const_t<Part>::*member = place;
            return way_.to(std::bit_cast<std::ptrdiff_t>(member));
        } else {
            const auto step = [place](void* part, bool) {
                const void* at = &std::invoke(place, *static_cast<Part*>(part));
                return const_cast<void*>(at);
            };
            return way_.to(step, false);
        }
    }

    template <class T>
    [[nodiscard]] PartOf<T> present(const Way& way, T*) const {
        return {*table_, way};
    }
    template <class T>
    [[nodiscard]] PartOf<T> present(const Way& way, std::optional<T>*) const {
        const auto step = [](void* part, bool is_made) -> void* {
            auto& value = *static_cast<std::optional<T>*>(part);
            if (is_made && !value) value.emplace();
            return value ? &*value : nullptr;
        };
        return {*table_, way.to(step, true)};
    }

    TableColumns* table_;
    Way way_;
};

/// A table of records: what its columns are called and mean, how a record writes each, and how each
/// is read back. One list, so that the three cannot drift apart.
template <class Record>
class TableOf {
  public:
    TableOf(std::string file, std::string doc) : columns_(std::move(file), std::move(doc)) {}

    /// A column with a writer and a reader of its own.
    template <class Write, class Read>
    void add(Column column, Write write, Read read) {
        columns_.add(std::move(column),
                     {Way(),
                      [write](const void* record) -> std::string {
                          return write(*static_cast<const Record*>(record));
                      },
                      [read](const CsvField& field, void* record) {
                          read(field, *static_cast<Record*>(record));
                      }});
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
        const std::size_t i = other.columns_.find(name);
        add(
            other.info().columns[i],
            [like = other.columns_.field(i)](const Base& record) { return like.text_of(&record); },
            [like = other.columns_.field(i)](const CsvField& field, Base& record) {
                like.read_into(field, &record);
            });
    }

    [[nodiscard]] const TableInfo& info() const { return columns_.info(); }
    operator const TableInfo&() const { return info(); }  // what plans and dictionaries take

    /// One line with its line break.
    [[nodiscard]] std::string line(const Record& record) const { return columns_.line(&record); }

    /// The whole file: heading, and a line per record.
    [[nodiscard]] std::string file(const std::vector<Record>& records) const {
        std::string text = heading(info());
        for (const Record& record : records)
            text += line(record);
        return text;
    }

    /// Reads line `i` of a table whose columns were checked into `record`: what no column holds
    /// stays as it is. Throws Error for a field that does not hold what its column asks for.
    void read_into(const CsvTable& table, std::size_t i, Record& record) const {
        columns_.read_into(table, i, &record);
    }

    /// All records. Throws Error for other columns than these, or a wrong field.
    [[nodiscard]] std::vector<Record> read(const CsvTable& table) const {
        check_columns(table, info());
        std::vector<Record> records(table.records.size());
        for (std::size_t i = 0; i < records.size(); ++i)
            read_into(table, i, records[i]);
        return records;
    }

  private:
    template <class Other>
    friend class TableOf;

    [[nodiscard]] PartOf<Record> whole() { return {columns_, Way()}; }

    TableColumns columns_;
};

}  // namespace ink::core
