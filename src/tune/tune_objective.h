#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "score/score.h"
#include "tune/tune_log.h"

namespace ink::tune {

/// What a tuner lowers over all training views. Errors are 1 - F at 2 px and the method's own
/// threshold.
enum class TuneObjective {
    pooled,  ///< of all views pooled
    /// The square of the mean root of each scene's error: no scene speaks for all the others.
    ///
    /// Pooled errors let the one scene with the most of them decide (a soup with cracks has five
    /// times the others'), and what is found there fits it alone. With one training scene at a time
    /// left out, mote4's settings found over the others erred less on it by this mean than by the
    /// pool, by .120 against .139.
    scenes,
    kinds,  ///< the same over kinds of scenes, each kind's root the mean over its scenes
    worst,  ///< the error of the kind that has the largest, made as in `kinds`
    /// The mean error of kinds at the settings that the search starts from, less what is gained
    /// over them evenly: the mean over kinds of their scenes' gains, of which none counts more than
    /// 0.03 either way.
    ///
    /// A mean gain may be that of one noisy scan, paid for by all others. What gains a little
    /// nearly everywhere holds on scenes that were not searched.
    even,
};

/// "pooled", "scenes", "kinds", "worst", "even": as the command line has them.
[[nodiscard]] const std::vector<std::string>& objective_names();
[[nodiscard]] std::string_view name(TuneObjective objective);

/// The views of a bench: of which scene each is, and of which kind each scene. A scene whose kind
/// is "" is a kind of its own.
struct TuneViews {
    std::vector<std::size_t> scene_of_view;
    std::vector<std::string> kind_of_scene;
    /// Counts of each view at the settings that the search starts from; none: no gain.
    std::vector<score::CurveCount> at_start = {};
};

/// F of all scenes pooled.
[[nodiscard]] double f_of(const std::vector<score::CurveCount>& scenes);

/// What `objective` makes of the counts of each view; 0 if there are none.
[[nodiscard]] double error_of(const std::vector<score::CurveCount>& by_view,
                              const TuneViews& views,
                              TuneObjective objective);

/// Whether kinds are left out, not views, to foretell what settings score on others.
[[nodiscard]] bool is_by_kind(TuneObjective objective);

/// Per view the counts of those settings among `steps` that err least on all the other views or,
/// where the objective is by kind, on the views of all other kinds; the first of several: what to
/// expect of a view, or a kind, that the search has not seen.
///
/// Settings beyond a time budget (a value above 1) are passed over where any keeps within it. Empty
/// for fewer than two views (or kinds) or steps without counts by view. O(steps * views^2).
[[nodiscard]] std::vector<score::CurveCount> leave_one_out(const std::vector<TuneStep>& steps,
                                                           const TuneViews& views,
                                                           TuneObjective objective);

}  // namespace ink::tune
