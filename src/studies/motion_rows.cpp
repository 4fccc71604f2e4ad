#include "studies/motion_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace ink::studies {
namespace {

void add(const std::vector<std::int64_t>& lives, std::vector<std::int64_t>& sum) {
    if (sum.size() < lives.size()) sum.resize(lives.size());
    for (std::size_t i = 0; i < lives.size(); ++i)
        sum[i] += lives[i];
}

std::int64_t total(const std::vector<std::int64_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
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

}  // namespace ink::studies
