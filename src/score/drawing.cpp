#include "score/drawing.h"

#include <algorithm>
#include <random>
#include <utility>

#include "edge/thin.h"
#include "score/matching.h"
#include "score/pixel_list.h"

namespace ink::score {
namespace {

std::vector<ClassPixels> classes_of(const ScoringTruth& truth) {
    std::vector<ClassPixels> classes;
    if (truth.is_binary) return classes;
    for (const std::uint8_t label : truth.labels_in_use)
        classes.push_back({label, PixelList(truth.labels, label)});
    return classes;
}

}  // namespace

void clear_band(core::Image<std::uint8_t>& image, int band_px) {
    const int width = image.width_px();
    const int height = image.height_px();
    for (int y = 0; y < height; ++y) {
        std::uint8_t* row = image.row(y);
        const bool is_all = y < band_px || y >= height - band_px;
        const int side = is_all ? width : std::min(band_px, width);
        std::fill(row, row + side, std::uint8_t{0});
        std::fill(row + width - side, row + width, std::uint8_t{0});
    }
}

Strokes make_strokes(const edge::EdgeImage& prediction,
                     int threshold,
                     const ScoreOptions& options) {
    Strokes strokes;
    strokes.drawn = edge::threshold(prediction, threshold);
    strokes.thinned = edge::BitMask(strokes.drawn);
    strokes.n_drawn = strokes.thinned.count();
    if (options.thin) edge::thin(strokes.thinned);
    strokes.n_thinned = options.thin ? strokes.thinned.count() : strokes.n_drawn;
    return strokes;
}

TruthLists list_truth(const ScoringTruth& truth, const ScoreOptions& options) {
    TruthLists lists{
        PixelList(truth.labels), PixelList(truth.ignore), Disk(options.tolerance_px), {}, {}};
    lists.countable = countable_pixels(lists.truth, lists.ignore, lists.disk, options.band_px);
    lists.classes = classes_of(truth);
    return lists;
}

TruthLists checked_lists(const edge::EdgeImage& prediction,
                         const ScoringTruth& truth,
                         const ScoreOptions& options) {
    check(options);
    check_same_size(prediction, truth.labels);
    return list_truth(truth, options);
}

PixelList counted_pixels(edge::BitMask drawn, const TruthLists& lists) {
    check_same_size(drawn, lists.countable);
    for (std::size_t i = 0; i < drawn.words().size(); ++i)
        drawn.words()[i] &= lists.countable.words()[i];
    return {drawn, 0};
}

CurveCount match_counts(const PixelList& drawn, const TruthLists& lists) {
    return {.k = DrawnMatcher(drawn, lists.disk).match(lists.truth),
            .n_pred = static_cast<std::int64_t>(drawn.size()),
            .n_truth = static_cast<std::int64_t>(lists.truth.size())};
}

RandomBaseline::RandomBaseline(const ScoringTruth& truth,
                               const ScoreOptions& options,
                               std::uint64_t seed)
    : lists_((check(options), list_truth(truth, options))), seed_(seed) {
    const int band_px = options.band_px;
    const int width = truth.labels.width_px();
    for (int y = band_px; y < truth.labels.height_px() - band_px; ++y) {
        for (int x = band_px; x < width - band_px; ++x) {
            if (truth.ignore.at(x, y) != 0) continue;
            places_.push_back(static_cast<std::uint32_t>(y * width + x));
        }
    }
}

CurveCount RandomBaseline::counts(std::int64_t n_drawn) const {
    const int width_px = lists_.countable.width_px();
    edge::BitMask drawn(width_px, lists_.countable.height_px());
    const auto x_of = [&](std::uint32_t place) { return static_cast<int>(place) % width_px; };
    const auto y_of = [&](std::uint32_t place) { return static_cast<int>(place) / width_px; };
    const std::size_t n =
        std::min(places_.size(), static_cast<std::size_t>(std::max<std::int64_t>(0, n_drawn)));
    std::mt19937_64 random(seed_);
    // Floyd's sampling without replacement (Bentley and Floyd, CACM 30(9), 1987): a place that is
    // drawn again gives way to the newest, which cannot have been drawn yet.
    for (std::size_t newest = places_.size() - n; newest < places_.size(); ++newest) {
        const auto any = static_cast<std::size_t>(random() % (newest + 1));
        const bool is_taken = drawn.is_set(x_of(places_[any]), y_of(places_[any]));
        const std::uint32_t place = places_[is_taken ? newest : any];
        drawn.set(x_of(place), y_of(place));
    }
    return match_counts(counted_pixels(std::move(drawn), lists_), lists_);
}

}  // namespace ink::score
