#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/cells/view_cells.h"
#include "harness/suite/suite.h"
#include "method/method_config.h"
#include "score/score.h"
#include "score/soft_score.h"
#include "studies/hardest/view_space.h"

namespace ink::studies {

/// Worst views of one scene point more than this apart, seen from its middle.
inline constexpr double kDistinct_deg = 10;

/// What is looked for on a scene: the view on which `method` has the least F at 2 px, or, with
/// `against`, loses most F to that one; of soft F where `cell.line_width_px` says how wide the true
/// lines are.
struct HardestOptions {
    method::MethodConfig method;
    std::optional<method::MethodConfig> against = {};
    int evaluations = 200;  ///< views to look at, beside the scene's own
    std::uint64_t seed = 0;
    int least_truth_px = 200;  ///< that count; a view with fewer is none
    int worst = 5;             ///< views that are kept, at most
    harness::CellOptions cell = {};
};

/// One view that was looked at.
struct HardestLook {
    std::string scene;
    std::string method;
    std::string against;  ///< "" for none
    int evaluation = 0;   ///< in the order of the search, from 1; of usual views from 1 again
    std::string phase;    ///< usual (the scene's own views), start, global, local
    double value = 0;     ///< what the search lowers: F, or its lead; from 1 on for no candidate
    std::string status = "ok";         ///< or why it is no candidate
    score::CurveCount count = {};      ///< of `method`; 0 where it has no score
    std::optional<double> f_2px = {};  ///< of `method`
    std::optional<double> f_against = {};
    std::optional<score::SoftScore> soft = {};  ///< of `method`, where soft F is searched
    std::optional<double> soft_f_against = {};
    ViewChoice choice = {};
    std::optional<int> rank = {};  ///< of a view that was kept, 1 for the worst
    std::string shown_as = {};     ///< its scene's name in rows.csv, which has the moment
    std::string view = {};         ///< its name there; of usual views their own name

    /// F of `method`, soft F where that is searched.
    [[nodiscard]] std::optional<double> f() const { return soft ? soft->f() : f_2px; }
    /// The same of the other.
    [[nodiscard]] std::optional<double> other_f() const {
        return soft ? soft_f_against : f_against;
    }
    [[nodiscard]] bool is_candidate() const { return status == "ok"; }
    /// What says where it is to commands that take a view: "--eye 1,2,3 --target 0,0,0 --fov 40".
    [[nodiscard]] std::string view_words() const;
};

/// Looks at the scene's own views, then searches, from the worst of them, globally and then locally
/// (search.h), and ranks the distinct worst candidates. The own views are no candidates.
///
/// Two thirds of the evaluations go to DIRECT, which looks from along the axes first, where views
/// are special; the rest to controlled random search and a local search from the worst so far. Of
/// three scenes and four seeds, at 150 evaluations, the mean of mote4's least F was 0.393; by
/// controlled random search first 0.541, by an evolution strategy first 0.472, at random 0.624.
///
/// In the order in which views were looked at. The same options give the same result, whatever the
/// machine and its threads. Nothing if Ctrl-C ended it. Throws core::Error if a method fails.
[[nodiscard]] std::optional<std::vector<HardestLook>> search_hardest_views(
    const harness::SceneViews& scene_views, const HardestOptions& options);

/// The scene at the moment of each kept view, with that view, in the order of their ranks.
[[nodiscard]] std::vector<harness::SceneViews> worst_scene_views(
    const harness::SceneViews& scene_views, const std::vector<HardestLook>& looks);

/// As many views drawn at random: what a search must beat.
[[nodiscard]] std::vector<HardestLook> random_views(const harness::SceneViews& scene_views,
                                                    const HardestOptions& options);

}  // namespace ink::studies
