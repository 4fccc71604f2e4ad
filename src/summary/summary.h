#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/rows/row.h"
#include "score/score.h"
#include "statistics/ods.h"
#include "statistics/spread.h"

namespace ink::summary {

/// An F of a method on scenes of one kind.
struct KindSummary {
    std::string kind;
    int scenes = 0;
    double f = 0;             ///< of the counts pooled over their views
    std::string least_scene;  ///< the one with the lowest F
    double f_least = 0;       ///< of that
};

/// What an F is of.
enum class Measure {
    f_2px,   ///< pixels within 2 px of each other
    soft_f,  ///< the ink of grey lines
};

/// "f_2px", "soft_f": as columns have it.
[[nodiscard]] std::string_view name(Measure measure);

/// An F of a method: of counts pooled over its views.
struct FSummary {
    std::optional<double> all;                  ///< over all of them
    std::optional<statistics::Interval> range;  ///< 95 %, cluster bootstrap; six scenes at least
    std::string error_scene;                    ///< with most of its error; "" if there is none
    std::optional<double> error_scene_share;    ///< of all that is wrong
    std::optional<double> train;                ///< over the views of training scenes
    std::optional<double> heldout;              ///< over those of held-out scenes
    std::optional<double> real;                 ///< over those of model files
    std::optional<double> macro;                ///< mean over scenes of F over each one's views
    std::vector<KindSummary> kinds;             ///< in order of first appearance
    std::optional<double> mean_of_kinds;        ///< of their F; nothing for fewer than two
    std::map<std::string, score::CurveCount> counts_of_scene = {};  ///< by name
};

/// What all rows of one method say together. A row that failed counts in `failed` and nowhere else;
/// an empty value never enters a mean.
struct MethodSummary {
    std::string method;
    bool is_baseline = false;
    bool has_own_clock = false;       ///< from outside: its times are not measured here
    int views = 0;                    ///< rows without failure
    int failed = 0;                   ///< rows with one
    int scenes = 0;                   ///< of those without
    FSummary f;                       ///< at 2 px
    FSummary soft_f;                  ///< nothing unless all its views have it
    std::optional<double> ap;         ///< of its views' curves; see add_curves
    std::optional<double> f_1px;      ///< pooled
    std::optional<double> precision;  ///< pooled, 2 px
    std::optional<double> recall;
    std::map<std::string, double> recall_by_class;          ///< pooled, classes present only
    std::optional<double> draw_ms;                          ///< median over views
    std::optional<statistics::Interval> draw_ms_quartiles;  ///< over views
    /// Where its time may lie: medians over views of the least and of the median of each cell.
    std::optional<statistics::Interval> draw_ms_doubt;
    std::string image_hashes;  ///< of all its views, equal where two methods draw the same; "" if
                               ///< one is not known
    std::optional<int> bytes_per_px;  ///< the largest

    /// What it is judged by.
    [[nodiscard]] Measure measure() const { return soft_f.all ? Measure::soft_f : Measure::f_2px; }
    [[nodiscard]] const FSummary& by(Measure measure) const {
        return measure == Measure::soft_f ? soft_f : f;
    }
    [[nodiscard]] const FSummary& judged() const { return by(measure()); }
};

/// Whether most of the method's error sits in one of many scenes: its F is then known less well
/// than an interval says, for who does not meet that scene does not see that error.
[[nodiscard]] bool is_error_in_one_scene(const MethodSummary& summary);

/// One summary per method, in order of first appearance, the baselines last.
[[nodiscard]] std::vector<MethodSummary> summarise(const std::vector<harness::Row>& rows);

/// Writes what the curves say into the summaries of their methods.
void add_curves(const std::vector<statistics::CellCurve>& curves,
                std::vector<MethodSummary>& summaries);

/// What F of a row is made of; of ink the row must have it.
[[nodiscard]] score::CurveCount counts_of(const harness::Row& row, Measure measure);

/// Counts summed over the views of each scene, in order of first appearance.
struct SceneSums {
    std::vector<std::string> names;
    std::vector<score::CurveCount> counts;

    void add(const std::string& scene, const score::CurveCount& more);
};

/// The rows of `method` that have a score.
[[nodiscard]] std::vector<const harness::Row*> scored_rows(const std::vector<harness::Row>& rows,
                                                           const std::string& method);

/// Whether a method of the registry draws nothing by itself, but has another one draw (`auto`).
[[nodiscard]] bool is_choice_of_others(const std::string& method);

/// Whether a method of the registry looks once per pixel at the surface, so that `sampled` is what
/// it may hope for; false for those that draw edges or hulls, and for names that the registry does
/// not know.
[[nodiscard]] bool takes_one_sample(const std::string& method);

}  // namespace ink::summary
