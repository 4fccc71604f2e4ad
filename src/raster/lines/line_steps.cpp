#include "raster/lines/line_steps.h"

#include <algorithm>
#include <cstdlib>

namespace ink::raster {
namespace {

constexpr std::int64_t kHalf = kSubpixels / 2;

}  // namespace

LineSteps::LineSteps(const ScreenVertex& a,
                     const ScreenVertex& b,
                     int width_px,
                     bool is_both_ways) {
    const std::int64_t dx = static_cast<std::int64_t>(b.x) - a.x;
    const std::int64_t dy = static_cast<std::int64_t>(b.y) - a.y;
    is_x_major_ = std::abs(dx) >= std::abs(dy);
    const std::int64_t along = is_x_major_ ? dx : dy;
    if (along == 0) return;

    const std::int64_t run = std::abs(along);
    const bool is_upwards = along > 0;
    rise_ = (is_x_major_ ? dy : dx) * (is_upwards ? 1 : -1);
    divisor_ = kSubpixels * run;
    const Point from = point(is_upwards ? a : b);
    const Point to = point(is_upwards ? b : a);
    at_zero_ = from.across * run + (kHalf - from.along) * rise_;
    // Exactly between two pixels: (-e, +e^2) in the image takes a line that falls to the right,
    // or is level, down; one that rises to the right up; and one that is y-major left.
    if (!is_x_major_ || rise_ < 0) at_zero_ -= 1;
    begin_ = bound(from, is_upwards);
    end_ = bound(to, is_upwards);
    if (is_both_ways) {
        const int begin = bound(from, !is_upwards);
        const int end = bound(to, !is_upwards);
        const bool has_none = begin_ >= end_;
        if (begin < end) begin_ = has_none ? begin : std::min(begin_, begin);
        if (begin < end) end_ = has_none ? end : std::max(end_, end);
    }

    // The image's y runs down: OpenGL's line is moved down here, its runs go up from there.
    below_ = is_x_major_ ? width_px - 1 : 0;
    at_zero_ += (is_x_major_ ? kHalf : -kHalf) * (width_px - 1) * run;
}

LineSteps::Point LineSteps::point(const ScreenVertex& v) const {
    return is_x_major_ ? Point{v.x, v.y} : Point{v.y, v.x};
}

/// Between which steps an end lies: before the one returned. A line that starts in a diamond draws
/// it, one that ends in it does not; so at both ends the diamond belongs to what comes after.
int LineSteps::bound(const Point& p, bool is_upwards) {
    // The first step whose centre is not before p: x is moved by -e, the image's y by +e^2.
    const std::int64_t at = is_x_major_ ? floor_div(p.along + kHalf - 1, kSubpixels)
                                        : floor_div(p.along + kHalf, kSubpixels);
    const int step = static_cast<int>(at);
    if (is_upwards) return step - (is_in_diamond(p, step - 1) ? 1 : 0);
    return step + (is_in_diamond(p, step) ? 1 : 0);
}

bool LineSteps::is_in_diamond(const Point& p, int step) {
    const std::int64_t along = p.along - (std::int64_t{step} * kSubpixels + kHalf);
    if (std::abs(along) > kHalf) return false;
    start(step);
    const std::int64_t across = p.across - (std::int64_t{quotient_} * kSubpixels + kHalf);
    const std::int64_t distance = std::abs(along) + std::abs(across);
    const std::int64_t x = is_x_major_ ? along : across;
    return distance < kHalf || (distance == kHalf && x > 0);
}

void LineSteps::start(int step) {
    const std::int64_t value = at_zero_ + step * (kSubpixels * rise_);
    const std::int64_t quotient = floor_div(value, divisor_);
    quotient_ = static_cast<int>(quotient);
    remainder_ = value - quotient * divisor_;
}

}  // namespace ink::raster
