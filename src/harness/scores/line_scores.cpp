#include "harness/scores/line_scores.h"

#include "score/drawn_matcher.h"
#include "truth/cracks.h"

namespace ink::harness {
namespace {

score::ScoreOptions harness_options() {
    return {.tolerance_px = kTolerance_px, .band_px = kBand_px};
}

}  // namespace

LineTruth prepare_lines(const ViewTruth& truth) {
    const score::ScoreOptions options = harness_options();
    const auto& curves = truth.traced.curves;
    const std::vector<truth::Curve> counted =
        score::counted_curves(curves, truth.crease_rad, truth.intersections);
    const int width = truth.scoring.labels.width_px(), height = truth.scoring.labels.height_px();
    return {
        score::Disk(options.tolerance_px),
        width,
        score::prepare_cracks(truth::draw_cracks(counted, width, height), truth.scoring, options),
        score::find_nearest_curves(curves, width, height),
        score::place_probes(counted, truth.scoring, options),
        score::prepare_positives(truth.scoring, options),
        bin_truth(truth.traced, truth.scoring)};
}

LineScores score_lines(const score::Strokes& strokes,
                       const score::PixelList& counted,
                       const LineTruth& truth) {
    LineScores result;
    result.cracks = score::score_cracks(strokes.drawn, truth.cracks);
    result.widths = score::measure_widths(strokes.drawn, truth.probes);
    result.positives = score::count_positives(strokes.drawn, truth.positives);
    result.offsets = score::measure_offsets(counted, truth.nearest);
    score::DrawnMatcher matcher(counted, truth.disk, truth.width_px);
    result.bins = match_bins(matcher, truth.bins);
    return result;
}

}  // namespace ink::harness
