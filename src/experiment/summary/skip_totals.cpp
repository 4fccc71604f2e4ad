#include "experiment/summary/skip_totals.h"

#include <algorithm>

namespace ink::experiment {

double share_of(const raster::SkipCount& count) {
    return count.of == 0 ? 0 : static_cast<double>(count.skipped) / static_cast<double>(count.of);
}

std::vector<SkipTotals> skip_totals(const std::vector<harness::Row>& rows) {
    std::vector<SkipTotals> totals;
    for (const harness::Row& row : rows) {
        if (!row.is_ok() || !row.skips) continue;
        auto at = std::find_if(totals.begin(), totals.end(), [&](const SkipTotals& t) {
            return t.method == row.method;
        });
        if (at == totals.end()) at = totals.insert(totals.end(), {row.method, {}});
        for (std::size_t i = 0; i < raster::kSkipCount; ++i) {
            const raster::SkipCount& count = (*row.skips)[i];
            SkipTotal& total = at->of_skip[i];
            total.count.skipped += count.skipped;
            total.count.of += count.of;
            if (count.of == 0) continue;
            if (total.most == nullptr || share_of(count) > share_of((*total.most->skips)[i])) {
                total.most = &row;
            }
        }
    }
    return totals;
}

}  // namespace ink::experiment
