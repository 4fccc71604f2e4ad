#include "studies/axis_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ink::studies {

const harness::SideTable<AxisRow>& faults_table() {
    static const auto kTable = [] {
        harness::SideTable<AxisRow> table("stress.csv",
                                          "A line per cell of study `stress`: what went wrong; its "
                                          "place on an axis of difficulty "
                                          "and its scores are in the row.");
        using C = CaseFaults;
        const auto faults = table.part(&AxisRow::faults);
        faults.add(
            {"non_finite", "", "numbers that are NaN or infinite, of view, truth and scores"},
            &C::non_finite);
        faults.add({"overflow", "", "codes that overflowed"}, &C::overflow);
        faults.add({"lost_cell", "", "1 if the cell has no result"}, &C::lost);
        faults.add({"differing", "", "1 if the image differs where the axis allows none to"},
                   &C::differing);
        return table;
    }();
    return kTable;
}

std::vector<AxisRow> read_faults(const core::CsvTable& csv, const harness::RowIndex& rows) {
    return faults_table().read_with_rows(
        csv, rows, [](AxisRow& of, const harness::Row& row) { of.row = row; });
}

const core::TableOf<Axis>& axes_table() {
    static const auto kTable = [] {
        core::TableOf<Axis> table("axes.csv", "A line per axis of the run: what it varies.");
        table.add_derived({"axis", "", "as in rows.csv"}, &Axis::name);
        table.add_derived({"title", "", "what its values are"}, &Axis::title);
        table.add_derived({"unit", "", "of its values; empty for a pure number"}, &Axis::unit);
        table.add_derived({"is_log", "", "true: values lie on a logarithmic scale"},
                          [](const Axis& axis) { return axis.scale == AxisScale::log; });
        table.add_derived({"sentence", "", "what is varied, and what stays"}, &Axis::sentence);
        table.add_derived(
            {"value_names", "", "of named values 1, 2, 3 and so on, a;b;c; empty for numbers"},
            [](const Axis& axis) { return fmt::format("{}", fmt::join(axis.value_names, ";")); });
        return table;
    }();
    return kTable;
}

}  // namespace ink::studies
