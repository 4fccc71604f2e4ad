#include "summary/row_pairs.h"

#include <map>
#include <utility>

#include "summary/summary.h"

namespace ink::summary {
namespace {

using Counts = score::CurveCount;

double pooled_f(const std::vector<Counts>& scenes) {
    Counts sum;
    for (const Counts& counts : scenes)
        sum += counts;
    return sum.f();
}

}  // namespace

double PairedScenes::f_a() const {
    return pooled_f(a);
}

double PairedScenes::f_b() const {
    return pooled_f(b);
}

PairedScenes paired_scenes(std::span<const RowPair> pairs) {
    std::map<std::string, std::pair<Counts, Counts>> by_scene;
    for (const RowPair& pair : pairs) {
        if (!pair.a->is_scored() || !pair.b->is_scored()) continue;
        auto& [a, b] = by_scene[pair.a->scene];
        a += counts_2px(*pair.a);
        b += counts_2px(*pair.b);
    }
    PairedScenes scenes;
    for (const auto& [scene, sums] : by_scene) {
        scenes.a.push_back(sums.first);
        scenes.b.push_back(sums.second);
        scenes.names.push_back(scene);
    }
    return scenes;
}

}  // namespace ink::summary
