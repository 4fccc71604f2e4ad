#include "lab/csv.h"

#include <fmt/format.h>

#include "core/error.h"

namespace ink::lab {

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
    static const std::vector<std::string> kColumns = {"method",
                                                      "scene",
                                                      "view",
                                                      "width",
                                                      "height",
                                                      "params",
                                                      "threshold_k",
                                                      "k",
                                                      "n_pred",
                                                      "n_truth"};
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
    for (std::size_t i = 0; i < curve.size(); ++i) {
        lines += fmt::format("{}{},{},{},{},{}",
                             i == 0 ? "" : "\n",
                             key,
                             i + 1,
                             curve[i].k,
                             curve[i].n_pred,
                             curve[i].n_truth);
    }
    return lines;
}

}  // namespace ink::lab
