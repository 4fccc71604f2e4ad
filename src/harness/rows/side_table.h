#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/tables/table_of.h"
#include "harness/rows/row_table.h"

namespace ink::harness {

/// What a side table says of a cell.
template <class T>
struct OfCell : T {
    std::int64_t cell = 0;
};

/// A table that says more of the cells of rows.csv: its first column names the cell.
template <class T>
class SideTable : public core::TableOf<OfCell<T>> {
  public:
    SideTable(std::string file, std::string doc)
        : core::TableOf<OfCell<T>>(std::move(file), std::move(doc)) {
        this->add({"cell", "", "of rows.csv"}, &OfCell<T>::cell);
    }

    /// One line with its line break.
    [[nodiscard]] std::string line(std::int64_t cell, const T& of) const {
        return core::TableOf<OfCell<T>>::line({of, cell});
    }

    /// What all lines say, each completed by `complete(record, row)` from the row of its cell.
    /// Throws core::Error for other columns than these, a wrong field, or a cell that `rows` does
    /// not have.
    template <class Complete>
    [[nodiscard]] std::vector<T> read_with_rows(const core::CsvTable& csv,
                                                const RowIndex& rows,
                                                const Complete& complete) const {
        std::vector<T> all;
        for (OfCell<T>& record : this->read(csv)) {
            complete(record, rows.find(core::CsvField(csv, all.size(), 0)).row);
            all.push_back(std::move(record));
        }
        return all;
    }
};

}  // namespace ink::harness
