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

}  // namespace ink::linear_code
