#include "statistics/ods.h"

#include <algorithm>

#include "edge/thin.h"

namespace ink::statistics {

int best_threshold(const std::array<score::CurveCount, 99>& counts) {
    const auto best = std::ranges::max_element(counts, {}, &score::CurveCount::f);
    const auto other =
        std::find_if(best, counts.end(), [&](const auto& c) { return c.f() != best->f(); });
    const auto middle = (best - counts.begin() + (other - 1 - counts.begin())) / 2;
    return edge::response_at_percent(static_cast<int>(middle) + 1);
}

std::map<std::string, double> pooled_ap(const std::vector<CellCurve>& curves) {
    std::map<std::string, std::array<score::CurveCount, 99>> pools;
    for (const CellCurve& curve : curves) {
        auto& pool = pools[curve.method];
        for (std::size_t i = 0; i < pool.size(); ++i)
            pool[i] += curve.counts[i];
    }
    std::map<std::string, double> areas;
    for (const auto& [method, pool] : pools)
        areas[method] = score::average_precision(pool);
    return areas;
}

}  // namespace ink::statistics
