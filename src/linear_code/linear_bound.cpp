#include "linear_code/linear_bound.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include "core/parallel.h"
#include "harness/tracing.h"
#include "linear_code/linear_bound_box.h"
#include "score/attribution.h"
#include "score/pixel_list.h"

namespace ink::linear_code {
namespace {

float largest(const StencilVector& v) {
    float most = 0;
    for (const float part : v)
        most = std::max(most, std::abs(part));
    return most;
}

/// Calls `visit(x, y)` for the pixels within the tolerance of (x_px, y_px), inside the band.
template <class Visit>
void visit_disk(const score::Disk& disk, const edge::Mask& image, score::Pixel p, Visit visit) {
    const int radius = disk.radius_px();
    const int y_last = std::min(p.y_px + radius, image.height_px() - harness::kBand_px - 1);
    for (int y = std::max(p.y_px - radius, harness::kBand_px); y <= y_last; ++y) {
        const int half = disk.half_width_px(y - p.y_px);
        const int x_last = std::min(p.x_px + half, image.width_px() - harness::kBand_px - 1);
        for (int x = std::max(p.x_px - half, harness::kBand_px); x <= x_last; ++x)
            visit(x, y);
    }
}

StencilVector stencil_at(const ChannelPlanes& planes, int x, int y) {
    StencilVector v{};
    for (std::size_t k = 0; k < v.size(); ++k) {
        const core::Image<float>& c = planes.channels[k];
        v[k] = 4 * c.at(x, y) - c.at(x - 1, y) - c.at(x + 1, y) - c.at(x, y - 1) - c.at(x, y + 1);
    }
    return v;
}

/// Boxes halved at once, whatever the number of threads: which ones decides the result.
constexpr std::int64_t kBatch = 32;

/// Undecided pixels that all open boxes may keep: a gigabyte of indices.
constexpr std::size_t kMostKept = 250'000'000;

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
        if (sum_of_sizes(seen.box.least()) > stencils_.domain().most_sum) return;
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

bool LinearStencils::can_fire(const StencilVector& v) const {
    return domain_.most_sum * largest(v) >= 1 - kParallelStencils - domain_.rounding;
}

/// Whether `v` fires, within kParallelStencils, only where `by` does.
bool LinearStencils::is_dominated(const StencilVector& v, const StencilVector& by) const {
    double v_by = 0;
    double by_by = 0;
    for (std::size_t k = 0; k < v.size(); ++k) {
        v_by += double{v[k]} * by[k];
        by_by += double{by[k]} * by[k];
    }
    const bool is_absolute = domain_.response == edge::Response::absolute;
    const double times = by_by > 0 ? std::clamp(v_by / by_by, is_absolute ? -1.0 : 0.0, 1.0) : 0;
    double rest = 0;
    for (std::size_t k = 0; k < v.size(); ++k)
        rest = std::max(rest, std::abs(v[k] - times * by[k]));
    if (domain_.most_sum * rest <= kParallelStencils) return true;
    if (domain_.is_signed) return false;
    // No weight is negative: a stencil that is larger in every channel gives more.
    bool is_above = true;
    bool is_below = is_absolute;
    for (std::size_t k = 0; k < v.size(); ++k) {
        const float size = is_absolute ? std::abs(v[k]) : v[k];
        is_above = is_above && by[k] >= size;
        is_below = is_below && -by[k] >= size;
    }
    return is_above || is_below;
}

void LinearStencils::add_truth_pixel(std::vector<StencilVector> candidates) {
    ++n_truth_;
    std::erase_if(candidates, [&](const StencilVector& v) { return !can_fire(v); });
    std::stable_sort(
        candidates.begin(), candidates.end(), [](const StencilVector& a, const StencilVector& b) {
            return largest(a) > largest(b);
        });
    const std::size_t first = candidates_.size();
    for (const StencilVector& v : candidates) {
        const auto kept = candidates_.begin() + static_cast<std::ptrdiff_t>(first);
        const bool is_spare = std::any_of(
            kept, candidates_.end(), [&](const StencilVector& by) { return is_dominated(v, by); });
        if (!is_spare) candidates_.push_back(v);
    }
    if (candidates_.size() > first) begin_.push_back(candidates_.size());
}

void LinearStencils::add_far_pixel(const StencilVector& v) {
    if (can_fire(v)) far_.push_back(v);
}

void LinearStencils::add(const ChannelPlanes& planes, const score::ScoringTruth& truth) {
    const int width = planes.width_px();
    const int height = planes.height_px();
    assert(truth.labels.width_px() == width && truth.labels.height_px() == height);
    const score::Disk disk(harness::kTolerance_px);
    edge::Mask is_free(width, height);  // of truth and ignored pixels in reach
    std::vector<StencilVector> candidates;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool is_truth = truth.labels.at(x, y) != 0;
            if (!is_truth && truth.ignore.at(x, y) == 0) continue;
            candidates.clear();
            visit_disk(disk, is_free, {x, y}, [&](int u, int v) {
                is_free.at(u, v) = 1;
                if (is_truth) candidates.push_back(stencil_at(planes, u, v));
            });
            if (is_truth) add_truth_pixel(candidates);
        }
    }
    for (int y = harness::kBand_px; y < height - harness::kBand_px; ++y) {
        for (int x = harness::kBand_px; x < width - harness::kBand_px; ++x) {
            if (is_free.at(x, y) == 0) add_far_pixel(stencil_at(planes, x, y));
        }
    }
}

void LinearStencils::add(const LinearStencils& others) {
    const std::size_t shift = candidates_.size();
    candidates_.insert(candidates_.end(), others.candidates_.begin(), others.candidates_.end());
    for (std::size_t i = 1; i < others.begin_.size(); ++i)
        begin_.push_back(others.begin_[i] + shift);
    far_.insert(far_.end(), others.far_.begin(), others.far_.end());
    n_truth_ += others.n_truth_;
}

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
