#include "score/random_baseline.h"

#include <algorithm>
#include <random>

namespace ink::score {

RandomBaseline::RandomBaseline(const ScoringTruth& truth,
                               const ScoreOptions& options,
                               std::uint64_t seed)
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

CurveCount RandomBaseline::counts(std::int64_t n_drawn) const {
    edge::EdgeImage image(truth_.labels.width_px(), truth_.labels.height_px());
    const std::size_t n =
        std::min(places_.size(), static_cast<std::size_t>(std::max<std::int64_t>(0, n_drawn)));
    std::mt19937_64 random(seed_);
    // Floyd's sampling without replacement (Bentley and Floyd, CACM 30(9), 1987): a place that is
    // drawn again gives way to the newest, which cannot have been drawn yet.
    for (std::size_t newest = places_.size() - n; newest < places_.size(); ++newest) {
        const auto any = static_cast<std::size_t>(random() % (newest + 1));
        const bool is_taken = image.data()[places_[any]] != 0;
        image.data()[places_[is_taken ? newest : any]] = 255;
    }
    const double tolerance_px[] = {options_.tolerance_px};
    return score_tolerance_sweep(image, truth_, options_, tolerance_px).front();
}

}  // namespace ink::score
