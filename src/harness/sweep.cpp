#include "harness/sweep.h"

#include <algorithm>
#include <set>

#include "core/hash.h"
#include "core/parallel.h"

namespace ink::harness {

std::vector<MethodConfig> sweep_configs(const MethodConfig& config) {
    if (config.info->sweep.empty()) return {config};
    std::vector<MethodConfig> configs;
    std::set<core::ParamValues> known;
    for (const core::ParamValues& setting : config.info->sweep) {
        MethodConfig swept = config;
        for (const auto& [name, value] : setting)
            swept.settings[name] = value;
        if (known.insert(swept.info->complete(swept.settings)).second) configs.push_back(swept);
    }
    return configs;
}

std::vector<Row> sweep_rows(const MethodConfig& config,
                            const scene::Scene& scene,
                            const scene::View& view,
                            const ViewTruth& truth,
                            const MeasureOptions& measure) {
    std::vector<std::unique_ptr<PreparedMethod>> methods;
    for (const MethodConfig& swept : sweep_configs(config))
        methods.push_back(std::make_unique<PreparedMethod>(swept, scene));
    std::vector<edge::EdgeImage> images;
    std::vector<DrawTimes> times = draw_in_turns(methods, view, measure, images);
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
        fill_score_2px(score::score(images[i], truth.scoring, options), row);
        row.image_hash = core::image_hash(images[i]);
    });
    return rows;
}

}  // namespace ink::harness
