#include "harness/rows/score_tables.h"

#include <fmt/format.h>

#include "harness/cells/cell.h"
#include "harness/rows/row_parts.h"

namespace ink::harness {
namespace {

template <class At>
SideTable<CountsAt<At>> counts_table(const std::string& file,
                                     const std::string& doc,
                                     core::Column at) {
    using C = score::CurveCount;
    SideTable<CountsAt<At>> table(file, doc);
    table.add(std::move(at), &CountsAt<At>::at);
    const auto counts = table.part(&CountsAt<At>::counts);
    counts.add({"k", "px", "one-to-one matches"}, &C::k);
    counts.add({"n_pred", "px", "drawn pixels after thinning that count"}, &C::n_pred);
    counts.add({"n_truth", "px", "true pixels"}, &C::n_truth);
    return table;
}

}  // namespace

const SideTable<CountsAt<int>>& curves_table() {
    static const auto kTable = counts_table<int>(
        "curves.csv",
        "99 lines per scored cell: its counts within 2 px at every threshold.",
        {"threshold",
         "1/100",
         "of the full edge response: a pixel is on where 100 S >= 255 threshold"});
    return kTable;
}

const SideTable<CountsAt<double>>& tolerances_table() {
    static const auto kTable = counts_table<double>(
        "tolerances.csv",
        "A line per scored cell and tolerance: its counts at its own threshold.",
        {"tolerance_px", "px", "how far a match may be, centre to centre"});
    return kTable;
}

const SideTable<BinCount>& bins_table() {
    static const auto kTable = [] {
        SideTable<BinCount> table(
            "bins.csv",
            "A line per cell and bin of a property of true lines: how much of it was found within "
            "2 px, by a matching of its own. Bins without a true pixel are left out.");
        std::vector<std::string> names, docs;
        for (const LineAttribute& a : line_attributes()) {
            names.push_back(a.name);
            docs.push_back(fmt::format("{}: {}", a.name, a.doc));
        }
        table.add_named({"attribute", "", fmt::format("{}", fmt::join(docs, "; "))},
                        &BinCount::attribute,
                        names);
        table.add({"low", "of attribute", "the bin begins here; inf: the sky behind"},
                  &BinCount::low);
        table.add({"high", "of attribute", "and ends before here; the last holds its end"},
                  &BinCount::high);
        table.add({"k", "px", "one-to-one matches"}, &BinCount::k);
        table.add({"n_truth", "px", "true pixels"}, &BinCount::n_truth);
        return table;
    }();
    return kTable;
}

std::string curve_lines(std::int64_t cell, const std::array<score::CurveCount, 99>& counts) {
    std::string lines;
    for (std::size_t i = 0; i < counts.size(); ++i)
        lines += curves_table().line(cell, {static_cast<int>(i + 1), counts[i]});
    return lines;
}

std::vector<CurveRecord> read_curves(const core::CsvTable& csv, const RowIndex& rows) {
    const auto read = curves_table().read(csv);
    std::vector<CurveRecord> records;
    for (std::size_t i = 0; i < read.size(); ++i) {
        const std::size_t at = i % 99;
        if (read[i].at != static_cast<int>(at + 1))
            core::CsvField(csv, i, 1).refuse(
                fmt::format("{}: 1 to 99 in a row for every cell", at + 1));
        if (at == 0) {
            const Row& row = rows.find(core::CsvField(csv, i, 0)).row;
            records.push_back({read[i].cell, {row.method, {}}});
        }
        if (read[i].cell != records.back().cell)
            core::CsvField(csv, i, 0).refuse(fmt::format("cell {}, up to 99", records.back().cell));
        records.back().curve.counts[at] = read[i].counts;
    }
    if (read.size() % 99 != 0)
        core::CsvField(csv, read.size() - 1, 1).refuse("99 on the last line");
    return records;
}

std::string tolerance_lines(std::int64_t cell, const std::vector<score::CurveCount>& counts) {
    std::string lines;
    for (std::size_t i = 0; i < counts.size(); ++i)
        lines += tolerances_table().line(cell, {kTolerances_px.at(i), counts[i]});
    return lines;
}

void join_tolerances(const core::CsvTable& csv, std::vector<RowRecord>& rows) {
    const IndexOf<RowRecord> cells(rows);
    const auto read = tolerances_table().read(csv);
    for (std::size_t i = 0; i < read.size(); ++i) {
        Row& row = cells.find(core::CsvField(csv, i, 0)).row;
        if (row.tolerance_sweep.size() == kTolerances_px.size())
            core::CsvField(csv, i, 0).refuse("every tolerance once");
        const double wanted_px = kTolerances_px[row.tolerance_sweep.size()];
        if (read[i].at != wanted_px)
            core::CsvField(csv, i, 1).refuse(
                fmt::format("{}, next of {}", wanted_px, fmt::join(kTolerances_px, ", ")));
        row.tolerance_sweep.push_back(read[i].counts);
    }
}

std::string bin_lines(std::int64_t cell, const std::vector<BinCount>& counts) {
    std::string lines;
    for (const BinCount& bin : counts)
        lines += bins_table().line(cell, bin);
    return lines;
}

void join_bins(const core::CsvTable& csv, std::vector<RowRecord>& rows) {
    const IndexOf<RowRecord> cells(rows);
    const auto read = bins_table().read(csv);
    for (std::size_t i = 0; i < read.size(); ++i) {
        Row& row = cells.find(core::CsvField(csv, i, 0)).row;
        if (!row.is_scored()) core::CsvField(csv, i, 0).refuse("a cell whose row has a score");
        row.bins.push_back(read[i]);
    }
}

}  // namespace ink::harness
