#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "score/matching.h"
#include "score/pixel_list.h"
#include "score/score.h"
#include "truth/truth.h"

namespace ink::harness {

/// A property of true lines by whose value recall is asked for apart.
struct LineAttribute {
    std::string name;  ///< with its unit: "dihedral_deg"
    std::string doc;
    /// Bin i reaches from edges[i] to before edges[i + 1]; the last may be infinity, and the last
    /// bin holds its upper end.
    std::vector<double> edges;
    bool has_sky = false;  ///< one more bin for lines before the sky, from infinity to infinity
};

/// The attributes of bins.csv: dihedral_deg, relative_gap, view_angle_deg, relative_distance.
[[nodiscard]] const std::vector<LineAttribute>& line_attributes();

/// The true pixels of one bin.
struct TruthBin {
    std::size_t attribute = 0;  ///< into line_attributes()
    double low = 0;
    double high = 0;
    score::PixelList pixels;
};

/// Sorts the true pixels that count into bins, by the curve that drew each: the lowest label, then
/// the first. Bins without pixels are left out.
///
/// - dihedral_deg: how far the two faces deviate from flat; boundaries have none.
/// - relative_gap: depth from the line to what lies behind it over the line's own, at the middle of
///   its curve; contours and boundaries only.
/// - view_angle_deg: between line of sight and the normal of the seen face nearest edge-on.
/// - relative_distance: (w - nearest) / (farthest - nearest) at the pixel, among all visible curves
///   of the view; 0 where all are equally far.
[[nodiscard]] std::vector<TruthBin> bin_truth(const truth::Truth& traced,
                                              const score::ScoringTruth& scoring);

/// How much of a bin was found, by a matching of its own.
struct BinCount {
    std::size_t attribute = 0;  ///< into line_attributes()
    double low = 0;
    double high = 0;
    std::int64_t k = 0;
    std::int64_t n_truth = 0;
};

/// Matches all that is drawn (thinned, counted_pixels) against each bin alone.
[[nodiscard]] std::vector<BinCount> match_bins(score::DrawnMatcher& drawn,
                                               const std::vector<TruthBin>& bins);

}  // namespace ink::harness
