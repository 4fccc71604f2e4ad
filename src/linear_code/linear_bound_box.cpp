#include "linear_code/linear_bound_box.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace ink::linear_code {
namespace {

/// How far the threshold must give way, over the threshold: to rounding of codes, to stencils that
/// were taken for parallel, and to floats. A sum of four products of weights (at most `most_sum` in
/// all) and Laplacians of 0..1 (at most 4) is off by 20 half units in the last place, and so is the
/// spread.
double margin(const WeightDomain& domain) {
    constexpr double kHalfUnit = 0x1p-24;
    return domain.rounding + kParallelStencils + 50 * kHalfUnit * domain.most_sum;
}

/// Cuts off what no weights of the domain reach.
void cut_to_domain(WeightBox& box, double most_sum) {
    const LinearWeights least = box.least();
    const double spare = std::max(0.0, most_sum - sum_of_sizes(least));
    for (std::size_t k = 0; k < least.size(); ++k) {
        const double most = std::abs(least[k]) + spare;
        box.low[k] = std::max(box.low[k], -most);
        box.high[k] = std::min(box.high[k], most);
    }
}

/// The middle of a box, or what lies between it and the box's least weights inside the domain.
LinearWeights weights_to_try(const WeightBox& box, double most_sum) {
    const LinearWeights least = box.least();
    LinearWeights middle;
    for (std::size_t k = 0; k < middle.size(); ++k)
        middle[k] = (box.low[k] + box.high[k]) / 2;
    // Sizes grow evenly from the one to the other.
    const double from = sum_of_sizes(least);
    const double to = sum_of_sizes(middle);
    if (to <= most_sum) return middle;
    const double way = std::max(0.0, 0.999 * (most_sum - from) / (to - from));
    for (std::size_t k = 0; k < middle.size(); ++k)
        middle[k] = least[k] + way * (middle[k] - least[k]);
    return middle;
}

float product(const std::array<float, 4>& w, const StencilVector& v) {
    return w[0] * v[0] + w[1] * v[1] + w[2] * v[2] + w[3] * v[3];
}

std::array<float, 4> as_floats(const LinearWeights& weights) {
    std::array<float, 4> floats{};
    for (std::size_t k = 0; k < floats.size(); ++k)
        floats[k] = static_cast<float>(weights[k]);
    return floats;
}

}  // namespace

LinearWeights WeightBox::least() const {
    LinearWeights least;
    for (std::size_t k = 0; k < least.size(); ++k)
        least[k] = std::clamp(0.0, low[k], high[k]);
    return least;
}

BoxCounter::Probe::Probe(const WeightBox& box, const LinearWeights& weights)
    : tried(as_floats(weights)) {
    for (std::size_t k = 0; k < middle.size(); ++k) {
        middle[k] = static_cast<float>((box.low[k] + box.high[k]) / 2);
        half_width[k] = static_cast<float>((box.high[k] - box.low[k]) / 2);
    }
}

float BoxCounter::Probe::spread(const StencilVector& v) const {
    return half_width[0] * std::abs(v[0]) + half_width[1] * std::abs(v[1]) +
           half_width[2] * std::abs(v[2]) + half_width[3] * std::abs(v[3]);
}

BoxCounter::BoxCounter(const LinearStencils& stencils)
    : stencils_(stencils),
      is_absolute_(stencils.domain().response == edge::Response::absolute),
      can_fire_(1 - static_cast<float>(margin(stencils.domain()))),
      must_fire_(1 + static_cast<float>(margin(stencils.domain()))) {}

void BoxCounter::look_at_truth(const Probe& probe,
                               const std::vector<std::uint32_t>& pixels,
                               LookedAtBox& result,
                               Undecided& left) const {
    const std::vector<StencilVector>& candidates = stencils_.candidates();
    for (const std::uint32_t i : pixels) {
        bool must = false;
        bool fires = false;
        bool can = false;
        for (std::size_t c = stencils_.begin(i); c < stencils_.begin(i + 1); ++c) {
            const float middle = sided(product(probe.middle, candidates[c]));
            const float spread = probe.spread(candidates[c]);
            fires = fires || sided(product(probe.tried, candidates[c])) >= 1;
            must = must || middle - spread >= must_fire_;
            can = can || middle + spread >= can_fire_;
        }
        result.count.found += fires;
        result.box.found += must;
        if (can && !must) left.truth.push_back(i);
    }
}

void BoxCounter::look_at_far(const Probe& probe,
                             const std::vector<std::uint32_t>& pixels,
                             LookedAtBox& result,
                             Undecided& left) const {
    std::int64_t above = result.box.positives_above;
    std::int64_t below = result.box.positives_below;
    for (const std::uint32_t i : pixels) {
        const StencilVector& v = stencils_.far()[i];
        const float tried = product(probe.tried, v);
        above += tried >= 1;
        below += -tried >= 1;
        const float middle = product(probe.middle, v);
        const float spread = probe.spread(v);
        const bool must_above = middle - spread >= must_fire_;
        const bool must_below = -middle - spread >= must_fire_;
        result.box.positives_above += must_above;
        result.box.positives_below += must_below;
        const bool can = sided(middle) + spread >= can_fire_;
        if (can && !must_above && !must_below) left.far.push_back(i);
    }
    result.count.far_positives = positives(above, below);
}

/// A sample will do to choose by: every 16th of what is undecided.
int BoxCounter::widest(const Probe& probe, const Undecided& left) const {
    constexpr std::size_t kStep = 16;
    std::array<double, 4> moved{};
    const auto add = [&](const StencilVector& v) {
        for (std::size_t k = 0; k < moved.size(); ++k)
            moved[k] += double{probe.half_width[k]} * double{std::abs(v[k])};
    };
    for (std::size_t i = 0; i < left.truth.size(); i += kStep)
        add(stencils_.candidates()[stencils_.begin(left.truth[i])]);
    for (std::size_t i = 0; i < left.far.size(); i += kStep)
        add(stencils_.far()[left.far[i]]);
    return static_cast<int>(std::max_element(moved.begin(), moved.end()) - moved.begin());
}

LookedAtBox BoxCounter::looked_at(WeightBox box, const Undecided& undecided) const {
    const double most_sum = stencils_.domain().most_sum;
    cut_to_domain(box, most_sum);
    LookedAtBox result;
    result.tried = weights_to_try(box, most_sum);
    const Probe probe(box, result.tried);
    result.count = {.found = box.found, .n_truth = stencils_.n_truth()};
    result.box = std::move(box);
    auto left = std::make_shared<Undecided>();
    look_at_truth(probe, undecided.truth, result, *left);
    look_at_far(probe, undecided.far, result, *left);

    const LinearCount most{
        .found = result.box.found + std::ssize(left->truth),
        .far_positives = positives(result.box.positives_above, result.box.positives_below),
        .n_truth = stencils_.n_truth()};
    result.box.f_upper = std::min(result.box.f_upper, most.f());
    result.box.widest = widest(probe, *left);
    result.box.undecided = std::move(left);
    return result;
}

LookedAtBox BoxCounter::whole_domain() const {
    const WeightDomain& domain = stencils_.domain();
    WeightBox box;
    box.high.fill(domain.most_sum);
    if (domain.is_signed) box.low.fill(-domain.most_sum);
    // Weights turned about draw the same |w . v|: half of them will do.
    if (domain.is_signed && is_absolute_) box.low[0] = 0;
    Undecided all;
    all.truth.resize(stencils_.findable());
    std::iota(all.truth.begin(), all.truth.end(), 0U);
    all.far.resize(stencils_.far().size());
    std::iota(all.far.begin(), all.far.end(), 0U);
    return looked_at(box, all);
}

std::array<LookedAtBox, 2> BoxCounter::halves(const WeightBox& box) const {
    const auto k = static_cast<std::size_t>(box.widest);
    WeightBox low = box;
    WeightBox high = box;
    low.undecided = high.undecided = nullptr;
    low.high[k] = high.low[k] = (box.low[k] + box.high[k]) / 2;
    return {looked_at(std::move(low), *box.undecided), looked_at(std::move(high), *box.undecided)};
}

}  // namespace ink::linear_code
