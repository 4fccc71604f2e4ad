#include "harness/line_scores.h"

#include "truth/cracks.h"

namespace ink::harness {
namespace {

score::ScoreOptions harness_options() {
    score::ScoreOptions options;
    options.tolerance_px = kTolerance_px;
    options.band_px = kBand_px;
    return options;
}

}  // namespace

LineTruth prepare_lines(const ViewTruth& truth) {
    const score::ScoreOptions options = harness_options();
    const auto& curves = truth.traced.curves;
    const std::vector<truth::Curve> counted =
        score::counted_curves(curves, truth.crease_rad, truth.intersections);
    const int width = truth.scoring.labels.width_px(), height = truth.scoring.labels.height_px();
    return {
        score::list_truth(truth.scoring, options),
        score::prepare_cracks(truth::draw_cracks(counted, width, height), truth.scoring, options),
        score::find_nearest_curves(curves, width, height),
        score::place_probes(counted, truth.scoring, options),
        score::prepare_positives(truth.scoring, options),
        bin_truth(truth.traced, truth.scoring)};
}

LineScores score_lines(const score::Strokes& strokes, const LineTruth& truth) {
    LineScores result;
    result.cracks = score::score_cracks(strokes.drawn, truth.cracks);
    result.widths = score::measure_widths(strokes.drawn, truth.probes);
    result.positives = score::count_positives(strokes.drawn, truth.positives);
    const score::PixelList drawn =
        score::counted_pixels(strokes.thinned, truth.lists, harness_options());
    result.offsets = score::measure_offsets(drawn, truth.nearest);
    result.bins = match_bins(drawn, truth.bins, truth.lists.disk);
    return result;
}

}  // namespace ink::harness
