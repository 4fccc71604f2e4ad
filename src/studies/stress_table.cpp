#include "studies/stress_table.h"

#include "harness/tables/table_of.h"

namespace ink::studies {
namespace {

struct Record {
    std::int64_t cell = 0;
    StressRow row;
};

const harness::TableOf<Record>& table() {
    static const harness::TableOf<Record> kTable = [] {
        harness::TableOf<Record> table(
            "stress.csv",
            "A line per cell of study `stress`: its place on an axis of "
            "difficulty, and what went wrong; its scores are in the row.");
        table.add(
            {"cell", "", "of rows.csv"}, [](auto& r) -> auto& { return r.cell; });
        table.add(
            {"axis", "", "what grows: `inkbench list axes` explains each"},
            [](auto& r) -> auto& { return r.row.axis; });
        table.add(
            {"value", "of unit", "where on the axis; of named values the number"},
            [](auto& r) -> auto& { return r.row.value; });
        table.add(
            {"unit", "", "of value; empty for a pure number"},
            [](auto& r) -> auto& { return r.row.unit; });
        table.add(
            {"non_finite", "", "numbers that are NaN or infinite, of view, truth and scores"},
            [](auto& r) -> auto& { return r.row.counts.non_finite; });
        table.add(
            {"overflow", "", "codes that overflowed"},
            [](auto& r) -> auto& { return r.row.counts.overflow; });
        table.add(
            {"lost_cell", "", "1 if the cell has no result"},
            [](auto& r) -> auto& { return r.row.counts.lost; });
        table.add(
            {"differing", "", "1 if the image differs where the axis allows none to"},
            [](auto& r) -> auto& { return r.row.counts.differing; });
        return table;
    }();
    return kTable;
}

}  // namespace

const harness::TableInfo& stress_table() {
    return table().info();
}

std::string stress_line(std::int64_t cell, const StressRow& row) {
    return table().line({cell, row});
}

std::vector<StressRow> read_stress(const harness::CsvTable& csv, const harness::RowIndex& rows) {
    std::vector<StressRow> stressed;
    for (Record& record : table().read(csv)) {
        record.row.row = rows.find(harness::CsvField(csv, stressed.size(), 0)).row;
        stressed.push_back(std::move(record.row));
    }
    return stressed;
}

}  // namespace ink::studies
