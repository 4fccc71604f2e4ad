#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiment/run_data.h"
#include "statistics/spread.h"
#include "summary/paired_differences.h"

namespace ink::experiment {

/// The cells of two runs, paired: the same method on the same view.
struct CellPairs {
    std::vector<summary::RowPair> paired;    ///< in the order of the first run
    std::vector<const harness::Row*> gone;   ///< of the first run alone
    std::vector<const harness::Row*> added;  ///< of the second run alone
};

/// Pairs the rows of two runs by method, scene, view, size, threads and parameters.
///
/// What is left over is paired without the parameters, where each run has just one such cell left:
/// its method was asked with another setting. Borrows the rows; empty runs give no pairs.
[[nodiscard]] CellPairs pair_cells(const std::vector<harness::Row>& a,
                                   const std::vector<harness::Row>& b);

/// The parameters that differ between two texts "key=value;key=value": "threshold 20 -> 25", joined
/// by ", ", in alphabetical order; "" if none does. A side that lacks the key has "-".
[[nodiscard]] std::string changed_parameters(const std::string& a, const std::string& b);

/// An F of two runs, pooled over the cells that both scored.
struct FDiff {
    std::optional<double> before = {};
    std::optional<double> after = {};
    std::optional<double> difference = {};           ///< after less before
    std::optional<statistics::Interval> range = {};  ///< of that; 95 %, paired cluster bootstrap

    /// Whether it fell by more than the choice of scenes explains (by anything where fewer than six
    /// scenes give no interval).
    [[nodiscard]] bool is_worse() const;
};

/// What changed of one method between two runs, over the cells that both have.
struct MethodDiff {
    std::string method;
    std::string settings;  ///< parameters that were asked differently, "threshold 20 -> 25"; or ""
    int cells = 0;         ///< that both runs have
    int changed_images = 0;  ///< of those, whose image has another hash
    int changed_scores = 0;  ///< of those, whose counts at 2 px, or of ink, differ
    int lost = 0;            ///< of those, scored in the first run alone
    int won = 0;             ///< of those, scored in the second run alone
    FDiff f = {};            ///< at 2 px
    FDiff soft_f = {};       ///< over the cells of which both runs have it
    /// Drawing times, second over first: geometric mean over cells; nothing where they do not
    /// compare.
    std::optional<double> time_ratio = {};

    [[nodiscard]] bool is_same() const {
        return settings.empty() && changed_images + changed_scores + lost + won == 0;
    }
    /// Whether the second run is worse: a score is lost, or an F is worse.
    [[nodiscard]] bool is_worse() const { return lost > 0 || f.is_worse() || soft_f.is_worse(); }
};

/// A value of what was asked, in two runs; "-" where a run has none.
struct AskedChange {
    std::string key;  ///< "methods.mote4.threshold"
    std::string a;
    std::string b;
};

/// Two runs beside each other.
struct RunDiff {
    /// Methods with changes first: those with changed images, then by the size of the difference.
    std::vector<MethodDiff> methods;
    std::vector<AskedChange> asked;
    CellPairs cells;         ///< borrows the rows of both runs
    int changed_truths = 0;  ///< views on which the truth has another number of pixels
    /// Why times do not compare, "the processor differs: ..."; "" where they do.
    std::string times_obstacle;

    /// Whether something besides times differs.
    [[nodiscard]] bool is_same() const;
    /// Whether a method is worse, or a scored cell is gone.
    [[nodiscard]] bool is_worse() const;
};

/// What `b` changed against `a`, over their rows of the study `compare`; `seed` draws the
/// intervals. Borrows both runs.
[[nodiscard]] RunDiff diff_runs(const RunData& a, const RunData& b, std::uint64_t seed);

using Values = std::map<std::string, std::string>;

/// The values that two TOML documents have differently, in alphabetical order of their keys.
/// Throws core::Error (where = "run.toml") for text that is no TOML.
[[nodiscard]] std::vector<AskedChange> asked_changes(const std::string& a, const std::string& b);

}  // namespace ink::experiment
