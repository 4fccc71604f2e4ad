#include "linear_code/cancellation_table.h"

#include "harness/tables/table_of.h"

namespace ink::linear_code {
namespace {

struct Record {
    std::int64_t cell = 0;
    CancellationRow row;
};
using CancellationTable = harness::TableOf<Record>;

void add_kind(CancellationTable& table) {
    table.add(
        {"class", "", "of line: contour, boundary, crease, intersection, seam"},
        [](const Record& r) { return std::string(truth::name(r.row.kind.line_class)); },
        [](const harness::CsvField& field, Record& r) {
            for (const truth::LineClass c : truth::kLineClasses) {
                if (truth::name(c) != field.text()) continue;
                r.row.kind.line_class = c;
                return;
            }
            field.refuse("contour, boundary, crease, intersection, seam");
        });
    table.add(
        {"dihedral_low_deg", "deg", "dihedral deviation of the two faces at which the bin begins"},
        [](auto& r) -> auto& { return r.row.kind.dihedral_low_deg; });
    table.add_derived({"dihedral_high_deg", "deg", "at which the bin ends"}, [](const Record& r) {
        const auto low = r.row.kind.dihedral_low_deg;
        return low ? std::optional(*low + kDihedralBin_deg) : std::nullopt;
    });
}

const CancellationTable& table() {
    static const CancellationTable kTable = [] {
        CancellationTable table("cancellation.csv",
                                "A line per cell of a method with a declared code, class of line "
                                "and dihedral: how much "
                                "is lost because changes of channels cancel, as predicted and as "
                                "measured, within 2 px.");
        table.add(
            {"cell", "", "of rows.csv"}, [](auto& r) -> auto& { return r.cell; });
        table.add(
            {"silent_deg", "deg", "the dihedral up to which the code is silent"},
            [](auto& r) -> auto& { return r.row.silent_deg; });
        add_kind(table);
        table.add(
            {"n_truth", "px", "true pixels of the kind"},
            [](auto& r) -> auto& { return r.row.count.n_truth; });
        table.add(
            {"predicted_missed", "px", "of them without a match, as predicted"},
            [](auto& r) -> auto& { return r.row.count.predicted_missed; });
        table.add(
            {"measured_missed", "px", "of them without a match"},
            [](auto& r) -> auto& { return r.row.count.measured_missed; });
        table.add(
            {"predicted_false_negatives", "px", "of them with nothing in reach, as predicted"},
            [](auto& r) -> auto& { return r.row.count.predicted_false_negatives; });
        table.add(
            {"measured_false_negatives", "px", "of them with nothing drawn in reach"},
            [](auto& r) -> auto& { return r.row.count.measured_false_negatives; });
        table.add(
            {"both_false_negatives", "px", "of them both"},
            [](auto& r) -> auto& { return r.row.count.both_false_negatives; });
        return table;
    }();
    return kTable;
}

}  // namespace

const harness::TableInfo& cancellation_table() {
    return table().info();
}

std::string cancellation_line(std::int64_t cell, const CancellationRow& row) {
    return table().line({cell, row});
}

std::vector<CancellationRow> read_cancellation(const harness::CsvTable& csv,
                                               const harness::RowIndex& rows) {
    std::vector<CancellationRow> read;
    for (Record& record : table().read(csv)) {
        const harness::Row& row = rows.find(harness::CsvField(csv, read.size(), 0)).row;
        record.row.method = row.method;
        record.row.scene = row.scene;
        record.row.view = row.view;
        record.row.split = row.split;
        record.row.width_px = row.width;
        record.row.height_px = row.height;
        read.push_back(std::move(record.row));
    }
    return read;
}

}  // namespace ink::linear_code
