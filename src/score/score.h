#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/image.h"
#include "edge/edge_image.h"

namespace ink::score {

/// How two images are compared (section 7 of the design).
struct ScoreOptions {
    /// Matched pixels are at most this far apart, centre to centre; more than 0, at most 8.
    double tolerance_px = 2;
    int threshold = 128;  ///< predicted pixels have at least this edge response, 1..255
    bool thin = true;     ///< thin the prediction (Guo-Hall) after the threshold
    int band_px = 0;      ///< pixels this close to the frame are taken out of both sets; >= 0
    /// Truth label that is neither required nor penalised; 1..255.
    std::optional<int> ignore_label = std::nullopt;
};

/// Throws core::Error, which names the field and its range, if an option is outside its range.
void check(const ScoreOptions& options);

/// Recall of one label, from a matching of its own.
struct ClassCount {
    int label = 0;
    std::int64_t k = 0;
    std::int64_t n_truth = 0;
};

/// Matches, drawn and true pixels of one image at one threshold and tolerance, or their sums over
/// images: counts add up where F does not.
struct CurveCount {
    std::int64_t k = 0;  ///< size of a maximum one-to-one matching
    std::int64_t n_pred = 0;
    std::int64_t n_truth = 0;

    CurveCount& operator+=(const CurveCount& other);
    /// 2k / (n_pred + n_truth); 1 if both are empty.
    [[nodiscard]] double f() const;
    [[nodiscard]] bool operator==(const CurveCount&) const = default;
};

/// The counts of one comparison; every number is unique, whatever algorithm found it.
///
/// n_pred = k + unmatched_duplicates + false_positives and n_truth = k + unmatched_truth +
/// false_negatives.
struct Score : CurveCount {
    std::int64_t unmatched_duplicates =
        0;  ///< unmatched predicted pixels that have a truth pixel in reach
    std::int64_t false_positives = 0;  ///< predicted pixels without a truth pixel in reach
    std::int64_t unmatched_truth =
        0;  ///< unmatched truth pixels that have a predicted pixel in reach
    std::int64_t false_negatives = 0;  ///< truth pixels without a predicted pixel in reach
    double mean_width_px =
        0;  ///< drawn pixels over thinned pixels, both before the band; 0 if none
    std::vector<ClassCount>
        classes;  ///< one per label in the truth, ascending; empty if it is binary

    /// F as a result for people and tables: nothing if there is no truth.
    [[nodiscard]] std::optional<double> f_of_truth() const;
    /// k / n_pred; nothing if no pixel is predicted.
    [[nodiscard]] std::optional<double> precision() const;
    /// k / n_truth; nothing if there is no truth.
    [[nodiscard]] std::optional<double> recall() const;
};

/// A truth image made ready to be scored against: labels 0 where nothing counts.
struct ScoringTruth {
    core::Image<std::uint8_t> labels;         ///< of real truth pixels, band and ignore taken out
    edge::Mask ignore;                        ///< 1 under the ignore label (band taken out)
    std::vector<std::uint8_t> labels_in_use;  ///< without 0, ascending
    /// No classes: labels_in_use is empty, {1} or {255}. Whoever knows that a lone 1 is a class
    /// says so by setting this to false.
    bool is_binary = true;
};

/// Takes band and ignore label out of a truth image; `rethin` then thins what is left, so that the
/// stored truth scores exactly 1 against itself: draw `labels` of the result, not of the file,
/// since thinning comes before the band. `inkbench score` does not rethin (a foreign truth is never
/// touched); `compare` does.
///
/// Throws core::Error for options outside their range.
[[nodiscard]] ScoringTruth prepare_truth(const core::Image<std::uint8_t>& labels,
                                         const ScoreOptions& options,
                                         bool rethin);

/// Scores an edge response image against a prepared truth of the same size: threshold, thin, band,
/// ignore, match, in this order. Exact; its time grows with the drawn pixels, hardly with the
/// image's size.
///
/// Throws core::Error for another size (both are named) or options outside their range. Empty
/// images score 1, as any empty prediction of an empty truth does.
[[nodiscard]] Score score(const edge::EdgeImage& prediction,
                          const ScoringTruth& truth,
                          const ScoreOptions& options);

/// (k, n_pred, n_truth) at the 99 thresholds k/100, on where edge response * 100 >= 255 * k, in
/// integers. Equal masks are matched once. Entry i is threshold (i+1)/100. `options.threshold` is
/// not read.
///
/// Throws core::Error as score() does.
[[nodiscard]] std::array<CurveCount, 99> score_curve(const edge::EdgeImage& prediction,
                                                     const ScoringTruth& truth,
                                                     const ScoreOptions& options);

/// Area under the precision envelope from recall 0 (all points with n_pred > 0).
/// Without any truth: 1 if no threshold fires anywhere, else 0.
[[nodiscard]] double average_precision(const std::array<CurveCount, 99>& curve);

}  // namespace ink::score
