#include "score/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/error.h"
#include "edge/thin.h"

namespace ink::score {
namespace {

std::int64_t count(const edge::Mask& mask) {
    return std::count(mask.data(), mask.data() + mask.size(), std::uint8_t{1});
}

}  // namespace

void check_same_size(const edge::EdgeImage& prediction, const core::Image<std::uint8_t>& truth) {
    if (prediction.width_px() == truth.width_px() && prediction.height_px() == truth.height_px()) {
        return;
    }
    throw core::Error("score",
                      fmt::format("the prediction is {} x {} px and the truth {} x {} px",
                                  prediction.width_px(),
                                  prediction.height_px(),
                                  truth.width_px(),
                                  truth.height_px()),
                      "two pictures of one size");
}

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
    strokes.thinned = options.thin ? edge::thin(strokes.drawn) : strokes.drawn;
    strokes.n_drawn = count(strokes.drawn);
    strokes.n_thinned = options.thin ? count(strokes.thinned) : strokes.n_drawn;
    return strokes;
}

TruthLists list_truth(const ScoringTruth& truth, const ScoreOptions& options) {
    return {PixelList(truth.labels), PixelList(truth.ignore), Disk(options.tolerance_px)};
}

PixelList counted_pixels(edge::Mask drawn, const TruthLists& lists, const ScoreOptions& options) {
    clear_band(drawn, options.band_px);
    PixelList pixels(drawn);
    if (lists.ignore.is_empty()) return pixels;
    std::vector<std::uint8_t> is_dropped = within_reach(pixels, lists.ignore, lists.disk);
    const auto has_truth = within_reach(pixels, lists.truth, lists.disk);
    for (std::size_t i = 0; i < is_dropped.size(); ++i) {
        if (has_truth[i] != 0) is_dropped[i] = 0;
    }
    pixels.drop(is_dropped);
    return pixels;
}

}  // namespace ink::score
