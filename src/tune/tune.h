#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "harness/suite/suite.h"
#include "harness/truths/tracing.h"
#include "method/method_config.h"
#include "score/score.h"
#include "search/search.h"
#include "tune/tune_bench.h"
#include "tune/tune_log.h"
#include "tune/tune_objective.h"
#include "tune/tune_space.h"

namespace ink::tune {

struct TuneOptions {
    method::MethodConfig config;  ///< the method, with settings that stay as the user set them
    std::string parameters;       ///< as TuneSpace reads them
    TuneObjective objective = TuneObjective::pooled;
    /// Settings whose median drawing takes longer are out. Times are measured, so a search with a
    /// budget depends on the machine.
    std::optional<double> budget_ms;
    search::SearchPlan plan;
    /// Names of scenes that are only scored, though they might be searched.
    std::set<std::string> unseen;
    bool random = true;  ///< also a random search of as many evaluations and the same seed
    harness::TraceOptions trace;
    int threads = 1;
    std::filesystem::path out;  ///< run folder, with the preset <name>.toml
    bool is_forced = false;     ///< another run in `out` is thrown away
    std::string name;           ///< of the preset
    std::string command;        ///< that makes the same preset again
};

/// Settings with what they score.
struct TunedSettings {
    std::string name;
    core::ParamValues settings;  ///< of the parameters
    TuneValue found;
    std::vector<score::CurveCount> train;    ///< a sum per training scene, at 2 px
    std::vector<score::CurveCount> heldout;  ///< a sum per held-out scene; none if there are none
};

/// A scene that took part, or was only scored.
struct TunedScene {
    std::string name;
    scene::Split split;
    std::string kind;  ///< of thing
};

/// What came of a search.
struct TuneResult {
    TunedSettings defaults;  ///< the method as the user would have it without the search
    TunedSettings tuned;
    std::optional<TunedSettings> random;  ///< the best that random search found
    std::vector<TuneStep> steps;          ///< the search's evaluations
    std::vector<TuneStep> random_steps;
    std::optional<PlaneAgreement> agreement;  ///< of the tuned settings, where planes were drawn
    /// Of each training view, by settings that were chosen without it, or its kind
    /// (leave_one_out); empty if views are left out though there are held-out scenes, and if there
    /// is a single one.
    std::vector<score::CurveCount> left_out;
    std::size_t resumed = 0;  ///< evaluations that were found on disk
    bool is_interrupted = false;
    std::vector<TunedScene> train_scenes;    ///< those of TunedSettings::train, in that order
    std::vector<TunedScene> heldout_scenes;  ///< those of TunedSettings::heldout
    std::size_t train_views = 0;
    std::size_t heldout_views = 0;
    std::string inputs_hash;
    std::filesystem::path preset;  ///< the file that was written
};

/// Looks for the settings of a method that make the fewest errors on the training scenes and the
/// models among `scenes`, starting from its defaults, so that what is lowered is never worse there;
/// scores them on held-out scenes and those of `options.unseen`, which the search never sees.
///
/// Truths are traced once, and what a linear code reads of the scenes is rendered once: settings of
/// such a code are drawn from that, and by the method itself only where they may be the best yet
/// (TunePlanes). What other methods draw, they draw anew unless settings differ in the
/// threshold alone. All errors of `defaults`, `tuned` and `random` are the method's own. Everything
/// but times is the same for every thread count. Finished evaluations are kept in
/// `out`/evaluations.csv.part, from where the same command goes on after a kill. Throws core::Error
/// if there is nothing to search, or `out` holds another run or cannot be written.
[[nodiscard]] TuneResult tune(std::vector<harness::SceneViews> scenes, const TuneOptions& options);

}  // namespace ink::tune
