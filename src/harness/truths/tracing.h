#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/suite/suite.h"
#include "score/drawing.h"
#include "score/intersections.h"
#include "score/pixel_list.h"
#include "score/score.h"
#include "truth/model.h"
#include "truth/truth.h"

namespace ink::harness {

/// How every comparison is scored (section 7 of the design): pixels this close to the frame do not
/// count.
inline constexpr int kBand_px = 6;
inline constexpr double kTolerance_px = 2;
inline constexpr double kStrictTolerance_px = 1;

/// How a truth is traced, where truths are kept (an empty path: nowhere), and what of it counts.
struct TraceOptions {
    truth::TruthOptions truth;
    std::filesystem::path cache;
    bool crosscheck = true;  ///< compare: hold every truth against the cross-check
    score::Intersections intersections = score::Intersections::above_crease;

    /// The crease angle in degrees, without the rounding of its way through radians.
    [[nodiscard]] double crease_deg() const;
};

/// A view's truth, as traced and as scored against: without band and ignored pixels, thinned again,
/// so that it scores exactly 1 against itself.
struct ViewTruth {
    truth::Truth traced;
    score::ScoringTruth scoring;  ///< with the intersections that count
    truth::Cracks cracks;         ///< of every line
    score::Intersections intersections = score::Intersections::above_crease;
    double crease_rad = 0;
    /// With the other choice of intersections; nothing where the two are the same.
    std::optional<score::ScoringTruth> other = std::nullopt;
    /// With crowded pixels counted; nothing where there are none.
    std::optional<score::ScoringTruth> with_crowded = std::nullopt;
    /// The intersections below the crease angle, of the truth in which all count.
    score::PixelList below_crease = {};

    /// The truth image that `scoring` is made from.
    [[nodiscard]] core::Image<std::uint8_t> counted_labels() const;
};

/// Lets a trace with these options say on stderr how far it is (see core::Progress).
void report_progress(truth::TruthOptions& options);

/// Traces `view`, or reads its truth from the cache. How it is traced, the scene's model says: of
/// `trace`, the cache and the intersections are read.
[[nodiscard]] ViewTruth trace_view(truth::SceneModel& scene,
                                   const scene::View& view,
                                   const TraceOptions& trace);

/// What a trace found, for a terminal: pixels and curves per class, counts, time.
[[nodiscard]] std::string truth_summary(const truth::Truth& truth);

/// The truths of a view as lists, at 2 px: made once for all images that are scored against them.
struct ViewLists {
    score::TruthLists scoring;
    std::optional<score::TruthLists> other = std::nullopt;         ///< as in ViewTruth
    std::optional<score::TruthLists> with_crowded = std::nullopt;  ///< as in ViewTruth
};

[[nodiscard]] ViewLists list_view(const ViewTruth& truth);

/// A truth as lists at each of kTolerances_px (harness/cells/cell.h).
[[nodiscard]] std::vector<score::TruthLists> list_tolerances(const score::ScoringTruth& truth);

}  // namespace ink::harness
