#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edge/laplacian.h"
#include "harness/rows/side_tables.h"
#include "harness/scores/evaluations.h"
#include "harness/scores/miss_prediction.h"
#include "harness/truths/tracing.h"
#include "method/method.h"
#include "score/matching.h"
#include "score/pixel_list.h"
#include "score/score.h"
#include "truth/line_class.h"
#include "truth/truth.h"

namespace ink::linear_code {

/// The least |L| whose edge response, by either sign, is `edge_response` (1..255) or more, in
/// codes; nothing if none is.
[[nodiscard]] std::optional<int> threshold_in_codes(const edge::LaplacianResponse& response,
                                                    int edge_response);

/// The largest dihedral deviation between two facets that a code and its threshold keep silent
/// whichever way the facets lie: their normals differ by 2 sin(deviation / 2), the code by |w|
/// sin(deviation / 2) at most (w the normal's weights, of (n + 1) / 2), and a pixel on a straight
/// line sees that once or twice. Depth is left out: across an edge where faces meet it bends, but
/// does not jump.
///
/// Radians, 0..pi; pi for a code that has no normal in it or a threshold that nothing reaches.
[[nodiscard]] double silent_deviation_rad(const method::LinearCode& code, int threshold);

// What one linear sum must miss of creases that bend by a deviation, if they lie in all directions
// alike: sin(silent / 2) / sin(deviation / 2), at most 1. In any direction the change of the normal
// has along w is uniform (Archimedes: a sphere's belts of equal height have equal area), so the
// share that stays below what the silent dihedral deviation makes at most is the ratio of the two.
// The page draws this curve (report/page/sections/cancellation.js).
// Source: the project's design, sections 6 and 9, there for silent = 10 degrees.

/// Bins of the dihedral are this wide: 0 to 10, ... 170 to 180 degrees.
inline constexpr int kDihedralBin_deg = 10;

/// A class of line and how far its two faces deviate from flat.
struct LineKind {
    truth::LineClass line_class = truth::LineClass::none;
    /// Lower end of the bin, a multiple of kDihedralBin_deg; nothing for boundaries.
    std::optional<int> dihedral_low_deg;

    friend auto operator<=>(const LineKind&, const LineKind&) = default;
};

/// The true pixels of one kind.
struct KindPixels {
    LineKind kind;
    score::PixelList pixels;
};

/// Sorts the true pixels that count by their kind, ascending: class by label, dihedral by the curve
/// that drew the pixel (the lowest label, then the first); what lies a hundredth of a degree below
/// a bin is in it. Kinds without pixels are left out.
[[nodiscard]] std::vector<KindPixels> sort_by_kind(const truth::Truth& traced,
                                                   const score::ScoringTruth& scoring);

/// What was predicted of the true pixels of one kind, and what was seen.
///
/// `missed` is what recall leaves: n_truth less the pairs of a one-to-one matching within 2 px, of
/// the kind's own (as in bins.csv). `false_negatives` are pixels with nothing drawn within 2 px;
/// these are certain pixels, so that it can be said how many are both.
struct CancellationCount {
    std::int64_t n_truth = 0;
    std::int64_t predicted_missed = 0;
    std::int64_t measured_missed = 0;
    std::int64_t predicted_false_negatives = 0;
    std::int64_t measured_false_negatives = 0;
    std::int64_t both_false_negatives = 0;

    [[nodiscard]] bool operator==(const CancellationCount&) const = default;
};

/// Thinned ink that counts (score::counted_pixels), ready to be held against one kind after the
/// other.
class CountedInk {
  public:
    CountedInk(score::PixelList pixels, const score::Disk& disk)
        : pixels_(std::move(pixels)),
          matcher_(pixels_, disk),
          reach_(score::reach_of(pixels_, disk)) {}
    CountedInk(const CountedInk&) = delete;
    CountedInk& operator=(const CountedInk&) = delete;

    /// How many of `kind` it is matched with at most, one to one.
    [[nodiscard]] std::int64_t match(const score::PixelList& kind) { return matcher_.match(kind); }
    /// Whether some of it is in reach of a pixel.
    [[nodiscard]] bool is_near(int x, int y) const { return reach_.is_set(x, y); }

  private:
    score::PixelList pixels_;
    score::DrawnMatcher matcher_;  ///< of pixels_
    edge::BitMask reach_;
};

/// Counts of one kind.
[[nodiscard]] CancellationCount count_cancellation(const score::PixelList& kind,
                                                   CountedInk& predicted,
                                                   CountedInk& measured);

/// The counts of a method with a declared code, of one kind of line on one view.
struct CancellationRow {
    std::size_t evaluation = 0;  ///< its place among those of the view
    double silent_deg =
        0;  ///< dihedral deviation up to which the code is silent (silent_deviation_rad())
    LineKind kind = {};
    CancellationCount count = {};
};

/// The columns of cancellation.csv: cell, silent_deg, class, dihedral_low_deg, dihedral_high_deg,
/// then counts. A boundary's bin is two empty fields.
[[nodiscard]] const harness::SideTable<CancellationRow>& cancellation_table();

/// For each evaluation of `view` whose method declares a code: what the code must miss
/// (predicted_positives(), from truth geometry and weights alone), beside what its image missed.
/// Both sets are thinned, cut and matched alike. Evaluations that failed and those without a code
/// have no rows.
[[nodiscard]] std::vector<CancellationRow> study_cancellation(
    const harness::ViewTruth& truth,
    const scene::View& view,
    harness::MissPredictor& predictor,
    const std::vector<harness::Evaluation>& evaluations);

}  // namespace ink::linear_code
