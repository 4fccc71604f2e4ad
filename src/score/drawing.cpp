#include "score/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/error.h"
#include "edge/thin.h"
#include "score/matching.h"

namespace ink::score {
namespace {

std::int64_t count(const edge::Mask& mask) {
    return std::count(mask.data(), mask.data() + mask.size(), std::uint8_t{1});
}

/// Takes out what only an ignored pixel is in reach of.
void drop_ignored(PixelList& pixels, const TruthLists& lists) {
    if (lists.ignore.is_empty()) return;
    std::vector<std::uint8_t> is_dropped = within_reach(pixels, lists.ignore, lists.disk);
    const auto has_truth = within_reach(pixels, lists.truth, lists.disk);
    for (std::size_t i = 0; i < is_dropped.size(); ++i) {
        if (has_truth[i] != 0) is_dropped[i] = 0;
    }
    pixels.drop(is_dropped);
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

TruthLists checked_lists(const edge::EdgeImage& prediction,
                         const ScoringTruth& truth,
                         const ScoreOptions& options) {
    check(options);
    check_same_size(prediction, truth.labels);
    return list_truth(truth, options);
}

PixelList counted_pixels(edge::Mask drawn, const TruthLists& lists, const ScoreOptions& options) {
    clear_band(drawn, options.band_px);
    PixelList pixels(drawn);
    drop_ignored(pixels, lists);
    return pixels;
}

PixelList counted_pixels(const edge::BitMask& drawn,
                         const TruthLists& lists,
                         const ScoreOptions& options) {
    PixelList pixels(drawn, options.band_px);
    drop_ignored(pixels, lists);
    return pixels;
}

CurveCount match_counts(const PixelList& drawn, const TruthLists& lists) {
    return {.k = match_pixels(drawn, lists.truth, lists.disk).k,
            .n_pred = static_cast<std::int64_t>(drawn.size()),
            .n_truth = static_cast<std::int64_t>(lists.truth.size())};
}

}  // namespace ink::score
