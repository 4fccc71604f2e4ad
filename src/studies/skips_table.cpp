#include "studies/skips_table.h"

#include <fmt/format.h>

#include <functional>

#include "harness/skip_switches.h"
#include "harness/tables/side_table.h"

namespace ink::studies {
namespace {

std::vector<std::string> skip_names() {
    std::vector<std::string> names;
    for (const raster::SkipInfo& info : raster::skip_infos())
        names.emplace_back(info.name);
    return names;
}

const harness::SideTable<SkipTime>& table() {
    static const auto kTable = [] {
        harness::SideTable<SkipTime> table(
            "skips.csv",
            "A line per cell of study `skips`: which skip its scene was made for, "
            "and what was allowed; times and counts are in the row.");
        table.part(&SkipTime::skip)
            .add_named(
                {"skip", "", "the skip that the scene was made for; empty for the three views"},
                std::identity(),
                skip_names());
        table.add_named({"arm", "", "on: every skip; one_off: all but the scene's; all_off: none"},
                        &SkipTime::arm,
                        {"on", "one_off", "all_off"});
        return table;
    }();
    return kTable;
}

}  // namespace

harness::Row skip_row(const SkipTime& time, const SkipStudyOptions& options) {
    harness::Row row;
    row.method = time.method;
    row.scene = time.scene;
    row.view = time.scene;
    row.width = options.width_px;
    row.height = options.height_px;
    row.threads = options.threads;
    row.params = time.params;
    row.status = time.status;
    row.draw_ns = time.draw_ns;
    row.draw_ns_min = time.draw_ns_min;
    row.draw_n = time.draw_n;
    row.image_hash = time.image_hash;
    row.triangles = time.triangles;
    row.skips = time.counts;
    row.skips_off = harness::forbidden_skips(time.allowed);
    return row;
}

const harness::TableInfo& skips_table() {
    return table().info();
}

std::string skip_line(std::int64_t cell, const SkipTime& time) {
    return table().line(cell, time);
}

}  // namespace ink::studies
