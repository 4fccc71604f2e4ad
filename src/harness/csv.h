#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "harness/row.h"
#include "score/score.h"

namespace ink::harness {

/// A CSV field: quoted as RFC 4180 has it if it holds a comma, a quote or a line break.
[[nodiscard]] std::string csv_field(const std::string& text);

/// A table that grows line by line and is never half-written under its own name.
///
/// Lines go to `path` + ".part", flushed one by one, so that a run that is killed leaves every
/// finished line there; `finish` gives the file its name. A table that is destroyed unfinished
/// keeps its part, unless that holds no line but the heading.
class CsvFile {
  public:
    /// Throws core::Error (where = the path) if the file cannot be made.
    CsvFile(std::filesystem::path path, const std::vector<std::string>& columns);
    ~CsvFile();
    CsvFile(const CsvFile&) = delete;
    CsvFile& operator=(const CsvFile&) = delete;

    /// Adds lines; `lines` has no final line break. Throws core::Error if the disk is full.
    void write(const std::string& lines);
    /// Gives the file its name; an older one is replaced at once.
    void finish();

  private:
    void write_flushed(const std::string& lines);

    std::filesystem::path path_;
    std::filesystem::path part_;
    std::ofstream stream_;
    bool has_lines_ = false;
};

/// What tells a cell from others in files beside rows.csv: method,scene,view,width,height,params.
[[nodiscard]] std::string cell_key(const Row& row);

/// The columns of curves.csv: the cell's key, then threshold_k, k, n_pred, n_truth.
[[nodiscard]] const std::vector<std::string>& curve_columns();

/// The 99 lines of one cell: threshold_k = 1..99 hundredths of the full strength.
[[nodiscard]] std::string curve_csv(const Row& row, const std::array<score::CurveCount, 99>& curve);

/// The columns of ladder.csv: the cell's key, then tolerance_px, k, n_pred, n_truth.
[[nodiscard]] const std::vector<std::string>& ladder_columns();

/// A line per tolerance of the cell; "" if it has no ladder.
[[nodiscard]] std::string ladder_csv(const Row& row);

}  // namespace ink::harness
