#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiment/experiment_plan.h"
#include "experiment/view_bench.h"
#include "harness/rows/sweep_table.h"

namespace ink::experiment {

/// Where a block's cells are.
struct BlockPlace {
    std::size_t scene = 0;
    const scene::View* view = nullptr;
    int threads = 1;
    std::int64_t first_cell = 0;  ///< the number of the first method's row
    bool is_first_view = false;   ///< of its scene: methods are made ready there
    bool keeps_images = false;
    /// Per method: its own settings are the first of its sweep here.
    std::vector<bool> sweeps_own = {};
};

/// Some settings of the n-th method.
struct SettingsPart {
    std::size_t method = 0;
    std::size_t first = 0;  ///< the number of the first setting, from 1
    std::vector<method::MethodConfig> settings;
};

/// The methods at their own settings, and the baselines: rows.csv and what stands beside it, and
/// the lines of sweep.csv that say the same. `swept` are its parameters' columns.
[[nodiscard]] BlockResult run_methods(ViewBench& bench,
                                      const BlockPlace& at,
                                      const harness::SweepColumns& swept = {});

/// Other settings of one method: lines of sweep.csv, without baselines.
[[nodiscard]] BlockResult run_settings(ViewBench& bench,
                                       const BlockPlace& at,
                                       const SettingsPart& part,
                                       const harness::SweepColumns& swept);

}  // namespace ink::experiment
