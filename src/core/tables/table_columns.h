#pragma once

#include <cstddef>
#include <functional>
#include <string>
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

}  // namespace ink::core
