#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/tables/csv_table.h"
#include "experiment/block_store.h"
#include "experiment/run_record.h"
#include "harness/rows/row.h"
#include "statistics/ods.h"
#include "studies/axis_rows.h"
#include "studies/axis_summary.h"
#include "summary/summary_csv.h"

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

/// Those of the first size and number of threads: no one time of a method means anything over
/// several.
[[nodiscard]] std::vector<harness::Row> rows_of_one_place(std::vector<harness::Row> rows);

/// A field of a method's line in methods.csv; "" where that has none.
[[nodiscard]] std::string method_fact(const RunData& run,
                                      const std::string& method,
                                      std::string_view column);

/// Reads the run in `folder`; of one that was killed, what its finished blocks hold. Throws
/// core::Error (where = the folder) if there is no run in it, or one that cannot be read.
[[nodiscard]] RunData read_run(const std::filesystem::path& folder);

/// The tables of the finished blocks of a run, by file name: their lines in plan order, with the
/// times that the cost model predicts from all of them, and summary.csv, differences.csv or
/// axis_summary.csv where the run has what they are made from. A function of the blocks alone:
/// whoever computed which, the bytes are the same. Blocks that are missing leave their lines out,
/// and those of other tables about cells that rows.csv lacks then.
[[nodiscard]] std::map<std::string, std::string> finished_tables(const RunRecord& record,
                                                                 const BlockStore& store);

}  // namespace ink::experiment
