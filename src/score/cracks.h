#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "edge/edge_image.h"
#include "score/score.h"
#include "truth/curve.h"

namespace ink::score {

/// Truth cracks made ready to be scored against: the second score, which thins nothing.
///
/// A crack counts if both its pixels do: they lie outside the band and are not ignored.
struct CrackTruth {
    /// A crack that counts: its two pixels, as indices into an image of the truth's size.
    struct Crack {
        std::uint32_t pixel = 0;
        std::uint32_t other = 0;
        std::uint8_t label = 0;
    };
    std::vector<Crack> cracks;
    /// What a drawn pixel there is: `kLeftOut`, `kFalse` or `kBeside` (a crack on one of its
    /// sides).
    core::Image<std::uint8_t> verdict;

    static constexpr std::uint8_t kLeftOut = 0;
    static constexpr std::uint8_t kFalse = 1;
    static constexpr std::uint8_t kBeside = 2;
};

/// The cracks of one class, or of all, and how many of them were found.
struct CrackCount {
    std::int64_t n_found = 0;  ///< at least one of the two pixels is drawn
    std::int64_t n_truth = 0;
};

/// A thresholded image against cracks. No tolerance, no thinning: a line on either side of a
/// crack, or on both, is in its place; a line one pixel further on is not.
struct CrackScore {
    CrackCount all;
    std::array<CrackCount, 8> classes;  ///< by truth::LineClass
    std::int64_t n_drawn = 0;           ///< drawn pixels that count
    std::int64_t n_beside = 0;          ///< of them, those with a truth crack on one of four sides

    /// n_beside / n_drawn; nothing if no pixel is drawn.
    [[nodiscard]] std::optional<double> precision() const;
    /// Share of the cracks found; nothing if there are none.
    [[nodiscard]] std::optional<double> recall() const;
    /// Harmonic mean of the two; 1 if nothing is drawn and nothing true, 0 if one alone is empty.
    [[nodiscard]] double f() const;
};

/// Takes band and ignore out of cracks. Reads `band_px` of the options and the ignore map of
/// `truth`, which is of the same size.
///
/// A drawn pixel is left out if it lies in the band, or under the ignore map, or beside an ignored
/// pixel with no crack on any of its four sides. Cracks towards the band or an ignored pixel are
/// not asked for, but whoever draws along them is right.
[[nodiscard]] CrackTruth prepare_cracks(const truth::Cracks& cracks,
                                        const ScoringTruth& truth,
                                        const ScoreOptions& options);

/// Scores what is drawn (before any thinning) against prepared cracks of the same size. Costs one
/// pass over the image.
///
/// Throws core::Error for another size.
[[nodiscard]] CrackScore score_cracks(const edge::Mask& drawn, const CrackTruth& truth);

}  // namespace ink::score
