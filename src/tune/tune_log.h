#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/param.h"
#include "score/score.h"

namespace ink::tune {

/// What one evaluation found: counts pooled over the training views, or a value of its own.
struct TuneValue {
    double value = 0;  ///< what the search lowers: 1 - F or 1 - AP, and more beyond a time budget
    double error = 0;  ///< 1 - F or 1 - AP
    std::optional<double> draw_ms = {};  ///< where a time budget asked for it
    bool is_by_planes = false;  ///< else the method itself drew; no part of the log's lines
    std::vector<score::CurveCount> by_view = {};  ///< of each training view, unless AP is lowered
};

/// The finished evaluations of a search, on disk as soon as they are known.
///
/// A setting may be there twice, drawn from planes and by its method, under a key of its own each.
/// Lines are flushed one by one. A search that was killed and is started again with the same key
/// finds them, and since it asks for the same settings in the same order it comes to the point
/// where it stopped without drawing anything. Numbers are written so that they read back the same.
class TuneLog {
  public:
    /// Opens `path`. Lines of another key are thrown away, as is a last line without an end. Throws
    /// core::Error (where = the path) if it cannot be written.
    TuneLog(std::filesystem::path path, const std::string& key);

    /// How many evaluations were found there.
    [[nodiscard]] std::size_t found() const { return found_; }

    /// What was found for these settings ("a=1;b=2").
    [[nodiscard]] std::optional<TuneValue> find(const std::string& settings) const;
    void add(const std::string& settings, const TuneValue& value);
    /// Takes the file away: the search is finished.
    void remove();

  private:
    void read(const std::string& key);

    std::filesystem::path path_;
    std::ofstream stream_;
    std::map<std::string, TuneValue> values_;
    std::size_t found_ = 0;
};

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

/// F of all scenes pooled.
[[nodiscard]] double f_of(const std::vector<score::CurveCount>& scenes);

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
