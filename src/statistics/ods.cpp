#include "statistics/ods.h"

#include <algorithm>

#include "edge/thin.h"

namespace ink::statistics {
namespace {

using Counts = std::array<score::CurveCount, 99>;

/// Index of the highest F; the first on a tie.
std::size_t best_index(const Counts& counts) {
    const auto best = std::max_element(
        counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.f() < b.f(); });
    return static_cast<std::size_t>(best - counts.begin());
}

/// The cells of one method, added up.
struct Pool {
    std::string method;
    Counts curve{};
    score::CurveCount best_of_each{};

    void add(const Counts& cell) {
        for (std::size_t i = 0; i < curve.size(); ++i)
            curve[i] += cell[i];
        best_of_each += cell[best_index(cell)];
    }
    [[nodiscard]] OdsPoint ods() const {
        const std::size_t best = best_index(curve);
        const double f = curve[best].f();
        std::size_t last = best;
        while (last + 1 < curve.size() && curve[last + 1].f() == f)
            ++last;
        const auto middle = static_cast<int>((best + last) / 2);
        return {method, edge::response_at_percent(middle + 1), f};
    }
};

template <class Keep>
std::vector<Pool> pools_of(const std::vector<CellCurve>& curves, Keep keep) {
    std::vector<Pool> pools;
    for (const CellCurve& curve : curves) {
        if (!keep(curve)) continue;
        auto pool = std::find_if(pools.begin(), pools.end(), [&](const Pool& known) {
            return known.method == curve.method;
        });
        if (pool == pools.end()) pool = pools.insert(pool, Pool{curve.method});
        pool->add(curve.counts);
    }
    return pools;
}

}  // namespace

std::vector<OdsPoint> ods_on_training(const std::vector<CellCurve>& curves) {
    std::vector<OdsPoint> points;
    for (const Pool& pool : pools_of(curves, [](const CellCurve& c) { return c.is_training; }))
        points.push_back(pool.ods());
    return points;
}

std::vector<CurveSummary> summarise_curves(const std::vector<CellCurve>& curves) {
    std::vector<CurveSummary> summaries;
    for (const Pool& pool : pools_of(curves, [](const CellCurve&) { return true; })) {
        summaries.push_back(
            {pool.ods(), pool.best_of_each.f(), score::average_precision(pool.curve)});
    }
    return summaries;
}

}  // namespace ink::statistics
