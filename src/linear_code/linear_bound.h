#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "linear_code/channel_planes.h"
#include "linear_code/linear_bound_domain.h"
#include "score/score.h"

namespace ink::linear_code {

/// The Laplacians of a code's four channels at one pixel: under weights w its filter gives w . v.
using StencilVector = std::array<float, 4>;

/// By how much of the threshold stencils may differ that are taken for parallel.
inline constexpr double kParallelStencils = 5e-4;

/// All that weights of a domain can be judged by: the stencils of one or more views.
///
/// A truth pixel's candidates are the stencils within kTolerance_px of it that the band does not
/// take out. What cannot fire anywhere in the domain is left out, and so is a candidate that fires
/// only where another of the same pixel does.
class LinearStencils {
  public:
    explicit LinearStencils(const WeightDomain& domain) : domain_(domain) {}

    /// Adds a view. Both are of one size.
    void add(const ChannelPlanes& planes, const score::ScoringTruth& truth);
    /// Adds all views of another, of the same domain.
    void add(const LinearStencils& others);
    /// Adds one truth pixel with the stencils that would find it.
    void add_truth_pixel(std::vector<StencilVector> candidates);
    /// Adds one pixel that is a far positive if it fires.
    void add_far_pixel(const StencilVector& v);

    [[nodiscard]] const WeightDomain& domain() const { return domain_; }
    /// Truth pixels, those without a candidate too.
    [[nodiscard]] std::int64_t n_truth() const { return n_truth_; }
    /// Truth pixels with a candidate.
    [[nodiscard]] std::size_t findable() const { return begin_.size() - 1; }
    /// Candidates of findable pixel `i`: candidates()[begin(i)] .. candidates()[begin(i + 1) - 1].
    [[nodiscard]] std::size_t begin(std::size_t i) const { return begin_[i]; }
    [[nodiscard]] const std::vector<StencilVector>& candidates() const { return candidates_; }
    [[nodiscard]] const std::vector<StencilVector>& far() const { return far_; }

  private:
    [[nodiscard]] bool can_fire(const StencilVector& v) const;
    [[nodiscard]] bool is_dominated(const StencilVector& v, const StencilVector& by) const;

    WeightDomain domain_;
    std::vector<StencilVector> candidates_;
    std::vector<std::size_t> begin_{0};
    std::vector<StencilVector> far_;
    std::int64_t n_truth_ = 0;
};

/// What is counted of the ink that lies off every line.
///
/// Thinning makes less of it: a solid patch of far positives becomes a few strokes.
/// found: of 200 random weights on each of the catalogue's scenes at 640x360 (first views, T from
/// 1 to 40 codes) no measured F lies more than 0.0001 above the model's with 1/4; with 1/2 that of
/// one scene did by 0.024 (`flag` in T below 2, where all of it is ink), with 1 those of eleven.
inline constexpr double kFarPositiveShare = 0.25;

/// What weights come to on a set of stencils.
struct LinearCount {
    std::int64_t found = 0;  ///< truth pixels of which a candidate fires
    /// Far stencils that fire on the side that fires more often, w . v >= 1 or w . v <= -1 (by a
    /// `positive` response the first): along a step each side is one pixel wide.
    std::int64_t far_positives = 0;
    std::int64_t n_truth = 0;

    /// 2 found / (found + n_truth + kFarPositiveShare far_positives); 1 if all are 0.
    [[nodiscard]] double f() const;
};

/// The count of one set of weights, which the stencils' domain contains.
///
/// With `rounding`, at most the domain's, the most that rounding may make of them: what is found if
/// it helps everywhere, and the ink that is there although it helps.
[[nodiscard]] LinearCount linear_count(const LinearStencils& stencils,
                                       const LinearWeights& weights,
                                       double rounding = 0);

/// How long to look.
struct LinearBoundOptions {
    double gap = 0.005;                ///< good enough: f_upper - f_found; 0 looks on to the end
    std::int64_t most_boxes = 100000;  ///< stop there, whatever the gap; at least 1
    int threads = 1;
    /// Weights to try first: those of a method, or of a tuner. Outside the domain they are left
    /// out.
    std::vector<LinearWeights> starts = {};
};

/// The most that any weights of a domain reach by the model's rule, enclosed from both sides. As a
/// limit of what the scorer measures it is an estimate, see linear_bound().
struct LinearBound {
    double f_upper = 1;  ///< no weights of the domain come above this
    double f_found = 0;  ///< `weights` do this
    LinearWeights weights{};
    LinearCount count;       ///< of `weights`
    std::int64_t boxes = 0;  ///< looked at

    [[nodiscard]] double gap() const { return f_upper - f_found; }
};

/// Encloses the largest LinearCount::f() over all weights of the stencils' domain.
///
/// Why that bounds what the scorer measures, F = 2K / (n_pred + n_truth) at 2 px: a matched truth
/// pixel has a drawn pixel in reach, and thinning adds none, so K <= found; drawn pixels out of
/// reach of truth and of ignored pixels are never matched, so n_pred >= K + false_positives, and F
/// <= 2K / (K + false_positives + n_truth), which grows with K. Left is false_positives >=
/// kFarPositiveShare * far_positives: that is measured (see kFarPositiveShare), not proven; all
/// else is certain but for what rounding of codes does, which the domain's `rounding` takes in.
/// Forgiven are unmatched duplicates in reach of a line, and two truth pixels that one drawn pixel
/// finds.
///
/// Branch and bound over boxes of weights: in a box a stencil can fire if the largest w . v does
/// and must fire if the smallest does; what can be found over what must be ink is an upper bound,
/// what weights from its middle make a lower one. The box with the largest upper bound is halved
/// next, along the weight that moves the most of what is undecided, and its halves look at that
/// alone. A margin covers floating point, 0.0007 of the threshold for a byte's range: lines and
/// noise that look the same to within that keep the gap open. The search also stops where what its
/// open boxes keep would fill a gigabyte. Needs no clock and no seed; the same result for every
/// thread count; more boxes never give a worse bound.
///
/// Source: Land and Doig, "An automatic method of solving discrete programming problems",
/// Econometrica 28(3), 1960.
[[nodiscard]] LinearBound linear_bound(const LinearStencils& stencils,
                                       const LinearBoundOptions& options);

}  // namespace ink::linear_code
