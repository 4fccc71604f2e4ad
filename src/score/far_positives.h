#pragma once

#include <cstdint>

#include "edge/edge_image.h"
#include "score/score.h"

namespace ink::score {

/// What a drawn pixel at each place is worth, for one tolerance; made once a view.
struct PositiveTruth {
    core::Image<std::uint8_t> verdict;  ///< kLeftOut, kNear or kFalse

    static constexpr std::uint8_t kLeftOut = 0;  ///< in the band, or dropped for an ignored pixel
    static constexpr std::uint8_t kNear = 1;     ///< a truth pixel within the tolerance
    static constexpr std::uint8_t kFalse = 2;    ///< none
};

/// Drawn pixels, before any thinning.
struct PositiveCount {
    std::int64_t n_drawn = 0;  ///< that count
    std::int64_t n_false = 0;  ///< further than the tolerance from every truth pixel
};

/// Judges every pixel as counted_pixels does. Reads tolerance and band of the options.
[[nodiscard]] PositiveTruth prepare_positives(const ScoringTruth& truth,
                                              const ScoreOptions& options);

/// Counts the ink of an image of the truth's size. One pass.
///
/// Throws core::Error for another size.
[[nodiscard]] PositiveCount count_positives(const edge::Mask& drawn, const PositiveTruth& truth);

}  // namespace ink::score
