#include "score/soft_score.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include "score/drawing.h"
#include "score/pixel_list.h"

namespace ink::score {
namespace {

/// The other pixels of a disk as seen from its centre, the nearest first.
struct Step {
    int dx = 0;
    int dy = 0;

    [[nodiscard]] int square() const { return dx * dx + dy * dy; }
};

std::vector<Step> steps_of(const Disk& disk) {
    std::vector<Step> steps;
    for (int dy = -disk.radius_px(); dy <= disk.radius_px(); ++dy) {
        const int half = disk.half_width_px(dy);
        for (int dx = -half; dx <= half; ++dx)
            if (dx != 0 || dy != 0) steps.push_back({dx, dy});
    }
    std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) {
        return a.square() < b.square();
    });
    return steps;
}

/// Ink that a pixel has too much.
struct Excess {
    int x = 0;
    int y = 0;
    double ink = 0;
};

/// Moves excess ink to where it lacks, the nearest first; returns how much. Of one step no two
/// moves share a pixel, so their order does not count.
double move_ink(std::vector<Excess>& excess, core::Image<double>& lack, const Disk& disk) {
    double moved = 0;
    for (const Step& step : steps_of(disk)) {
        for (Excess& from : excess) {
            const int x = from.x + step.dx;
            const int y = from.y + step.dy;
            if (from.ink <= 0 || !lack.contains(x, y)) continue;
            const double ink = std::min(from.ink, lack.at(x, y));
            if (ink <= 0) continue;
            from.ink -= ink;
            lack.at(x, y) -= ink;
            moved += ink;
        }
    }
    return moved;
}

}  // namespace

InkTruth prepare_ink(core::Image<float> coverage,
                     double line_width_px,
                     const ScoringTruth& truth,
                     const ScoreOptions& options) {
    const int width = coverage.width_px();
    const int height = coverage.height_px();
    const Disk reach(std::max(options.tolerance_px, line_width_px / 2 + 1));
    const edge::BitMask ignored = reach_of(PixelList(truth.ignore), reach);
    InkTruth ink{std::move(coverage), edge::Mask(width, height, 1), line_width_px};
    clear_band(ink.counts, options.band_px);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (ignored.is_set(x, y)) ink.counts.at(x, y) = 0;
            if (ink.counts.at(x, y) == 0) ink.coverage.at(x, y) = 0;
        }
    }
    return ink;
}

SoftScore& SoftScore::operator+=(const SoftScore& other) {
    line_width_px = other.line_width_px;
    matched_px += other.matched_px;
    misplaced_px += other.misplaced_px;
    missing_px += other.missing_px;
    surplus_px += other.surplus_px;
    return *this;
}

std::optional<double> SoftScore::f() const {
    if (true_px() <= 0) return std::nullopt;
    return 2 * matched_px / (drawn_px() + true_px());
}

CurveCount SoftScore::counts() const {
    const auto whole = [](double px) { return std::llround(std::ldexp(px, 24)); };
    return {whole(matched_px), whole(drawn_px()), whole(true_px())};
}

SoftScore score_ink(const core::Image<float>& drawn,
                    const InkTruth& truth,
                    const ScoreOptions& options) {
    const int width = truth.coverage.width_px();
    const int height = truth.coverage.height_px();
    check_same_size(drawn, truth.coverage);
    SoftScore score{.line_width_px = truth.line_width_px};
    std::vector<Excess> excess;
    core::Image<double> lack(width, height);
    double drawn_px = 0;
    double true_px = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (truth.counts.at(x, y) == 0) continue;
            const double i = drawn.at(x, y);
            const double c = truth.coverage.at(x, y);
            score.matched_px += std::min(i, c);
            drawn_px += i;
            true_px += c;
            if (i > c) excess.push_back({x, y, i - c});
            lack.at(x, y) = std::max(c - i, 0.0);
        }
    }
    score.misplaced_px = move_ink(excess, lack, Disk(options.tolerance_px));
    score.surplus_px = std::max(drawn_px - score.matched_px - score.misplaced_px, 0.0);
    score.missing_px = std::max(true_px - score.matched_px - score.misplaced_px, 0.0);
    return score;
}

core::Image<float> ink_of(const edge::EdgeImage& grey) {
    return core::mapped<float>(grey, [](int value) { return static_cast<float>(value) / 255; });
}

core::Image<float> ink_of(const edge::EdgeImage& edge_responses, int threshold) {
    return core::mapped<float>(edge_responses,
                               [=](int value) { return value >= threshold ? 1.0F : 0.0F; });
}

}  // namespace ink::score
