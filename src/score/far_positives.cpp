#include "score/far_positives.h"

#include <algorithm>

#include "edge/set_pixels.h"
#include "score/drawing.h"

namespace ink::score {
namespace {

static_assert(PositiveTruth::kLeftOut == 0, "clear_band leaves out what it clears");

/// Sets what lies within the disk of a pixel to `value`.
void mark_disks(const PixelList& pixels,
                const Disk& disk,
                std::uint8_t value,
                core::Image<std::uint8_t>& image) {
    const int radius = disk.radius_px();
    pixels.visit([&](int x, int y) {
        const int last_row = std::min(image.height_px() - 1, y + radius);
        for (int v = std::max(0, y - radius); v <= last_row; ++v) {
            const int half_width = disk.half_width_px(v - y);
            const int first = std::max(0, x - half_width);
            const int last = std::min(image.width_px() - 1, x + half_width);
            std::fill(image.row(v) + first, image.row(v) + last + 1, value);
        }
    });
}

}  // namespace

PositiveTruth prepare_positives(const ScoringTruth& truth, const ScoreOptions& options) {
    check(options);
    const TruthLists lists = list_truth(truth, options);
    PositiveTruth ready;
    ready.verdict = core::Image<std::uint8_t>(
        truth.labels.width_px(), truth.labels.height_px(), PositiveTruth::kFalse);
    mark_disks(lists.ignore, lists.disk, PositiveTruth::kLeftOut, ready.verdict);
    mark_disks(lists.truth, lists.disk, PositiveTruth::kNear, ready.verdict);
    clear_band(ready.verdict, options.band_px);
    return ready;
}

PositiveCount count_positives(const edge::Mask& drawn, const PositiveTruth& truth) {
    check_same_size(drawn, truth.verdict);
    PositiveCount count;
    edge::visit_set_pixels(drawn, [&](int x, int y) {
        const std::uint8_t verdict = truth.verdict.at(x, y);
        count.n_drawn += verdict != PositiveTruth::kLeftOut;
        count.n_false += verdict == PositiveTruth::kFalse;
    });
    return count;
}

}  // namespace ink::score
