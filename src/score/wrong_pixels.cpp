#include "score/wrong_pixels.h"

#include <utility>

namespace ink::score {
namespace {

/// The pixels of `from` that have none of `to` in reach.
std::vector<Pixel> out_of_reach(const PixelList& from, const PixelList& to, const Disk& disk) {
    const std::vector<std::uint8_t> is_reached = within_reach(from, to, disk);
    std::vector<Pixel> pixels;
    for (int y = 0; y < from.height_px(); ++y) {
        for (std::size_t i = from.row_begin(y); i < from.row_begin(y + 1); ++i) {
            if (is_reached[i] == 0) pixels.push_back({from.x(i), y});
        }
    }
    return pixels;
}

}  // namespace

WrongPixels wrong_pixels(const Strokes& strokes,
                         const ScoringTruth& truth,
                         const ScoreOptions& options) {
    check(options);
    check_same_size(strokes.drawn, truth.labels);
    const TruthLists lists = list_truth(truth, options);
    const PixelList counted = counted_pixels(strokes.thinned, lists, options);
    edge::Mask drawn = strokes.drawn;
    clear_band(drawn, options.band_px);
    return {.false_positives = out_of_reach(counted, lists.truth, lists.disk),
            .false_negatives = out_of_reach(lists.truth, counted, lists.disk),
            .drawn = std::move(drawn)};
}

WrongPixels wrong_pixels(const edge::EdgeImage& prediction,
                         const ScoringTruth& truth,
                         const ScoreOptions& options) {
    check(options);
    check_same_size(prediction, truth.labels);
    return wrong_pixels(make_strokes(prediction, options.threshold, options), truth, options);
}

}  // namespace ink::score
