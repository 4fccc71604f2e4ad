#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/tables/csv_table.h"
#include "core/tables/table_of.h"
#include "harness/rows/row.h"

namespace ink::harness {

/// What a cell was measured for: the column `study` of rows.csv. A study of one's own has a name of
/// its own.
struct Study {
    static constexpr const char* compare = "compare";
    static constexpr const char* stress = "stress";
    static constexpr const char* motion = "motion";
    static constexpr const char* tune = "tune";
};

/// A line of rows.csv: a cell's number, what it was measured for, and all else that it says.
struct RowRecord {
    std::int64_t cell = 0;  ///< what side tables name it by
    std::string study = Study::compare;
    Row row;
};

/// The columns of rows.csv: cell, study, axis, value, then what the cell is, its scores, counts and
/// sums, times, skips and provenance.
[[nodiscard]] const core::TableOf<RowRecord>& rows_table();

/// One line with its line break (RFC 4180 quoting). Numbers are in the shortest form that reads
/// back to the same value, whatever the locale. Counts of a row without a score are empty, as its
/// metrics are; so is draw_n where nothing was timed.
[[nodiscard]] std::string row_line(std::int64_t cell, const std::string& study, const Row& row);

/// The rows of rows.csv: row_line of what is read gives the same bytes again. What other tables
/// hold of a row (tolerances, bins, cost facts) is left out. Throws core::Error that names file,
/// line, column and value for another heading, a wrong field, or a cell that is there twice.
[[nodiscard]] std::vector<RowRecord> read_rows(const core::CsvTable& table);

/// The rows of a run by their cell; `Record` is RowRecord, constant or not.
template <class Record>
class IndexOf {
  public:
    /// Borrows `rows`.
    template <class Rows>
    explicit IndexOf(Rows& rows) {
        for (Record& row : rows)
            by_cell_.emplace(row.cell, &row);
    }
    /// The record that a field of a side table names; another number is refused.
    [[nodiscard]] Record& find(const core::CsvField& cell) const {
        Record* found = find(cell.as<std::int64_t>());
        if (found == nullptr) cell.refuse("the number of a cell of rows.csv");
        return *found;
    }
    /// The record of a cell, or null.
    [[nodiscard]] Record* find(std::int64_t cell) const {
        const auto found = by_cell_.find(cell);
        return found == by_cell_.end() ? nullptr : found->second;
    }

  private:
    std::map<std::int64_t, Record*> by_cell_;
};
using RowIndex = IndexOf<const RowRecord>;

/// The table of rows while it is put together.
using RowTable = core::TableOf<RowRecord>;

/// Adds soft F and the ink that it is made of.
void add_ink_columns(const core::PartOf<score::SoftScore>& soft);

}  // namespace ink::harness
