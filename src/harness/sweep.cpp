#include "harness/sweep.h"

#include <set>

namespace ink::harness {

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

}  // namespace ink::harness
