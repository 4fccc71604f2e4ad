#include "studies/motion_table.h"

#include <numeric>

#include "harness/tables/table_of.h"

namespace ink::studies {
namespace {

struct Record {
    std::int64_t cell = 0;
    MotionRow row;
};
using MotionTable = harness::TableOf<Record>;

/// A count that a cell has if it did not fail.
template <class Place>
void add_count(MotionTable& table, harness::Column column, Place place) {
    table.add(
        std::move(column),
        [place](const Record& r) { return r.row.is_ok() ? harness::csv_text(place(r.row)) : ""; },
        [place](const harness::CsvField& field, Record& r) {
            if (!field.is_empty()) field.read(place(r.row));
        });
}

/// What follows from counts.
template <class Value>
void add_share(MotionTable& table, harness::Column column, Value value_of) {
    table.add(
        std::move(column),
        [value_of](const Record& r) {
            return r.row.is_ok() ? harness::csv_text(value_of(r.row)) : "";
        },
        [](const harness::CsvField&, Record&) {});
}

void add_flicker(MotionTable& table) {
    add_share(table,
              {"flicker", "0..1", "share of the counted pixels that appeared or disappeared"},
              [](const MotionRow& m) { return m.flicker.share(); });
    add_count(
        table, {"appeared_px", "px", "drawn pixels with none in reach a frame before"}, [
        ](auto& m) -> auto& { return m.flicker.appeared; });
    add_count(
        table, {"disappeared_px", "px", "drawn pixels with none in reach a frame later"}, [
        ](auto& m) -> auto& { return m.flicker.disappeared; });
    add_count(
        table, {"excused_px", "px", "such pixels where the truth itself appeared or disappeared"}, [
        ](auto& m) -> auto& { return m.flicker.excused; });
    add_count(
        table, {"counted_px", "px", "drawn pixels of both frames of each step"}, [
        ](auto& m) -> auto& { return m.flicker.n_counted; });
}

void add_pops(MotionTable& table) {
    add_share(table,
              {"pops_per_s", "1/s", "pops per persistent feature and second"},
              [](const MotionRow& m) { return m.pops.per_second(m.frames_per_s); });
    add_count(
        table, {"pops", "", "features shown, then dropped, then shown again"}, [
        ](auto& m) -> auto& { return m.pops.pops; });
    add_count(
        table, {"feature_runs", "", "runs of frames in which one feature is there"}, [
        ](auto& m) -> auto& { return m.pops.runs; });
    add_count(
        table, {"feature_steps", "", "steps from frame to frame in these runs"}, [
        ](auto& m) -> auto& { return m.pops.steps; });
}

void add_false_lines(MotionTable& table) {
    add_share(table, {"false_lines", "", "lines drawn where none is"}, [](const MotionRow& m) {
        return std::accumulate(m.lives.begin(), m.lives.end(), std::int64_t{0});
    });
    add_count(
        table,
        {"false_lines_cut", "", "of them, in the first or last frame: they may live longer"},
        [](auto& m) -> auto& { return m.lives_cut; });
    add_share(table,
              {"median_life_frames", "frames", "median life of these; lives.csv has all"},
              [](const MotionRow& m) { return score::median_life(m.lives); });
}

const MotionTable& motion() {
    static const MotionTable kTable = [] {
        MotionTable table("motion.csv",
                          "A line per cell of study `motion`: how a method's lines behave on one "
                          "sequence, within 2 px; the cell's view is the camera's path.");
        table.add(
            {"cell", "", "of rows.csv"}, [](auto& r) -> auto& { return r.cell; });
        table.add(
            {"frames", "", "of the sequence"}, [](auto& r) -> auto& { return r.row.frames; });
        table.add(
            {"frames_per_s", "1/s", "at which it is shown"},
            [](auto& r) -> auto& { return r.row.frames_per_s; });
        table.add(
            {"step_px", "px", "by which the image moves a frame"},
            [](auto& r) -> auto& { return r.row.step_px; });
        add_flicker(table);
        add_pops(table);
        add_false_lines(table);
        return table;
    }();
    return kTable;
}

/// How many false lines of a cell lived so long.
struct Life {
    std::int64_t cell = 0;
    int frames = 0;
    std::int64_t count = 0;
};

const harness::TableOf<Life>& lives() {
    static const harness::TableOf<Life> kTable = [] {
        harness::TableOf<Life> table(
            "lives.csv",
            "A line per cell of motion.csv and length of life that a false line of "
            "it had.");
        table.add(
            {"cell", "", "of rows.csv"}, [](auto& r) -> auto& { return r.cell; });
        table.add(
            {"frames", "frames", "that such a line lived"},
            [](auto& r) -> auto& { return r.frames; });
        table.add(
            {"count", "", "of such lines"}, [](auto& r) -> auto& { return r.count; });
        return table;
    }();
    return kTable;
}

MotionRow motion_of(const harness::Row& row) {
    MotionRow of;
    of.scene = row.scene;
    of.path = row.view;
    of.method = row.method;
    of.params = row.params;
    of.status = row.status;
    of.width_px = row.width;
    of.height_px = row.height;
    of.threads = row.threads;
    of.images_hash = row.image_hash;
    of.split = row.split;
    of.triangles = row.triangles;
    return of;
}

}  // namespace

harness::Row motion_row(const MotionRow& of) {
    harness::Row row;
    row.method = of.method;
    row.scene = of.scene;
    row.view = of.path;
    row.split = of.split;
    row.width = of.width_px;
    row.height = of.height_px;
    row.threads = of.threads;
    row.params = of.params;
    row.status = of.status;
    row.image_hash = of.images_hash;
    row.triangles = of.triangles;
    return row;
}

const harness::TableInfo& motion_table() {
    return motion().info();
}

std::string motion_line(std::int64_t cell, const MotionRow& of) {
    return motion().line({cell, of});
}

const harness::TableInfo& lives_table() {
    return lives().info();
}

std::string life_lines(std::int64_t cell, const MotionRow& of) {
    std::string lines;
    for (std::size_t i = 0; i < of.lives.size(); ++i) {
        if (of.lives[i] != 0) lines += lives().line({cell, static_cast<int>(i + 1), of.lives[i]});
    }
    return lines;
}

std::vector<MotionRow> read_motion(const harness::CsvTable& motion_csv,
                                   const harness::CsvTable& lives_csv,
                                   const harness::RowIndex& rows) {
    std::vector<Record> records = motion().read(motion_csv);
    std::map<std::int64_t, MotionRow*> cells;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const harness::RowRecord& of_cell = rows.find(harness::CsvField(motion_csv, i, 0));
        MotionRow row = motion_of(of_cell.row);
        const MotionRow& read = records[i].row;
        row.frames = read.frames;
        row.frames_per_s = read.frames_per_s;
        row.step_px = read.step_px;
        row.flicker = read.flicker;
        row.pops = read.pops;
        row.lives_cut = read.lives_cut;
        records[i].row = std::move(row);
        if (!cells.emplace(records[i].cell, &records[i].row).second)
            harness::CsvField(motion_csv, i, 0).refuse("every cell once");
    }
    const std::vector<Life> read = lives().read(lives_csv);
    for (std::size_t i = 0; i < read.size(); ++i) {
        const auto found = cells.find(read[i].cell);
        if (found == cells.end()) harness::CsvField(lives_csv, i, 0).refuse("a cell of motion.csv");
        std::vector<std::int64_t>& of = found->second->lives;
        if (read[i].frames <= static_cast<int>(of.size()))
            harness::CsvField(lives_csv, i, 1).refuse("lengths that grow within a cell, from 1");
        of.resize(static_cast<std::size_t>(read[i].frames));
        of.back() = read[i].count;
    }
    std::vector<MotionRow> all;
    for (Record& record : records)
        all.push_back(std::move(record.row));
    return all;
}

}  // namespace ink::studies
