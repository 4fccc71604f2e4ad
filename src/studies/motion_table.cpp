#include "studies/motion_table.h"

#include <fmt/format.h>

#include <numeric>

namespace ink::studies {
namespace {

std::int64_t total(const std::vector<std::int64_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

/// Counts that a cell has if it did not fail.
void add_flicker(const core::PartOf<harness::OfCell<MotionRow>>& counts) {
    using F = score::Flicker;
    const auto flicker = counts.part(&MotionRow::flicker);
    flicker.add_derived(
        {"flicker", "0..1", "share of the counted pixels that appeared or disappeared"}, &F::share);
    flicker.add({"appeared_px", "px", "drawn pixels with none in reach a frame before"},
                &F::appeared);
    flicker.add({"disappeared_px", "px", "drawn pixels with none in reach a frame later"},
                &F::disappeared);
    flicker.add({"excused_px", "px", "such pixels where the truth itself appeared or disappeared"},
                &F::excused);
    flicker.add({"counted_px", "px", "drawn pixels of both frames of each step"}, &F::n_counted);
}

void add_pops(const core::PartOf<harness::OfCell<MotionRow>>& counts) {
    using P = score::PopCount;
    const auto pops = counts.part(&MotionRow::pops);
    pops.add({"pops", "", "features shown, then dropped, then shown again"}, &P::pops);
    pops.add({"feature_runs", "", "runs of frames in which one feature is there"}, &P::runs);
    pops.add({"feature_steps", "", "steps from frame to frame in these runs"}, &P::steps);
}

void add_false_lines(const core::PartOf<harness::OfCell<MotionRow>>& counts) {
    counts.add_derived({"false_lines", "", "lines drawn where none is"},
                       [](const MotionRow& m) { return total(m.lives); });
    counts.add({"false_lines_cut", "", "of them, in the first or last frame: they may live longer"},
               &MotionRow::lives_cut);
}

}  // namespace

const harness::SideTable<MotionRow>& motion_table() {
    static const auto kTable = [] {
        harness::SideTable<MotionRow> table(
            "motion.csv",
            "A line per cell of study `motion`: how a method's lines behave on one "
            "sequence, within 2 px; the cell's view is the camera's path.");
        table.add({"frames", "", "of the sequence"}, &MotionRow::frames);
        table.add({"frames_per_s", "1/s", "at which it is shown"}, &MotionRow::frames_per_s);
        table.add({"step_px", "px", "by which the image moves a frame"}, &MotionRow::step_px);
        const auto counts = table.part_if(&MotionRow::is_ok);
        add_flicker(counts);
        add_pops(counts);
        add_false_lines(counts);
        return table;
    }();
    return kTable;
}

const harness::SideTable<MotionRow>& ink_motion_table() {
    static const auto kTable = [] {
        harness::SideTable<MotionRow> table(
            "ink_motion.csv",
            "A line per cell of motion.csv, with --coverage: how the drawn share I and the true "
            "share C of pixels change from frame to frame, where they count in both.");
        using I = score::InkChange;
        const auto ink = table.part(&MotionRow::ink);
        ink.add({"ink_true_change_px", "px^2", "sum |change of C|"}, &I::true_px);
        ink.add({"ink_beyond_px", "px^2", "sum |change of I - change of C|"}, &I::beyond_px);
        return table;
    }();
    return kTable;
}

const harness::SideTable<Life>& lives_table() {
    static const auto kTable = [] {
        harness::SideTable<Life> table(
            "lives.csv",
            "A line per cell of motion.csv and length of life that a false line of it had.");
        table.add({"frames", "frames", "that such a line lived"}, &Life::frames);
        table.add({"count", "", "of such lines"}, &Life::count);
        return table;
    }();
    return kTable;
}

std::string life_lines(std::int64_t cell, const MotionRow& of) {
    std::string lines;
    for (std::size_t i = 0; i < of.lives.size(); ++i) {
        if (of.lives[i] != 0)
            lines += lives_table().line(cell, {static_cast<int>(i + 1), of.lives[i]});
    }
    return lines;
}

std::vector<std::string> motion_faults(const std::vector<MotionRow>& rows) {
    std::vector<std::string> faults;
    for (const MotionRow& row : rows) {
        if (row.method != "oracle" || !row.is_ok()) continue;
        const bool is_perfect = row.flicker.appeared + row.flicker.disappeared == 0 &&
                                row.pops.pops == 0 && row.lives.empty();
        if (is_perfect) continue;
        faults.push_back(
            fmt::format("the truth itself has {} px of flicker, {} pops and {} false lines on {}, "
                        "path {}",
                        row.flicker.appeared + row.flicker.disappeared,
                        row.pops.pops,
                        total(row.lives),
                        row.scene,
                        row.view));
    }
    return faults;
}

}  // namespace ink::studies
