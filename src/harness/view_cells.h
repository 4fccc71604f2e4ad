#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/cell.h"
#include "harness/crosscheck/crosscheck_cache.h"
#include "harness/evaluations.h"
#include "harness/frame_counts.h"
#include "harness/miss_prediction.h"
#include "harness/tracing.h"
#include "scene/scene.h"

namespace ink::harness {

/// What all cells of a run have in common.
struct CellOptions {
    MeasureOptions measure = {};
    TraceOptions trace = {};
    std::uint64_t seed = 0;  ///< of random images
    /// Views too crowded to score (harness/unscored_view.h) have a score, as long as there is a
    /// true pixel that counts. In brief scores only.
    bool scores_crowded = false;
};

/// A view with all that its rows say whatever the method.
struct TracedView {
    ViewTruth truth;
    std::optional<harness::Crosscheck> check;  ///< nothing if it was not asked for
    FrameCounts counts;
    std::string failure;  ///< why there is no truth, or ""

    [[nodiscard]] bool has_truth() const { return failure.empty(); }
};

/// Traces `view`, or reads its truth from the cache. A truth that is too large, or that memory does
/// not hold, is a failure; anything else throws.
[[nodiscard]] TracedView trace_with_facts(truth::SceneModel& model,
                                          const scene::Scene& scene,
                                          const scene::View& view,
                                          const TraceOptions& trace);

/// Writes where a row was made, and what its scene and its run are.
void fill_place(const scene::Scene& scene,
                const scene::View& view,
                const CellOptions& options,
                Row& row);

/// Scores drawn evaluations of a view and adds its baselines: rows come out complete. Without a
/// truth every row, the baselines' too, says why.
void finish_evaluations(const scene::Scene& scene,
                        const scene::View& view,
                        const TracedView& traced,
                        const CellOptions& options,
                        std::vector<Evaluation>& evaluations);

/// The same, scored at 2 px and its threshold only: no curve, tolerance sweep, 1 px, causes or line
/// scores.
void finish_briefly(const scene::Scene& scene,
                    const scene::View& view,
                    const TracedView& traced,
                    const CellOptions& options,
                    std::vector<Evaluation>& evaluations);

/// The same of images that are not scored: their place and their hash.
void finish_drawn(const scene::Scene& scene,
                  const scene::View& view,
                  const CellOptions& options,
                  std::vector<Evaluation>& evaluations);

/// The same as finish_briefly without baselines. Equal images at equal thresholds are scored once.
void finish_settings(const scene::Scene& scene,
                     const scene::View& view,
                     const TracedView& traced,
                     const CellOptions& options,
                     std::vector<Evaluation>& evaluations);

}  // namespace ink::harness
