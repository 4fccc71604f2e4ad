#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/cell.h"
#include "harness/frame_counts.h"
#include "harness/miss_prediction.h"
#include "harness/shots.h"
#include "harness/tracing.h"
#include "harness/witness_cache.h"
#include "scene/scene.h"

namespace ink::harness {

/// What all cells of a run have in common.
struct CellOptions {
    MeasureOptions measure = {};
    TraceOptions trace = {};
    std::uint64_t seed = 0;  ///< of chance pictures
};

/// A view with all that its rows say whatever the method.
struct TracedView {
    ViewTruth truth;
    std::optional<harness::WitnessCheck> check;  ///< nothing if it was not asked for
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

/// Scores drawn shots of a view and adds its brackets: rows come out complete but for predicted_ns.
/// Without a truth every row, the brackets' too, says why.
void finish_shots(const scene::Scene& scene,
                  const scene::View& view,
                  const TracedView& traced,
                  const CellOptions& options,
                  std::vector<Shot>& shots);

/// The same, scored at 2 px and its threshold only: no curve, ladder, 1 px, causes or line scores.
void finish_briefly(const scene::Scene& scene,
                    const scene::View& view,
                    const TracedView& traced,
                    const CellOptions& options,
                    std::vector<Shot>& shots);

}  // namespace ink::harness
