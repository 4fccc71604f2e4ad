#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/suite.h"
#include "harness/tracing.h"
#include "linear_code/linear_bound.h"
#include "method/method_config.h"

namespace ink::linear_code {

/// Which code is asked about, and how its bound is looked for.
struct BoundStudyOptions {
    method::MethodConfig config;  ///< a method that declares its code
    bool is_signed = false;       ///< weights below 0 too
    int least_threshold = 0;      ///< codes; 0: the least that the filter draws
    harness::TraceOptions trace;
    LinearBoundOptions search;  ///< its threads draw and trace, too; `starts` are added to
};

/// What one scene, or several taken together, allow four weights.
struct BoundRow {
    std::string scene;  ///< or "(training)", "(held-out)", "(real)", "(all)": counts of their
                        ///< scenes added up
    std::string split;  ///< "train", "heldout", "real" or ""
    int views = 0;
    score::CurveCount measured;           ///< the method's own, as it is scored, at 2 px
    std::optional<LinearCount> modelled;  ///< its weights by the bound's reckoning, if it has them
    LinearBound bound;
};

/// Throws core::Error (where = the method) if it declares no code, or one that weight_domain()
/// refuses: before any work.
void check_bound(const BoundStudyOptions& options);

/// A row for every scene, in their order, then one for the training scenes, the held-out ones and
/// all of them, where that is more than one scene and not the same as a row before.
///
/// What a scene's search found is tried first on the pools. After Ctrl-C (see InterruptGuard) the
/// rows that are done. Throws core::Error (where = the method) if it declares no code or one that
/// weight_domain() refuses, (where = the scene) if its truth is too large to trace.
[[nodiscard]] std::vector<BoundRow> study_bounds(const std::vector<harness::SceneViews>& scenes,
                                                 const BoundStudyOptions& options);

/// For a terminal: a line per row.
[[nodiscard]] std::string bound_table(const std::vector<BoundRow>& rows);

}  // namespace ink::linear_code
