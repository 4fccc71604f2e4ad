#include "studies/skips_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "harness/skip_switches.h"
#include "harness/tables/table_of.h"

namespace ink::studies {
namespace {

constexpr std::array<std::string_view, 3> kArms = {"on", "one_off", "all_off"};

struct Record {
    std::int64_t cell = 0;
    SkipTime time;
};

/// The skip of that name; nothing for another.
std::optional<raster::Skip> find_skip(const std::string& word) {
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        if (info.name == word) return info.skip;
    }
    return std::nullopt;
}

std::string all_skips() {
    std::string names;
    for (const raster::SkipInfo& info : raster::skip_infos())
        names += fmt::format("{}{}", names.empty() ? "" : ", ", info.name);
    return names;
}

void add_skip(harness::TableOf<Record>& table) {
    table.add(
        {"skip", "", "the skip that the scene was made for; empty for the three views"},
        [](const Record& r) {
            if (!r.time.skip) return std::string();
            return std::string(raster::skip_infos()[static_cast<std::size_t>(*r.time.skip)].name);
        },
        [](const harness::CsvField& field, Record& r) {
            if (field.is_empty()) return;
            r.time.skip = find_skip(field.text());
            if (!r.time.skip) field.refuse(all_skips());
        });
}

const harness::TableOf<Record>& table() {
    static const harness::TableOf<Record> kTable = [] {
        harness::TableOf<Record> table(
            "skips.csv",
            "A line per cell of study `skips`: which skip its scene was made for, "
            "and what was allowed; times and counts are in the row.");
        table.add(
            {"cell", "", "of rows.csv"}, [](auto& r) -> auto& { return r.cell; });
        add_skip(table);
        const std::string all = fmt::format("{}", fmt::join(kArms, ", "));
        table.add(
            {"arm", "", "on: every skip; one_off: all but the scene's; all_off: none"},
            [](const Record& r) {
                return std::string(kArms[static_cast<std::size_t>(r.time.arm)]);
            },
            [all](const harness::CsvField& field, Record& r) {
                const auto at = std::find(kArms.begin(), kArms.end(), field.text());
                if (at == kArms.end()) field.refuse(all);
                r.time.arm = static_cast<SkipArm>(at - kArms.begin());
            });
        return table;
    }();
    return kTable;
}

/// What "a;b" leaves of all skips; names that are no skip's are passed over.
raster::SkipSet all_but(const std::string& skips_off) {
    raster::SkipSet allowed;
    std::istringstream stream(skips_off);
    for (std::string word; std::getline(stream, word, ';');) {
        if (const auto skip = find_skip(word)) allowed.set(*skip, false);
    }
    return allowed;
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
    return table().line({cell, time});
}

std::vector<SkipTime> read_skips(const harness::CsvTable& csv, const harness::RowIndex& rows) {
    std::vector<SkipTime> times;
    for (const Record& record : table().read(csv)) {
        const harness::Row& row = rows.find(harness::CsvField(csv, times.size(), 0)).row;
        SkipTime time = record.time;
        time.scene = row.scene;
        time.method = row.method;
        time.params = row.params;
        time.allowed = all_but(row.skips_off);
        time.triangles = row.triangles;
        time.draw_ns = row.draw_ns;
        time.draw_ns_min = row.draw_ns_min;
        time.draw_n = row.draw_n;
        time.counts = row.skips.value_or(raster::SkipCounts{});
        time.image_hash = row.image_hash;
        time.status = row.status;
        times.push_back(std::move(time));
    }
    return times;
}

}  // namespace ink::studies
