#include "harness/csv.h"

#include <fmt/format.h>

#include "core/error.h"
#include "harness/cell.h"

namespace ink::harness {
namespace {

std::vector<std::string> columns_of_counts(const std::string& what) {
    return {"method", "scene", "view", "width", "height", "params", what, "k", "n_pred", "n_truth"};
}

/// Ends with a line break.
std::string counts_line(const std::string& key,
                        const std::string& at,
                        const score::CurveCount& counts) {
    return fmt::format("{},{},{},{},{}\n", key, at, counts.k, counts.n_pred, counts.n_truth);
}

}  // namespace

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

CsvFile::CsvFile(std::filesystem::path path, const std::vector<std::string>& columns)
    : path_(std::move(path)), part_(path_.string() + ".part"), stream_(part_, std::ios::trunc) {
    if (!stream_) {
        throw core::Error(path_.string(), "it cannot be written", "a file in a writable folder");
    }
    write_flushed(fmt::format("{}", fmt::join(columns, ",")));
}

CsvFile::~CsvFile() {
    if (!stream_.is_open() || has_lines_) return;
    stream_.close();
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
}

void CsvFile::write(const std::string& lines) {
    write_flushed(lines);
    has_lines_ = true;
}

void CsvFile::write_flushed(const std::string& lines) {
    stream_ << lines << '\n' << std::flush;
    if (!stream_) {
        throw core::Error(part_.string(),
                          "a line could not be written; those before it are there",
                          "room on the disk");
    }
}

void CsvFile::finish() {
    stream_.close();
    std::error_code failure;
    std::filesystem::rename(part_, path_, failure);
    if (failure) {
        throw core::Error(
            path_.string(),
            fmt::format("its lines are in {}, but it cannot be renamed", part_.string()),
            "a file in a writable folder");
    }
}

const std::vector<std::string>& curve_columns() {
    static const std::vector<std::string> kColumns = columns_of_counts("threshold_k");
    return kColumns;
}

std::string cell_key(const Row& row) {
    return fmt::format("{},{},{},{},{},{}",
                       csv_field(row.method),
                       csv_field(row.scene),
                       csv_field(row.view),
                       row.width,
                       row.height,
                       csv_field(row.params));
}

std::string curve_csv(const Row& row, const std::array<score::CurveCount, 99>& curve) {
    const std::string key = cell_key(row);
    std::string lines;
    for (std::size_t i = 0; i < curve.size(); ++i)
        lines += counts_line(key, fmt::format("{}", i + 1), curve[i]);
    lines.pop_back();
    return lines;
}

const std::vector<std::string>& ladder_columns() {
    static const std::vector<std::string> kColumns = columns_of_counts("tolerance_px");
    return kColumns;
}

std::string ladder_csv(const Row& row) {
    const std::string key = cell_key(row);
    std::string lines;
    for (std::size_t i = 0; i < row.ladder.size(); ++i)
        lines += counts_line(key, fmt::format("{}", kLadder_px[i]), row.ladder[i]);
    if (!lines.empty()) lines.pop_back();
    return lines;
}

}  // namespace ink::harness
