#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "score/score.h"
#include "statistics/spread.h"

namespace ink::statistics {

/// Fewer clusters give no interval: how far they differ is hardly known from them.
inline constexpr std::size_t kFewestClusters = 6;

/// How intervals are found by drawing again.
struct BootstrapOptions {
    int resamples = 2000;
    std::uint64_t seed = 0;
};

/// How often each of `clusters` clusters is drawn, with replacement: a line a drawing. The same
/// seed gives the same everywhere.
[[nodiscard]] std::vector<std::vector<double>> drawings_of(std::size_t clusters,
                                                           const BootstrapOptions& options);

/// The 95 % interval of the pooled F over resamplings of whole clusters, with replacement: the
/// bootstrap t (simultaneous.h).
///
/// A cluster is a scene, its counts summed over its views: views of one scene are hard or easy
/// together, so drawing views one by one would pretend to more evidence than there is and give
/// intervals that are too narrow (held by a simulation in the tests). Scenes are drawn, each with
/// all its views; what is left to chance is which scenes were looked at.
///
/// The same seed and clusters give the same interval everywhere. Nothing with fewer than
/// kFewestClusters.
/// Source: Field and Welsh, "Bootstrapping clustered data", J. R. Stat. Soc. B 69, 2007 (the
/// cluster bootstrap).
[[nodiscard]] std::optional<Interval> f_interval(const std::vector<score::CurveCount>& clusters,
                                                 const BootstrapOptions& options);

/// How many of 100 such intervals, of F or of a paired difference, hold the truth: simulated from
/// the scenes of the catalogue (experiments/notes/intervals.md), for the number of scenes nearest
/// to this.
[[nodiscard]] int known_coverage_percent(int clusters);

/// The same of the difference of two pooled F, a's less b's. `a[i]` and `b[i]` are of one cluster
/// and drawn together (paired), so that what makes a scene hard for both cancels out.
[[nodiscard]] std::optional<Interval> paired_interval(const std::vector<score::CurveCount>& a,
                                                      const std::vector<score::CurveCount>& b,
                                                      const BootstrapOptions& options);

}  // namespace ink::statistics
