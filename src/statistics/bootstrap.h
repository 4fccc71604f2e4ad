#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "score/score.h"
#include "statistics/spread.h"

namespace ink::statistics {

/// How intervals are found by drawing again.
struct BootstrapOptions {
    int resamples = 2000;
    std::uint64_t seed = 0;
};

/// The middle 95 % of the pooled F over resamplings of whole clusters, with replacement.
///
/// A cluster is a scene, its counts summed over its views: views of one scene are hard or easy
/// together, so drawing views one by one would pretend to more evidence than there is and give
/// intervals that are too narrow (held by a simulation in the tests). Scenes are drawn, each with
/// all its views; what is left to chance is which scenes were looked at.
///
/// The same seed and clusters give the same interval everywhere. Nothing with fewer than two
/// clusters. With few of them the interval is a little narrow (25 scenes: about 93 % in truth).
/// Source: Field and Welsh, "Bootstrapping clustered data", J. R. Stat. Soc. B 69, 2007 (the
/// cluster bootstrap); Efron and Tibshirani, An Introduction to the Bootstrap, 1993, section 13.3
/// (percentiles).
[[nodiscard]] std::optional<Interval> f_interval(const std::vector<score::CurveCount>& clusters,
                                                 const BootstrapOptions& options);

/// The same of the difference of two pooled F, a's less b's. `a[i]` and `b[i]` are of one cluster
/// and drawn together (paired), so that what makes a scene hard for both cancels out.
[[nodiscard]] std::optional<Interval> paired_interval(const std::vector<score::CurveCount>& a,
                                                      const std::vector<score::CurveCount>& b,
                                                      const BootstrapOptions& options);

}  // namespace ink::statistics
