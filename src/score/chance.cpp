#include "score/chance.h"

#include <algorithm>
#include <random>

namespace ink::score {

Chance::Chance(const ScoringTruth& truth, const ScoreOptions& options, std::uint64_t seed)
    : truth_(truth), options_(options), seed_(seed) {
    check(options);
    options_.thin = false;
    options_.threshold = 255;
    const int band_px = options.band_px;
    const int width = truth.labels.width_px();
    for (int y = band_px; y < truth.labels.height_px() - band_px; ++y) {
        for (int x = band_px; x < width - band_px; ++x) {
            if (truth.ignore.at(x, y) != 0) continue;
            places_.push_back(static_cast<std::uint32_t>(y * width + x));
        }
    }
}

CurveCount Chance::counts(std::int64_t n_drawn) {
    edge::EdgeImage picture(truth_.labels.width_px(), truth_.labels.height_px());
    const std::size_t n =
        std::min(places_.size(), static_cast<std::size_t>(std::max<std::int64_t>(0, n_drawn)));
    // Fisher and Yates's shuffle, as far as it is needed, undone afterwards so that the next
    // picture starts from the same order.
    std::mt19937_64 random(seed_);
    std::vector<std::size_t> swapped(n);
    for (std::size_t i = 0; i < n; ++i) {
        swapped[i] = i + static_cast<std::size_t>(random() % (places_.size() - i));
        std::swap(places_[i], places_[swapped[i]]);
        picture.data()[places_[i]] = 255;
    }
    for (std::size_t i = n; i-- > 0;)
        std::swap(places_[i], places_[swapped[i]]);
    const double tolerance_px[] = {options_.tolerance_px};
    return score_ladder(picture, truth_, options_, tolerance_px).front();
}

}  // namespace ink::score
