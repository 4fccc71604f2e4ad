#include "harness/tables/score_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/cell.h"
#include "harness/tables/table_of.h"

namespace ink::harness {
namespace {

/// Counts of a cell at one of many thresholds or tolerances.
template <class At>
struct CountsAt {
    std::int64_t cell = 0;
    At at = 0;
    score::CurveCount counts;
};
using AtThreshold = CountsAt<int>;
using AtTolerance = CountsAt<double>;

template <class At>
TableOf<CountsAt<At>> counts_table(const std::string& file, const std::string& doc, Column at) {
    TableOf<CountsAt<At>> table(file, doc);
    table.add(
        {"cell", "", "of rows.csv"}, [](auto& r) -> auto& { return r.cell; });
    table.add(
        std::move(at), [](auto& r) -> auto& { return r.at; });
    table.add(
        {"k", "px", "one-to-one matches"}, [](auto& r) -> auto& { return r.counts.k; });
    table.add(
        {"n_pred", "px", "drawn pixels after thinning that count"},
        [](auto& r) -> auto& { return r.counts.n_pred; });
    table.add(
        {"n_truth", "px", "true pixels"}, [](auto& r) -> auto& { return r.counts.n_truth; });
    return table;
}

const TableOf<AtThreshold>& curves() {
    static const auto kTable = counts_table<int>(
        "curves.csv",
        "99 lines per scored cell: its counts within 2 px at every threshold.",
        {"threshold",
         "1/100",
         "of the full edge response: a pixel is on where 100 S >= 255 threshold"});
    return kTable;
}

const TableOf<AtTolerance>& tolerances() {
    static const auto kTable = counts_table<double>(
        "tolerances.csv",
        "A line per scored cell and tolerance: its counts at its own threshold.",
        {"tolerance_px", "px", "how far a match may be, centre to centre"});
    return kTable;
}

/// A bin of a cell.
struct CellBin {
    std::int64_t cell = 0;
    BinCount bin;
};

const TableOf<CellBin>& bins() {
    static const auto kTable = [] {
        TableOf<CellBin> table(
            "bins.csv",
            "A line per cell and bin of a property of true lines: how much of it was found within "
            "2 px, by a matching of its own. Bins without a true pixel are left out.");
        std::vector<std::string> names, docs;
        for (const LineAttribute& a : line_attributes()) {
            names.push_back(a.name);
            docs.push_back(fmt::format("{}: {}", a.name, a.doc));
        }
        table.add(
            {"cell", "", "of rows.csv"}, [](auto& r) -> auto& { return r.cell; });
        table.add(
            {"attribute", "", fmt::format("{}", fmt::join(docs, "; "))},
            [](const CellBin& r) { return line_attributes()[r.bin.attribute].name; },
            [names](const CsvField& field, CellBin& r) {
                const auto at = std::find(names.begin(), names.end(), field.text());
                if (at == names.end()) field.refuse(fmt::format("{}", fmt::join(names, ", ")));
                r.bin.attribute = static_cast<std::size_t>(at - names.begin());
            });
        table.add(
            {"low", "of attribute", "the bin begins here; inf: the sky behind"},
            [](auto& r) -> auto& { return r.bin.low; });
        table.add(
            {"high", "of attribute", "and ends before here; the last holds its end"},
            [](auto& r) -> auto& { return r.bin.high; });
        table.add(
            {"k", "px", "one-to-one matches"}, [](auto& r) -> auto& { return r.bin.k; });
        table.add(
            {"n_truth", "px", "true pixels"}, [](auto& r) -> auto& { return r.bin.n_truth; });
        return table;
    }();
    return kTable;
}

/// The row of rows.csv that record `i` of a side table names.
Row& row_of(const CsvTable& csv, std::size_t i, std::map<std::int64_t, Row*>& rows) {
    const CsvField field(csv, i, 0);
    const auto found = rows.find(field.as<std::int64_t>());
    if (found == rows.end()) field.refuse("the number of a cell of rows.csv");
    return *found->second;
}

std::map<std::int64_t, Row*> by_cell(std::vector<RowRecord>& rows) {
    std::map<std::int64_t, Row*> found;
    for (RowRecord& row : rows)
        found.emplace(row.cell, &row.row);
    return found;
}

}  // namespace

const TableInfo& curves_table() {
    return curves().info();
}

std::string curve_lines(std::int64_t cell, const std::array<score::CurveCount, 99>& counts) {
    std::string lines;
    for (std::size_t i = 0; i < counts.size(); ++i)
        lines += curves().line({cell, static_cast<int>(i + 1), counts[i]});
    return lines;
}

std::vector<CurveRecord> read_curves(const CsvTable& csv, const RowIndex& rows) {
    const std::vector<AtThreshold> read = curves().read(csv);
    std::vector<CurveRecord> records;
    for (std::size_t i = 0; i < read.size(); ++i) {
        const std::size_t at = i % 99;
        if (read[i].at != static_cast<int>(at + 1))
            CsvField(csv, i, 1).refuse(fmt::format("{}: 1 to 99 in a row for every cell", at + 1));
        if (at == 0) {
            const Row& row = rows.find(CsvField(csv, i, 0)).row;
            records.push_back({read[i].cell, {row.method, row.split == "train", {}}});
        }
        if (read[i].cell != records.back().cell)
            CsvField(csv, i, 0).refuse(fmt::format("cell {}, up to 99", records.back().cell));
        records.back().curve.counts[at] = read[i].counts;
    }
    if (read.size() % 99 != 0) CsvField(csv, read.size() - 1, 1).refuse("99 on the last line");
    return records;
}

const TableInfo& tolerances_table() {
    return tolerances().info();
}

std::string tolerance_lines(std::int64_t cell, const std::vector<score::CurveCount>& counts) {
    std::string lines;
    for (std::size_t i = 0; i < counts.size(); ++i)
        lines += tolerances().line({cell, kTolerances_px.at(i), counts[i]});
    return lines;
}

void join_tolerances(const CsvTable& csv, std::vector<RowRecord>& rows) {
    auto cells = by_cell(rows);
    const std::vector<AtTolerance> read = tolerances().read(csv);
    for (std::size_t i = 0; i < read.size(); ++i) {
        Row& row = row_of(csv, i, cells);
        if (row.tolerance_sweep.size() == kTolerances_px.size())
            CsvField(csv, i, 0).refuse("every tolerance once");
        const double wanted_px = kTolerances_px[row.tolerance_sweep.size()];
        if (read[i].at != wanted_px)
            CsvField(csv, i, 1).refuse(
                fmt::format("{}, next of {}", wanted_px, fmt::join(kTolerances_px, ", ")));
        row.tolerance_sweep.push_back(read[i].counts);
    }
}

const TableInfo& bins_table() {
    return bins().info();
}

std::string bin_lines(std::int64_t cell, const std::vector<BinCount>& counts) {
    std::string lines;
    for (const BinCount& bin : counts)
        lines += bins().line({cell, bin});
    return lines;
}

void join_bins(const CsvTable& csv, std::vector<RowRecord>& rows) {
    auto cells = by_cell(rows);
    const std::vector<CellBin> read = bins().read(csv);
    for (std::size_t i = 0; i < read.size(); ++i) {
        Row& row = row_of(csv, i, cells);
        if (!row.lines) CsvField(csv, i, 0).refuse("a cell whose row has line scores");
        row.lines->bins.push_back(read[i].bin);
    }
}

}  // namespace ink::harness
