#include "lab/ods.h"

#include <algorithm>

namespace ink::lab {
namespace {

using Counts = std::array<score::CurveCount, 99>;

void pool(const Counts& from, Counts& into) {
    for (std::size_t i = 0; i < into.size(); ++i) {
        into[i].k += from[i].k;
        into[i].n_pred += from[i].n_pred;
        into[i].n_truth += from[i].n_truth;
    }
}

double f_of(const score::CurveCount& c) {
    const auto total = c.n_pred + c.n_truth;
    return total == 0 ? 1.0 : 2.0 * static_cast<double>(c.k) / static_cast<double>(total);
}

/// Entry i stands for strength * 100 >= 255 * (i + 1): the least strength that is on.
int strength_at(std::size_t i) {
    return static_cast<int>((255 * (i + 1) + 99) / 100);
}

OdsPoint best_point(const std::string& method, const Counts& pooled) {
    OdsPoint best{method, strength_at(0), f_of(pooled[0])};
    for (std::size_t i = 1; i < pooled.size(); ++i) {
        if (f_of(pooled[i]) > best.f) best = {method, strength_at(i), f_of(pooled[i])};
    }
    return best;
}

}  // namespace

std::vector<OdsPoint> ods_on_training(const std::vector<CellCurve>& curves) {
    std::vector<std::string> methods;
    std::vector<Counts> pooled;
    for (const CellCurve& curve : curves) {
        if (!curve.is_training) continue;
        auto found = std::find(methods.begin(), methods.end(), curve.method);
        if (found == methods.end()) {
            methods.push_back(curve.method);
            pooled.emplace_back();
            found = methods.end() - 1;
        }
        pool(curve.counts, pooled[static_cast<std::size_t>(found - methods.begin())]);
    }
    std::vector<OdsPoint> points;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        points.push_back(best_point(methods[i], pooled[i]));
    }
    return points;
}

}  // namespace ink::lab
