#include "score/false_ink.h"

#include "edge/set_pixels.h"
#include "score/drawing.h"

namespace ink::score {

InkTruth prepare_ink(const ScoringTruth& truth, const ScoreOptions& options) {
    check(options);
    const TruthLists lists = list_truth(truth, options);
    edge::Mask all(truth.labels.width_px(), truth.labels.height_px(), 1);
    const PixelList counted = counted_pixels(std::move(all), lists, options);
    const auto is_near = within_reach(counted, lists.truth, lists.disk);
    InkTruth ready;
    ready.verdict = core::Image<std::uint8_t>(truth.labels.width_px(), truth.labels.height_px());
    for (int y = 0; y < counted.height_px(); ++y) {
        for (std::size_t i = counted.row_begin(y); i < counted.row_begin(y + 1); ++i) {
            ready.verdict.at(counted.x(i), y) =
                is_near[i] != 0 ? InkTruth::kNear : InkTruth::kFalse;
        }
    }
    return ready;
}

InkCount count_ink(const edge::Mask& drawn, const InkTruth& truth) {
    check_same_size(drawn, truth.verdict);
    InkCount count;
    for (int y = 0; y < drawn.height_px(); ++y) {
        const std::uint8_t* verdict = truth.verdict.row(y);
        edge::visit_set_pixels(drawn.row(y), drawn.width_px(), [&](int x) {
            count.n_drawn += verdict[x] != InkTruth::kLeftOut;
            count.n_false += verdict[x] == InkTruth::kFalse;
        });
    }
    return count;
}

}  // namespace ink::score
