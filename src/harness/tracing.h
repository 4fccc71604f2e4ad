#pragma once

#include <filesystem>
#include <string>

#include "harness/suite.h"
#include "score/score.h"
#include "truth/scene_model.h"
#include "truth/truth.h"

namespace ink::harness {

/// How every comparison is scored (section 7 of the design): pixels this close to the frame do not
/// count.
inline constexpr int kBand_px = 6;
inline constexpr double kTolerance_px = 2;
inline constexpr double kStrictTolerance_px = 1;

/// How a truth is traced, and where truths are kept (an empty path: nowhere).
struct TraceOptions {
    truth::TruthOptions truth;
    std::filesystem::path cache;
    bool crosscheck = true;  ///< compare: hold every truth against the cross-check
};

/// A view's truth, as traced and as scored against: without band and ignored pixels, thinned again,
/// so that it scores exactly 1 against itself.
struct ViewTruth {
    truth::Truth traced;
    score::ScoringTruth scoring;
    truth::Cracks cracks;
};

/// Lets a trace with these options say on stderr how far it is (see core::Progress).
void report_progress(truth::TruthOptions& options);

/// Traces `view`, or reads its truth from the folder `cache` (empty: none).
[[nodiscard]] ViewTruth trace_view(truth::SceneModel& scene,
                                   const scene::View& view,
                                   const std::filesystem::path& cache);

/// What a trace found, for a terminal: pixels and curves per class, counts, time.
[[nodiscard]] std::string truth_summary(const truth::Truth& truth);

}  // namespace ink::harness
