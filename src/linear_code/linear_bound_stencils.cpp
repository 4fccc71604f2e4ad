#include "linear_code/linear_bound_stencils.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "harness/tracing.h"
#include "score/pixel_list.h"
#include "score/wrong_pixels.h"

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

}  // namespace ink::linear_code
