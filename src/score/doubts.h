#pragma once

#include <string>

#include "score/score.h"

namespace ink::score {

/// The part of an image that counts as drawn, 0..1.
[[nodiscard]] double drawn_share(const edge::EdgeImage& image, int threshold);

/// Lines cover a small part of any image: with more than this, something is wrong.
inline constexpr double kMostDrawn = 0.5;

/// What seems to be wrong with an image that was drawn elsewhere, in a sentence; "" if nothing
/// does.
///
/// Nothing or nearly everything is drawn, or a border around it is; the image is upside down,
/// mirrored, turned by 180 degrees, shifted by at most 16 px, or has an empty border of at most
/// 64 px, if it scores much better when that is undone; it scores better by more than 0.02 at
/// another threshold; its lines are nowhere near the true ones. `f` is what it scores as it is. A
/// truth without a pixel that counts says nothing of the place of lines.
///
/// Throws core::Error as score() does.
[[nodiscard]] std::string doubt_of(const edge::EdgeImage& image,
                                   const ScoringTruth& truth,
                                   const ScoreOptions& options,
                                   double f);

}  // namespace ink::score
