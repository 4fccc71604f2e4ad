#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "linear_code/linear_bound.h"

namespace ink::linear_code {

/// What a box leaves open: indices of findable truth pixels and of far pixels, ascending.
struct Undecided {
    std::vector<std::uint32_t> truth;
    std::vector<std::uint32_t> far;

    [[nodiscard]] std::size_t size() const { return truth.size() + far.size(); }
};

/// A box of weights, and what is known of all weights in it.
struct WeightBox {
    LinearWeights low{};
    LinearWeights high{};
    std::int64_t found = 0;            ///< truth pixels that all of its weights find
    std::int64_t positives_above = 0;  ///< far pixels with w . v >= 1 for all of its weights
    std::int64_t positives_below = 0;  ///< the same for w . v <= -1
    std::shared_ptr<const Undecided> undecided;
    double f_upper = 1;
    int widest = 0;  ///< the weight to halve next: the one that moves the undecided most

    /// The weights in it that are nearest to 0.
    [[nodiscard]] LinearWeights least() const;
};

/// A box just looked at, and what some weights inside it come to.
struct LookedAtBox {
    WeightBox box;
    LinearWeights tried{};  ///< the domain contains them, unless the box lies outside it
    LinearCount count;      ///< of `tried`, in floats
};

/// Works out boxes from their parents. Borrows the stencils.
class BoxCounter {
  public:
    explicit BoxCounter(const LinearStencils& stencils);

    /// The box that is the whole domain, by looking at everything.
    [[nodiscard]] LookedAtBox whole_domain() const;

    /// The two halves of `box` along its widest weight, less what lies outside the domain. For many
    /// threads at once.
    [[nodiscard]] std::array<LookedAtBox, 2> halves(const WeightBox& box) const;

  private:
    /// A box in floats: w . v lies within middle . v -+ spread(v).
    struct Probe {
        std::array<float, 4> middle{};
        std::array<float, 4> half_width{};
        std::array<float, 4> tried{};

        Probe(const WeightBox& box, const LinearWeights& weights);
        [[nodiscard]] float spread(const StencilVector& v) const;
    };
    /// How much of w . v each weight's unit moves, over all that is undecided.
    using Moves = std::array<double, 4>;

    [[nodiscard]] LookedAtBox looked_at(WeightBox box, const Undecided& undecided) const;
    void look_at_truth(const Probe& probe,
                       const std::vector<std::uint32_t>& pixels,
                       LookedAtBox& result,
                       Undecided& left) const;
    void look_at_far(const Probe& probe,
                     const std::vector<std::uint32_t>& pixels,
                     LookedAtBox& result,
                     Undecided& left) const;
    [[nodiscard]] int widest(const Probe& probe, const Undecided& left) const;
    [[nodiscard]] float sided(float response) const {
        return is_absolute_ && response < 0 ? -response : response;
    }
    [[nodiscard]] std::int64_t positives(std::int64_t above, std::int64_t below) const {
        return is_absolute_ && below > above ? below : above;
    }

    const LinearStencils& stencils_;
    bool is_absolute_;
    float can_fire_;   ///< the least w . v from which on a stencil may fire
    float must_fire_;  ///< the least w . v from which on it does
};

}  // namespace ink::linear_code
