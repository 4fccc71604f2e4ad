#pragma once

#include <vector>

#include "harness/cell.h"
#include "harness/method_configs.h"
#include "harness/row.h"
#include "harness/tracing.h"

namespace ink::harness {

/// How the settings of a method's sweep are drawn and timed beside the methods themselves.
struct SweepOptions {
    /// A front needs times to a few percent, and takes medians over views: few repetitions do, and
    /// one where a frame is long.
    MeasureOptions measure{.min_repetitions = 1, .max_repetitions = 3, .budget_s = 0.02};
};

/// The settings over which `config` is swept, each as a configuration: what the user set, with a
/// line of MethodInfo::sweep on top. Settings that come out equal appear once. A method without a
/// sweep is the configuration alone, so that fronts have it.
[[nodiscard]] std::vector<MethodConfig> sweep_configs(const MethodConfig& config);

/// Draws `view` with every setting of the sweep of `config` in turns, and scores each at 2 px and
/// its own threshold: a row per setting that still lacks its place (scene, view ...).
///
/// Settings take turns with each other and not with other methods: all settings of all methods
/// prepared at once would not fit into memory on large models. The default setting is drawn again
/// here, so that times of one sweep compare. Curve, tolerance sweep and 1 px are left out.
[[nodiscard]] std::vector<Row> sweep_rows(const MethodConfig& config,
                                          const scene::Scene& scene,
                                          const scene::View& view,
                                          const ViewTruth& truth,
                                          const MeasureOptions& measure);

}  // namespace ink::harness
