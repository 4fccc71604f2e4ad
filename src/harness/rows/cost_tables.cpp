#include "harness/rows/cost_tables.h"

#include "harness/rows/row_parts.h"

namespace ink::harness {
namespace {

void add_declared(const core::PartOf<CostFacts>& facts) {
    using C = method::Cost;
    using B = method::PixelBytes;
    const auto declared = facts.part(&CostFacts::declared);
    declared.add(
        {"passes", "", "over the triangles that the method declares; 0: it declares nothing"},
        &C::passes);
    declared.add({"interpolants", "", "planes set up per triangle, beside that of depth"},
                 &C::interpolants);
    declared.add({"values_per_vertex", "", "numbers computed at a vertex to be interpolated"},
                 &C::values_per_vertex);
    declared.add({"shares_vertices", "", "false: every triangle has three of its own"},
                 &C::shares_vertices);
    const auto fill = declared.part(&C::fill);
    fill.add({"fill_bytes_read", "B/px", "per covered pixel of a triangle, hidden ones too"},
             &B::read);
    fill.add({"fill_bytes_written", "B/px", "the same"}, &B::written);
    const auto filter = declared.part(&C::filter);
    filter.add({"filter_bytes_read", "B/px", "per pixel of the frame, empty ones too"}, &B::read);
    filter.add({"filter_bytes_written", "B/px", "the same"}, &B::written);
    declared.add({"buffer_bytes_per_px", "B/px", "cleared once a frame, depth included"},
                 &C::buffer_bytes_per_px);
}

void add_frame(const core::PartOf<CostFacts>& facts) {
    using F = FrameCounts;
    const auto frame = facts.part(&CostFacts::frame);
    frame.add({"frame_vertices", "", "of the meshes, counted once per instance"}, &F::vertices);
    frame.add({"frame_triangles", "", "over all instances, those outside the image too"},
              &F::triangles);
    frame.add({"frame_covered_px", "px", "area in the image summed over all triangles"},
              &F::covered_px);
    frame.add({"frame_px", "px", "width times height"}, &F::frame_px);
}

RowTable make_table() {
    RowTable table("cost.csv",
                   "A line per cell of a method: what it declares of its work, and what the view "
                   "asks of it.");
    table.add({"cell", "", "of rows.csv"}, &RowRecord::cell);
    const auto facts = table.part(&RowRecord::row).part(&Row::cost);
    add_declared(facts);
    add_frame(facts);
    return table;
}

}  // namespace

const RowTable& cost_table() {
    static const RowTable kTable = make_table();
    return kTable;
}

std::string cost_line(std::int64_t cell, const Row& row) {
    return row.cost ? cost_table().line({cell, Study::compare, row}) : "";
}

void join_costs(const core::CsvTable& csv, std::vector<RowRecord>& rows) {
    core::check_columns(csv, cost_table());
    const IndexOf<RowRecord> cells(rows);
    for (std::size_t i = 0; i < csv.records.size(); ++i) {
        RowRecord& record = cells.find(core::CsvField(csv, i, 0));
        if (record.row.cost) core::CsvField(csv, i, 0).refuse("every cell once");
        cost_table().read_into(csv, i, record);
    }
}

}  // namespace ink::harness
