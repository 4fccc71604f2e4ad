#include "score/line_width.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "score/drawing.h"

namespace ink::score {
namespace {

constexpr double kReach_px = 2;
constexpr double kFurthest_px = 8;

// A normal that meets a corner of the grid goes on into the pixel opposite.
constexpr double kCorner_px = 1e-9;

/// Follows a ray through the pixels, one after the other (Amanatides and Woo 1987).
class PixelWalk {
  public:
    PixelWalk(double x, double y, double toward_x, double toward_y)
        : x_(static_cast<int>(std::floor(x))), y_(static_cast<int>(std::floor(y))) {
        start(x - x_, toward_x, step_x_, next_x_, every_x_);
        start(y - y_, toward_y, step_y_, next_y_, every_y_);
    }

    [[nodiscard]] int x() const { return x_; }
    [[nodiscard]] int y() const { return y_; }
    /// How far along the ray this pixel ends.
    [[nodiscard]] double end_px() const { return std::min(next_x_, next_y_); }

    void advance() {
        const double here = end_px() + kCorner_px;
        if (next_x_ <= here) {
            x_ += step_x_;
            next_x_ += every_x_;
        }
        if (next_y_ <= here) {
            y_ += step_y_;
            next_y_ += every_y_;
        }
    }

  private:
    /// One axis: where in its pixel the ray starts (0..1) and how fast it goes.
    static void start(double inside, double toward, int& step, double& next, double& every) {
        constexpr double kNever = std::numeric_limits<double>::infinity();
        step = toward > 0 ? 1 : -1;
        every = toward != 0 ? 1 / std::abs(toward) : kNever;
        next = toward != 0 ? (toward > 0 ? 1 - inside : inside) * every : kNever;
    }

    int x_, y_;
    int step_x_ = 0, step_y_ = 0;
    double next_x_ = 0, next_y_ = 0;
    double every_x_ = 0, every_y_ = 0;
};

/// The first drawn piece of a ray: from where to where; begin is beyond the reach if there is none.
struct Piece {
    double begin_px = std::numeric_limits<double>::infinity();
    double end_px = 0;
};

Piece first_piece(const edge::Mask& drawn, PixelWalk walk) {
    const auto is_drawn = [&] {
        return drawn.contains(walk.x(), walk.y()) && drawn.at(walk.x(), walk.y()) != 0;
    };
    Piece piece;
    double at = 0;
    while (!is_drawn()) {
        at = walk.end_px();
        if (at > kReach_px) return piece;
        walk.advance();
    }
    piece.begin_px = at;
    while (is_drawn() && at < kFurthest_px) {
        at = walk.end_px();
        walk.advance();
    }
    piece.end_px = at;
    return piece;
}

void measure(const edge::Mask& drawn, const WidthProbe& probe, Widths& widths) {
    const Piece ahead =
        first_piece(drawn, {probe.x_px, probe.y_px, probe.normal_x, probe.normal_y});
    const Piece behind =
        first_piece(drawn, {probe.x_px, probe.y_px, -probe.normal_x, -probe.normal_y});
    const Piece& nearer = ahead.begin_px <= behind.begin_px ? ahead : behind;
    if (std::isinf(nearer.begin_px)) {
        ++widths.n_missed;
        return;
    }
    // If the probe's own pixel is drawn both pieces begin at the probe and are one.
    const bool is_both = ahead.begin_px == 0 && behind.begin_px == 0;
    const double end_px = is_both ? std::max(ahead.end_px, behind.end_px) : nearer.end_px;
    if (end_px >= kFurthest_px) {
        ++widths.n_open;
        return;
    }
    const double width_px =
        is_both ? ahead.end_px + behind.end_px : nearer.end_px - nearer.begin_px;
    widths.all.add(width_px);
    widths.classes[probe.label & 7U].add(width_px);
}

}  // namespace

std::vector<WidthProbe> place_probes(std::span<const truth::Curve> curves,
                                     const ScoringTruth& truth,
                                     const ScoreOptions& options) {
    edge::Mask counts(truth.labels.width_px(), truth.labels.height_px(), 1);
    clear_band(counts, options.band_px);
    std::vector<WidthProbe> probes;
    double next_px = 0.5;  // along what is left of all curves
    for (const truth::Curve& curve : curves) {
        const double dx = curve.end.x_px - curve.begin.x_px;
        const double dy = curve.end.y_px - curve.begin.y_px;
        const double length_px = std::hypot(dx, dy);
        for (; next_px < length_px; next_px += 1) {
            const double s = next_px / length_px;
            const WidthProbe probe{curve.begin.x_px + s * dx,
                                   curve.begin.y_px + s * dy,
                                   -dy / length_px,
                                   dx / length_px,
                                   static_cast<std::uint8_t>(curve.line_class)};
            const int x = static_cast<int>(std::floor(probe.x_px));
            const int y = static_cast<int>(std::floor(probe.y_px));
            if (!counts.contains(x, y) || counts.at(x, y) == 0) continue;
            if (truth.ignore.at(x, y) == 0) probes.push_back(probe);
        }
        next_px -= length_px;
    }
    return probes;
}

Widths measure_widths(const edge::Mask& drawn, std::span<const WidthProbe> probes) {
    Widths widths;
    for (const WidthProbe& probe : probes)
        measure(drawn, probe, widths);
    return widths;
}

}  // namespace ink::score
