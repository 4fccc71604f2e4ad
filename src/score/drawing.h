#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <vector>

#include "core/error.h"
#include "edge/bit_mask.h"
#include "edge/edge_image.h"
#include "score/pixel_list.h"
#include "score/score.h"

namespace ink::score {

/// The stages of a comparison, one by one; score() runs them in the order in which they stand here.

/// A thresholded picture: all that is drawn, and the same made thin. Nothing is taken out yet.
struct Strokes {
    edge::Mask drawn;
    edge::BitMask thinned;  ///< `drawn` again where the options say not to thin
    std::int64_t n_drawn = 0;
    std::int64_t n_thinned = 0;

    /// Drawn pixels over thinned pixels; 0 if none.
    [[nodiscard]] double mean_width_px() const {
        return n_thinned > 0 ? static_cast<double>(n_drawn) / static_cast<double>(n_thinned) : 0;
    }
};

/// Threshold and thin. Reads `thin` of the options; `threshold` is 1..255.
[[nodiscard]] Strokes make_strokes(const edge::EdgeImage& prediction,
                                   int threshold,
                                   const ScoreOptions& options);

/// True pixels of one label.
struct ClassPixels {
    std::uint8_t label = 0;
    PixelList pixels;
};

/// The truth's side of a comparison at one tolerance, as lists: made once for all images that are
/// scored against one truth.
struct TruthLists {
    PixelList truth;
    PixelList ignore;
    Disk disk;
    edge::BitMask countable;           ///< the pixels that count if something is drawn there
    std::vector<ClassPixels> classes;  ///< of `truth`, by label, ascending; none if it is binary
};

/// Lists a truth's pixels, and those under its ignore map, for the options' tolerance and band.
[[nodiscard]] TruthLists list_truth(const ScoringTruth& truth, const ScoreOptions& options);

/// The same, if options and sizes will do. Throws core::Error as score() does if not.
[[nodiscard]] TruthLists checked_lists(const edge::EdgeImage& prediction,
                                       const ScoringTruth& truth,
                                       const ScoreOptions& options);

/// Takes band and ignore out of drawn pixels: of those left by the band, one with an ignored pixel
/// and no truth pixel within the tolerance is dropped. What is left counts. Throws core::Error,
/// which names both sizes, if the two differ in size.
[[nodiscard]] PixelList counted_pixels(edge::BitMask drawn, const TruthLists& lists);

/// Matches what counts of a drawing with the truth.
[[nodiscard]] CurveCount match_counts(const PixelList& drawn, const TruthLists& lists);

/// What score() says of strokes, of which `drawn` counts.
[[nodiscard]] Score score_lists(const Strokes& strokes,
                                const PixelList& drawn,
                                const TruthLists& lists);

/// The same of score_curve(), with the truth as lists. Reads `thin` of the options.
[[nodiscard]] std::array<CurveCount, 99> score_curve_lists(const edge::EdgeImage& prediction,
                                                           const TruthLists& lists,
                                                           const ScoreOptions& options);

/// Sets the pixels closer than `band_px` to the frame to 0.
void clear_band(core::Image<std::uint8_t>& image, int band_px);

/// Throws core::Error, which names both sizes, if the two pictures differ in size.
template <class Drawn, class Truth>
void check_same_size(const Drawn& drawn, const Truth& truth) {
    if (drawn.width_px() == truth.width_px() && drawn.height_px() == truth.height_px()) return;
    throw core::Error("score",
                      fmt::format("the prediction is {} x {} px and the truth {} x {} px",
                                  drawn.width_px(),
                                  drawn.height_px(),
                                  truth.width_px(),
                                  truth.height_px()),
                      "two pictures of one size");
}

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
