#include "score/wrong_pixels.h"

#include "score/reach.h"

namespace ink::score {
namespace {

/// The pixels of `from` that are not in a mask.
std::vector<Pixel> outside(const PixelList& from, const edge::BitMask& mask) {
    std::vector<Pixel> pixels;
    for (int y = 0; y < from.height_px(); ++y) {
        for (std::size_t i = from.row_begin(y); i < from.row_begin(y + 1); ++i) {
            if (!mask.is_set(from.x(i), y)) pixels.push_back({from.x(i), y});
        }
    }
    return pixels;
}

}  // namespace

WrongPixels wrong_pixels(const Strokes& strokes,
                         const PixelList& drawn,
                         const TruthLists& lists,
                         const ScoreOptions& options) {
    const int width_px = lists.countable.width_px();
    WrongPixels wrong{
        .false_positives = outside(drawn, reach_of(lists.truth, lists.disk, width_px)),
        .false_negatives = outside(lists.truth, reach_of(drawn, lists.disk, width_px)),
        .drawn = strokes.drawn};
    clear_band(wrong.drawn, options.band_px);
    return wrong;
}

WrongPixels wrong_pixels(const Strokes& strokes,
                         const ScoringTruth& truth,
                         const ScoreOptions& options) {
    const TruthLists lists = checked_lists(strokes.drawn, truth, options);
    return wrong_pixels(strokes, counted_pixels(strokes.thinned, lists), lists, options);
}

WrongPixels wrong_pixels(const edge::EdgeImage& prediction,
                         const ScoringTruth& truth,
                         const ScoreOptions& options) {
    check(options);
    check_same_size(prediction, truth.labels);
    return wrong_pixels(make_strokes(prediction, options.threshold, options), truth, options);
}

}  // namespace ink::score
