#include "studies/scaling_table.h"

#include <fmt/format.h>

#include "harness/tables/table_of.h"

namespace ink::studies {
namespace {

struct Record {
    std::int64_t cell = 0;
    ScalingPoint point;
};

std::string axis_name(ScalingAxis axis) {
    return std::string(scaling_axes()[static_cast<std::size_t>(axis)].name);
}

const harness::TableOf<Record>& table() {
    static const harness::TableOf<Record> kTable = [] {
        harness::TableOf<Record> table(
            "scaling.csv",
            "A line per cell of study `scaling`: where it lies on the axis along "
            "which work grows; draw_ns_min of the row is its time.");
        std::vector<std::string> names;
        for (const ScalingAxisInfo& info : scaling_axes())
            names.emplace_back(info.name);
        const std::string all = fmt::format("{}", fmt::join(names, ", "));
        table.add(
            {"cell", "", "of rows.csv"}, [](auto& r) -> auto& { return r.cell; });
        table.add(
            {"axis", "", "what grows: " + all},
            [](const Record& r) { return axis_name(r.point.axis); },
            [all](const harness::CsvField& field, Record& r) {
                for (const ScalingAxisInfo& info : scaling_axes()) {
                    if (info.name != field.text()) continue;
                    r.point.axis = info.axis;
                    return;
                }
                field.refuse(all);
            });
        table.add(
            {"x", "of axis", "triangles, pixels, or the share of the image covered"},
            [](auto& r) -> auto& { return r.point.x; });
        table.add(
            {"covered_share", "0..1", "of the image, by the sphere"},
            [](auto& r) -> auto& { return r.point.covered_share; });
        table.add(
            {"noise", "0..1", "how far off draw_ns_min may be, as a share of it", true},
            [](const Record& r) {
                return r.point.draw_n > 0 ? harness::csv_text(r.point.noise) : "";
            },
            [](const harness::CsvField& field, Record& r) {
                if (!field.is_empty()) field.read(r.point.noise);
            });
        return table;
    }();
    return kTable;
}

}  // namespace

harness::Row scaling_row(const ScalingPoint& point) {
    harness::Row row;
    row.method = point.method;
    row.scene = "scaling_sphere";
    row.view = fmt::format("{}={}", axis_name(point.axis), point.x);
    row.width = point.width_px;
    row.height = point.height_px;
    row.threads = point.threads;
    row.params = point.params;
    row.status = point.status;
    row.triangles = point.triangles;
    if (point.draw_n > 0) row.draw_ns_min = point.draw_ns_min;
    row.draw_n = point.draw_n;
    return row;
}

void clear_times(ScalingPoint& point) {
    point.draw_ns_min = 0;
    point.draw_n = 0;
    point.noise = kTimeNoise;
}

const harness::TableInfo& scaling_table() {
    return table().info();
}

std::string scaling_line(std::int64_t cell, const ScalingPoint& point) {
    return table().line({cell, point});
}

std::vector<ScalingPoint> read_scaling(const harness::CsvTable& csv,
                                       const harness::RowIndex& rows) {
    std::vector<ScalingPoint> points;
    for (const Record& record : table().read(csv)) {
        const harness::Row& row = rows.find(harness::CsvField(csv, points.size(), 0)).row;
        ScalingPoint point = record.point;
        point.method = row.method;
        point.params = row.params;
        point.width_px = row.width;
        point.height_px = row.height;
        point.triangles = row.triangles;
        point.threads = row.threads;
        point.draw_ns_min = row.draw_ns_min.value_or(0);
        point.draw_n = row.draw_n;
        point.status = row.status;
        points.push_back(std::move(point));
    }
    return points;
}

}  // namespace ink::studies
