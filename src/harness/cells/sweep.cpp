#include "harness/cells/sweep.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace ink::harness {

MeasureOptions sweep_measure(MeasureOptions measure, std::size_t scenes) {
    constexpr std::size_t kManyScenes = 12;
    constexpr double kLongFrames_s = 0.003;
    measure.min_repetitions = 1;
    measure.max_repetitions = std::min(measure.max_repetitions, scenes < kManyScenes ? 2 : 1);
    measure.budget_s = std::min(measure.budget_s, kLongFrames_s);
    return measure;
}

std::vector<method::MethodConfig> sweep_configs(const method::MethodConfig& config) {
    if (config.info->sweep.empty()) return {config};
    std::vector<method::MethodConfig> configs;
    std::set<core::ParamValues> known;
    for (const core::ParamValues& setting : config.info->sweep) {
        const method::MethodConfig swept = with(config, setting);
        if (known.insert(swept.info->complete(swept.settings)).second) configs.push_back(swept);
    }
    return configs;
}

SharedDrawings::SharedDrawings(std::span<const method::MethodConfig> settings)
    : settings_(settings) {
    std::map<core::ParamValues, std::size_t> known;
    for (const method::MethodConfig& setting : settings) {
        const auto [found, is_new] = known.try_emplace(drawn_settings(setting), drawn_.size());
        if (is_new) drawn_.push_back(setting);
        drawing_of_.push_back(found->second);
    }
}

std::vector<Evaluation> SharedDrawings::shared(std::vector<Evaluation> drawn) const {
    std::vector<Evaluation> all(settings_.size());
    std::vector<const Evaluation*> taken(drawn.size(), nullptr);
    for (std::size_t i = 0; i < all.size(); ++i) {
        Evaluation& evaluation = all[i];
        const Evaluation*& first = taken[drawing_of_[i]];
        evaluation = first != nullptr ? *first : std::move(drawn[drawing_of_[i]]);
        if (first == nullptr) first = &evaluation;
        evaluation.threshold = threshold_of(settings_[i]);
        evaluation.row.threshold = evaluation.threshold;
        evaluation.row.params = join_params(settings_[i].info->complete(settings_[i].settings));
    }
    return all;
}

}  // namespace ink::harness
