#include "harness/tables/cost_tables.h"

#include <map>

#include "harness/tables/row_parts.h"

namespace ink::harness {
namespace {

/// A number of the facts, at the place in them that `place` gives.
template <class Place>
RowTable::Field fact(Column column, Place place) {
    return {std::move(column),
            [place](const RowRecord& r) { return r.row.cost ? csv_text(place(*r.row.cost)) : ""; },
            [place](const CsvField& field, RowRecord& r) {
                if (field.is_empty()) return;
                if (!r.row.cost) r.row.cost.emplace();
                field.read(place(*r.row.cost));
            }};
}

std::vector<RowTable::Field> make_fields() {
    std::vector<RowTable::Field> fields = {
        fact(
            {"passes", "", "over the triangles that the method declares; 0: it declares nothing"},
            [](auto& f) -> auto& { return f.declared.passes; }),
        fact(
            {"interpolants", "", "planes set up per triangle, beside that of depth"},
            [](auto& f) -> auto& { return f.declared.interpolants; }),
        fact(
            {"values_per_vertex", "", "numbers computed at a vertex to be interpolated"},
            [](auto& f) -> auto& { return f.declared.values_per_vertex; }),
        fact(
            {"shares_vertices", "", "false: every triangle has three of its own"},
            [](auto& f) -> auto& { return f.declared.shares_vertices; }),
        fact(
            {"fill_bytes_read", "B/px", "per covered pixel of a triangle, hidden ones too"},
            [](auto& f) -> auto& { return f.declared.fill.bytes_read; }),
        fact(
            {"fill_bytes_written", "B/px", "the same"},
            [](auto& f) -> auto& { return f.declared.fill.bytes_written; }),
        fact(
            {"fill_operations", "1/px", "on one number each, per covered pixel"},
            [](auto& f) -> auto& { return f.declared.fill.operations; }),
        fact(
            {"filter_bytes_read", "B/px", "per pixel of the frame, empty ones too"},
            [](auto& f) -> auto& { return f.declared.filter.bytes_read; }),
        fact(
            {"filter_bytes_written", "B/px", "the same"},
            [](auto& f) -> auto& { return f.declared.filter.bytes_written; }),
        fact(
            {"filter_operations", "1/px", "on one number each, per pixel of the frame"},
            [](auto& f) -> auto& { return f.declared.filter.operations; }),
        fact(
            {"buffer_bytes_per_px", "B/px", "cleared once a frame, depth included"},
            [](auto& f) -> auto& { return f.declared.buffer_bytes_per_px; }),
        fact(
            {"frame_vertices", "", "of the meshes, counted once per instance"},
            [](auto& f) -> auto& { return f.frame.vertices; }),
        fact(
            {"frame_triangles", "", "over all instances, those outside the image too"},
            [](auto& f) -> auto& { return f.frame.triangles; }),
        fact(
            {"frame_covered_px", "px", "area in the image summed over all triangles"},
            [](auto& f) -> auto& { return f.frame.covered_px; }),
        fact(
            {"frame_px", "px", "width times height"},
            [](auto& f) -> auto& { return f.frame.frame_px; }),
    };
    RowTable predictions("", "");
    predictions.add(
        {"predicted_ns",
         "ns",
         "draw_ns_min by the cost model, fitted without this scene (or view)",
         true},
        [](auto& r) -> auto& { return r.row.predicted_ns; });
    predictions.add(
        {"cost_residual", "", "draw_ns_min over that, less 1", true},
        [](auto& r) -> auto& { return r.row.cost_residual; });
    fields.push_back(predictions.field("predicted_ns"));
    fields.push_back(predictions.field("cost_residual"));
    return fields;
}

const RowTable& table() {
    static const RowTable kTable = [] {
        RowTable table(
            "cost.csv",
            "A line per cell of a method: what it declares of its work and what the view "
            "asks of it, and the time that the cost model predicts from that.");
        table.add(
            {"cell", "", "of rows.csv"}, [](auto& r) -> auto& { return r.cell; });
        for (const RowTable::Field& field : cost_fields())
            table.add(field);
        return table;
    }();
    return kTable;
}

}  // namespace

const std::vector<RowTable::Field>& cost_fields() {
    static const std::vector<RowTable::Field> kFields = make_fields();
    return kFields;
}

const TableInfo& cost_table() {
    return table().info();
}

std::string cost_line(std::int64_t cell, const Row& row) {
    return row.cost ? table().line({cell, Study::compare, row}) : "";
}

void join_costs(const CsvTable& csv, std::vector<RowRecord>& rows) {
    std::map<std::int64_t, Row*> cells;
    for (RowRecord& row : rows)
        cells.emplace(row.cell, &row.row);
    const std::vector<RowRecord> read = table().read(csv);
    for (std::size_t i = 0; i < read.size(); ++i) {
        const auto found = cells.find(read[i].cell);
        if (found == cells.end()) CsvField(csv, i, 0).refuse("the number of a cell of rows.csv");
        Row& row = *found->second;
        if (row.cost) CsvField(csv, i, 0).refuse("every cell once");
        row.cost = read[i].row.cost;
        row.predicted_ns = read[i].row.predicted_ns;
        row.cost_residual = read[i].row.cost_residual;
    }
}

}  // namespace ink::harness
