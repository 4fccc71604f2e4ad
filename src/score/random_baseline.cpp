#include "score/random_baseline.h"

#include <algorithm>
#include <random>
#include <utility>

namespace ink::score {

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
