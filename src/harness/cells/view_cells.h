#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/cells/cell.h"
#include "harness/cells/frame_counts.h"
#include "harness/scores/evaluations.h"
#include "harness/scores/miss_prediction.h"
#include "harness/truths/compare_truths.h"
#include "harness/truths/tracing.h"
#include "scene/scene.h"

namespace ink::harness {

/// What is scored of a drawn cell.
enum class Scores {
    full,      ///< everything, with baselines
    brief,     ///< at 2 px and its threshold only: no curve, tolerance sweep, 1 px, causes or bins
    settings,  ///< the same without baselines
    none,      ///< nothing: rows have their place and the hash of their image
};

/// What all cells of a run have in common.
struct CellOptions {
    MeasureOptions measure = {};
    TraceOptions trace = {};
    std::uint64_t seed = 0;  ///< of random images
    /// Views too crowded to score (harness/truths/unscored_view.h) have a score, as long as there
    /// is a true pixel that counts. In brief scores only.
    bool scores_crowded = false;
    Scores scores = Scores::full;
    /// Grey lines are scored too, against true lines of this width; not where `scores` is settings
    /// or none.
    std::optional<double> line_width_px = {};
};

/// What is drawn of a view: every method, as many in turns as are ready together.
struct ViewDrawings {
    const scene::View& view;
    std::size_t methods = 0;
    std::size_t at_once = 1;  ///< methods that are ready together
    int lanes = 1;            ///< how many such parts are drawn at a time
    /// The methods from the `first` on to `end`, ready.
    std::function<std::shared_ptr<PreparedMethods>(std::size_t first, std::size_t end)> ready = {};
    /// Sees what the n-th method drew while it is there.
    std::function<void(std::size_t n, PreparedMethod& method, const Evaluation& drawn)> see = {};
};

/// Draws and times all, unscored.
[[nodiscard]] std::vector<Evaluation> draw_view(const ViewDrawings& drawings,
                                                const MeasureOptions& measure);

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

/// Scores drawn evaluations of a view as `options.scores` says, and adds its baselines: rows come
/// out complete. Without a truth every row, the baselines' too, says why. Equal images at equal
/// thresholds are scored once where scores are brief.
void finish_evaluations(const scene::Scene& scene,
                        const scene::View& view,
                        const TracedView& traced,
                        const CellOptions& options,
                        std::vector<Evaluation>& evaluations);

}  // namespace ink::harness
