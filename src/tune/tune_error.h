#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/param.h"
#include "score/score.h"
#include "tune/tune_log.h"

namespace ink::tune {

/// What a tuner lowers over all training views.
enum class TuneObjective {
    error,  ///< 1 - F at 2 px and the method's own threshold, all views pooled
    /// The square of the mean root of each scene's error: no scene speaks for all the others.
    ///
    /// Pooled errors let the one scene with the most of them decide (a soup with cracks has five
    /// times the others'), and what is found there fits it alone. With one training scene at a time
    /// left out, mote4's settings found over the others erred less on it by this mean than by the
    /// pool, by .120 against .139.
    scenes,
    ap,  ///< 1 - average precision at 2 px; the threshold is then the best over the same views
};

/// The square of the mean root of 1 - F over `scenes`; 0 if there are none.
[[nodiscard]] double scenes_error(const std::vector<score::CurveCount>& scenes);

/// What `objective`, `error` or `scenes`, makes of the counts of each scene.
[[nodiscard]] double error_of(const std::vector<score::CurveCount>& scenes,
                              TuneObjective objective);

/// One evaluation, in the order in which a search asked for them.
struct TuneStep {
    std::string phase;  ///< start | global | local | random
    core::ParamValues settings;
    TuneValue found;
};

/// Per view the counts of those settings among `steps` that err least on all the other views, the
/// first of several: what to expect on a view that the search has not seen.
///
/// `scene_of_view` has the index of each view's scene. Settings beyond a time budget (a value above
/// 1) are passed over where any keeps within it. Empty for fewer than two views or steps without
/// counts by view. O(steps * views^2).
[[nodiscard]] std::vector<score::CurveCount> leave_one_view_out(
    const std::vector<TuneStep>& steps,
    const std::vector<std::size_t>& scene_of_view,
    TuneObjective objective);

}  // namespace ink::tune
