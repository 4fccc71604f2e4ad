#include "studies/motion_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "harness/csv.h"

namespace ink::studies {
namespace {

constexpr std::string_view kColumns =
    "scene,path,method,params,status,width,height,threads,frames,frames_per_s,step_px,flicker,"
    "appeared_px,disappeared_px,excused_px,counted_px,pops_per_s,pops,feature_runs,feature_steps,"
    "false_lines,false_lines_cut,median_life_frames,lives,images_hash";

std::string or_nothing(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "";
}

void add(const std::vector<std::int64_t>& lives, std::vector<std::int64_t>& sum) {
    if (sum.size() < lives.size()) sum.resize(lives.size());
    for (std::size_t i = 0; i < lives.size(); ++i)
        sum[i] += lives[i];
}

std::int64_t total(const std::vector<std::int64_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

std::string scores_csv(const MotionRow& row) {
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}",
                       or_nothing(row.flicker.share()),
                       row.flicker.appeared,
                       row.flicker.disappeared,
                       row.flicker.excused,
                       row.flicker.n_counted,
                       or_nothing(row.pops.per_second(row.frames_per_s)),
                       row.pops.pops,
                       row.pops.runs,
                       row.pops.steps,
                       total(row.lives),
                       row.lives_cut,
                       or_nothing(score::median_life(row.lives)),
                       fmt::join(row.lives, ";"),
                       row.images_hash);
}

}  // namespace

std::int64_t MotionTotal::false_lines() const {
    return total(lives);
}

std::vector<MotionTotal> motion_totals(const std::vector<MotionRow>& rows) {
    std::vector<MotionTotal> totals;
    for (const MotionRow& row : rows) {
        auto at = std::find_if(totals.begin(), totals.end(), [&](const MotionTotal& t) {
            return t.method == row.method;
        });
        if (at == totals.end()) {
            totals.push_back({.method = row.method});
            at = totals.end() - 1;
        }
        if (!row.is_ok()) {
            ++at->failed;
            continue;
        }
        ++at->sequences;
        at->frames += row.frames;
        at->frames_per_s = row.frames_per_s;
        at->flicker += row.flicker;
        at->pops += row.pops;
        add(row.lives, at->lives);
    }
    return totals;
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
                        row.path));
    }
    return faults;
}

std::string motion_csv(const std::vector<MotionRow>& rows) {
    std::string text = fmt::format("{}\n", kColumns);
    for (const MotionRow& row : rows) {
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},",
                            harness::csv_field(row.scene),
                            row.path,
                            harness::csv_field(row.method),
                            harness::csv_field(row.params),
                            harness::csv_field(row.status),
                            row.width_px,
                            row.height_px,
                            row.threads,
                            row.frames,
                            row.frames_per_s,
                            row.step_px);
        // A cell that failed has no scores; commas keep its columns.
        text += row.is_ok() ? scores_csv(row) : std::string(13, ',');
        text += '\n';
    }
    return text;
}

}  // namespace ink::studies
