#include "studies/stress_table.h"

#include "harness/tables/side_table.h"

namespace ink::studies {
namespace {

const harness::SideTable<StressRow>& table() {
    static const auto kTable = [] {
        harness::SideTable<StressRow> table(
            "stress.csv",
            "A line per cell of study `stress`: its place on an axis of "
            "difficulty, and what went wrong; its scores are in the row.");
        table.add({"axis", "", "what grows: `inkbench list axes` explains each"}, &StressRow::axis);
        table.add({"value", "of unit", "where on the axis; of named values the number"},
                  &StressRow::value);
        table.add({"unit", "", "of value; empty for a pure number"}, &StressRow::unit);
        using C = StressCounts;
        const auto counts = table.part(&StressRow::counts);
        counts.add(
            {"non_finite", "", "numbers that are NaN or infinite, of view, truth and scores"},
            &C::non_finite);
        counts.add({"overflow", "", "codes that overflowed"}, &C::overflow);
        counts.add({"lost_cell", "", "1 if the cell has no result"}, &C::lost);
        counts.add({"differing", "", "1 if the image differs where the axis allows none to"},
                   &C::differing);
        return table;
    }();
    return kTable;
}

}  // namespace

const harness::TableInfo& stress_table() {
    return table().info();
}

std::string stress_line(std::int64_t cell, const StressRow& row) {
    return table().line(cell, row);
}

std::vector<StressRow> read_stress(const harness::CsvTable& csv, const harness::RowIndex& rows) {
    return table().read_with_rows(
        csv, rows, [](StressRow& stressed, const harness::Row& row) { stressed.row = row; });
}

}  // namespace ink::studies
