#include "studies/motion_rows.h"

#include <fmt/format.h>

#include <numeric>

namespace ink::studies {
namespace {

std::int64_t total(const std::vector<std::int64_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

}  // namespace

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
