#include "studies/scaling_table.h"

#include <fmt/format.h>

#include "harness/tables/side_table.h"

namespace ink::studies {
namespace {

std::string axis_name(ScalingAxis axis) {
    return std::string(scaling_axes()[static_cast<std::size_t>(axis)].name);
}

const harness::SideTable<ScalingPoint>& table() {
    static const auto kTable = [] {
        using P = ScalingPoint;
        harness::SideTable<P> table(
            "scaling.csv",
            "A line per cell of study `scaling`: where it lies on the axis along "
            "which work grows; draw_ns_min of the row is its time.");
        std::vector<std::string> names;
        for (const ScalingAxisInfo& info : scaling_axes())
            names.emplace_back(info.name);
        table.add_named(
            {"axis", "", fmt::format("what grows: {}", fmt::join(names, ", "))}, &P::axis, names);
        table.add({"x", "of axis", "triangles, pixels, or the share of the image covered"}, &P::x);
        table.add({"covered_share", "0..1", "of the image, by the sphere"}, &P::covered_share);
        table.part_if([](const P& point) { return point.draw_n > 0; })
            .add({"noise", "0..1", "how far off draw_ns_min may be, as a share of it", true},
                 &P::noise);
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
    return table().line(cell, point);
}

}  // namespace ink::studies
