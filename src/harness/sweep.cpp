#include "harness/sweep.h"

#include <algorithm>
#include <set>

#include "core/hash.h"
#include "core/parallel.h"

namespace ink::harness {

std::vector<Entrant> sweep_entrants(const Entrant& entrant) {
    if (entrant.info->sweep.empty()) return {entrant};
    std::vector<Entrant> entrants;
    std::set<core::ParamValues> known;
    for (const core::ParamValues& setting : entrant.info->sweep) {
        Entrant swept = entrant;
        for (const auto& [name, value] : setting)
            swept.settings[name] = value;
        if (known.insert(swept.info->complete(swept.settings)).second) entrants.push_back(swept);
    }
    return entrants;
}

std::vector<Row> sweep_rows(const Entrant& entrant,
                            const scene::Scene& scene,
                            const scene::View& view,
                            const ViewTruth& truth,
                            const MeasureOptions& measure) {
    std::vector<std::unique_ptr<PreparedMethod>> methods;
    for (const Entrant& swept : sweep_entrants(entrant))
        methods.push_back(std::make_unique<PreparedMethod>(swept, scene));
    std::vector<edge::EdgeImage> pictures;
    std::vector<DrawTimes> times = draw_in_turns(methods, view, measure, pictures);
    std::vector<Row> rows(methods.size());
    // Scores are not timed, so they may use every core.
    core::parallel_for(methods.size(), core::hardware_threads(), [&](std::size_t i) {
        Row& row = rows[i];
        row = methods[i]->row();
        if (!times[i].failure.empty()) row.status = times[i].failure;
        fill_skips(times[i], measure.skips, row);
        if (!row.is_ok()) return;
        fill_times(std::move(times[i].draw_ns), row);
        const score::ScoreOptions options = score_options(methods[i]->threshold());
        fill_score_2px(score::score(pictures[i], truth.scoring, options), row);
        row.image_hash = core::image_hash(pictures[i]);
    });
    return rows;
}

}  // namespace ink::harness
