#pragma once

#include <cstdint>
#include <vector>

#include "score/drawing.h"
#include "score/score.h"

namespace ink::score {

/// What blind luck scores: random images against one truth.
///
/// A random image of n pixels is n places drawn uniformly, without replacement, among the pixels
/// that count (outside the band, not under the ignore label); it is not thinned, which would take
/// pixels away that were to be there, and else scored as any image. Its F is what a method gets
/// for the number of its positive pixels alone, wherever it lies. Nothing closed is known for the
/// largest one-to-one matching of random with given points, so it is drawn; the spread over seeds
/// is small against F, since each of n pixels is an independent trial but for competition.
class RandomBaseline {
  public:
    /// The same seed gives the same images everywhere.
    RandomBaseline(const ScoringTruth& truth, const ScoreOptions& options, std::uint64_t seed);

    /// The counts of a random image of `n_drawn` pixels (of all there are, if they are fewer).
    [[nodiscard]] CurveCount counts(std::int64_t n_drawn) const;

  private:
    TruthLists lists_;
    std::uint64_t seed_;
    std::vector<std::uint32_t> places_;  ///< those that count, row by row
};

}  // namespace ink::score
