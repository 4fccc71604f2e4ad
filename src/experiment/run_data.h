#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/tables/csv_table.h"
#include "experiment/run_record.h"
#include "harness/rows/row.h"
#include "statistics/ods.h"
#include "studies/axis_rows.h"
#include "studies/axis_summary.h"
#include "summary/comparison.h"

namespace ink::experiment {

/// The tables of a run, by file name, headings included.
using CsvTables = std::map<std::string, core::CsvTable>;

/// Splits tables that are given as texts, those of the folder `where`. Throws core::Error (where =
/// its file, and the line) for text that is no table.
[[nodiscard]] CsvTables split_tables(const std::map<std::string, std::string>& texts,
                                     const std::filesystem::path& where);

/// What the tables of a run hold, read back. What a run has no table of is empty.
struct RunTables {
    std::vector<harness::Row> rows;             ///< of the study `compare`: one a method and view
    std::vector<statistics::CellCurve> curves;  ///< of the methods among them
    std::vector<harness::Row> sweep;            ///< a row per setting, method and swept view
    std::vector<studies::AxisRow> on_axes;      ///< of every study that is axes
};

/// Reads what tables hold. Throws core::Error (where = the table's file and the line) for what no
/// such table holds.
[[nodiscard]] RunTables parse_tables(const CsvTables& tables);

/// A run folder, read back whole: all that a page or a figure needs, but its images.
struct RunData {
    std::filesystem::path folder;
    RunRecord record;
    CsvTables csv;     ///< every table
    RunTables tables;  ///< the same, read
    /// What the rows of the first size and number of threads say together, as summary.csv and
    /// differences.csv have it; empty of a run that compares nothing.
    summary::Comparison comparison;
    studies::Finding finding = {};  ///< of a search, or of axes of difficulty
};

/// Leaves the rows and settings of the first size and number of threads: no one time of a method
/// means anything over several.
void keep_one_place(RunTables& tables);

/// Reads the run in `folder`; of one that was killed, what its finished blocks hold. Throws
/// core::Error (where = the folder) if there is no run in it, or one that cannot be read.
[[nodiscard]] RunData read_run(const std::filesystem::path& folder);

}  // namespace ink::experiment
