#include "linear_code/linear_bound.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include "core/parallel.h"
#include "linear_code/linear_bound_box.h"

namespace ink::linear_code {
namespace {

/// Boxes halved at once, whatever the number of threads: which ones decides the result.
constexpr std::int64_t kBatch = 32;

/// Undecided pixels that all open boxes may keep: a gigabyte of indices.
constexpr std::size_t kMostKept = 250'000'000;

/// The least that the sizes of a box's weights come to.
double least_sum(const WeightBox& box) {
    double sum = 0;
    for (std::size_t k = 0; k < box.low.size(); ++k)
        sum += std::max({0.0, box.low[k], -box.high[k]});
    return sum;
}

struct IsLower {
    bool operator()(const WeightBox& a, const WeightBox& b) const { return a.f_upper < b.f_upper; }
};

class Search {
  public:
    Search(const LinearStencils& stencils, const LinearBoundOptions& options)
        : stencils_(stencils), options_(options), counter_(stencils) {
        bound_.f_upper = 0;
        bound_.count = linear_count(stencils, bound_.weights);
        bound_.f_found = bound_.count.f();
        for (const LinearWeights& start : options.starts) {
            if (stencils.domain().contains(start)) offer(start);
        }
        take(counter_.whole_domain());
    }

    LinearBound run() {
        while (is_worth_halving() && bound_.boxes < options_.most_boxes && kept_ < kMostKept)
            halve_batch();
        for (const WeightBox& box : open_)
            bound_.f_upper = std::max(bound_.f_upper, box.f_upper);
        bound_.f_upper = std::max(bound_.f_upper, bound_.f_found);
        return bound_;
    }

  private:
    void offer(const LinearWeights& weights) {
        const LinearCount count = linear_count(stencils_, weights);
        if (count.f() <= bound_.f_found) return;
        bound_.f_found = count.f();
        bound_.weights = weights;
        bound_.count = count;
    }

    [[nodiscard]] bool is_worth_halving() const {
        return !open_.empty() && open_.front().f_upper > bound_.f_found + options_.gap;
    }

    void halve_batch() {
        std::vector<WeightBox> batch;
        const std::int64_t most = (options_.most_boxes - bound_.boxes + 1) / 2;
        while (is_worth_halving() && std::ssize(batch) < std::min(kBatch, most)) {
            std::pop_heap(open_.begin(), open_.end(), IsLower{});
            kept_ -= open_.back().undecided->size();
            batch.push_back(std::move(open_.back()));
            open_.pop_back();
        }
        std::vector<std::array<LookedAtBox, 2>> halves(batch.size());
        core::parallel_for(batch.size(), options_.threads, [&](std::size_t i) {
            halves[i] = counter_.halves(batch[i]);
        });
        for (auto& pair : halves) {
            for (LookedAtBox& half : pair)
                take(std::move(half));
        }
    }

    void take(LookedAtBox seen) {
        ++bound_.boxes;
        if (least_sum(seen.box) > stencils_.domain().most_sum) return;
        if (seen.count.f() > bound_.f_found && stencils_.domain().contains(seen.tried))
            offer(seen.tried);
        if (seen.box.f_upper <= bound_.f_found + options_.gap) {
            bound_.f_upper = std::max(bound_.f_upper, seen.box.f_upper);
            return;
        }
        kept_ += seen.box.undecided->size();
        open_.push_back(std::move(seen.box));
        std::push_heap(open_.begin(), open_.end(), IsLower{});
    }

    const LinearStencils& stencils_;
    const LinearBoundOptions& options_;
    BoxCounter counter_;
    std::vector<WeightBox> open_;  ///< a heap, the largest f_upper first
    std::size_t kept_ = 0;         ///< undecided pixels of all of them
    LinearBound bound_;
};

}  // namespace

double LinearCount::f() const {
    const double all = static_cast<double>(found + n_truth) +
                       kFarPositiveShare * static_cast<double>(far_positives);
    return all > 0 ? 2.0 * static_cast<double>(found) / all : 1.0;
}

LinearCount linear_count(const LinearStencils& stencils,
                         const LinearWeights& weights,
                         double rounding) {
    assert(stencils.domain().contains(weights));
    const bool is_absolute = stencils.domain().response == edge::Response::absolute;
    const auto response = [&](const StencilVector& v) {
        double sum = 0;
        for (std::size_t k = 0; k < v.size(); ++k)
            sum += weights[k] * double{v[k]};
        return sum;
    };
    LinearCount count{.n_truth = stencils.n_truth()};
    const auto first = stencils.candidates().begin();
    for (std::size_t i = 0; i < stencils.findable(); ++i) {
        count.found += std::any_of(first + static_cast<std::ptrdiff_t>(stencils.begin(i)),
                                   first + static_cast<std::ptrdiff_t>(stencils.begin(i + 1)),
                                   [&](const StencilVector& v) {
                                       const double r = response(v);
                                       return (is_absolute ? std::abs(r) : r) >= 1 - rounding;
                                   });
    }
    std::int64_t above = 0;
    std::int64_t below = 0;
    for (const StencilVector& v : stencils.far()) {
        const double r = response(v);
        above += r >= 1 + rounding;
        below += -r >= 1 + rounding;
    }
    count.far_positives = is_absolute ? std::max(above, below) : above;
    return count;
}

LinearBound linear_bound(const LinearStencils& stencils, const LinearBoundOptions& options) {
    return Search(stencils, options).run();
}

}  // namespace ink::linear_code
