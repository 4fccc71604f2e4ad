#include "score/score.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "edge/thin.h"
#include "score/drawing.h"
#include "score/matching.h"
#include "score/pixel_list.h"

namespace ink::score {
namespace {

/// Moves the ignore label from the labels to a mask of its own.
edge::Mask take_out_ignore(core::Image<std::uint8_t>& labels, std::optional<int> ignore_label) {
    if (!ignore_label) return {labels.width_px(), labels.height_px()};
    edge::Mask ignore = core::mapped<std::uint8_t>(
        labels, [&](int label) { return static_cast<std::uint8_t>(label == *ignore_label); });
    std::replace(labels.data(),
                 labels.data() + labels.size(),
                 static_cast<std::uint8_t>(*ignore_label),
                 std::uint8_t{0});
    return ignore;
}

/// Takes from the labels what thinning takes from their union.
void thin_labels(core::Image<std::uint8_t>& labels) {
    const edge::Mask kept = edge::thin(edge::threshold(labels, 1));
    std::transform(labels.data(),
                   labels.data() + labels.size(),
                   kept.data(),
                   labels.data(),
                   [](std::uint8_t label, std::uint8_t is_kept) {
                       return is_kept != 0 ? label : std::uint8_t{0};
                   });
}

/// The labels in use, ascending, without 0.
std::vector<std::uint8_t> labels_in_use(const core::Image<std::uint8_t>& labels) {
    std::array<bool, 256> is_used{};
    for (std::size_t i = 0; i < labels.size(); ++i)
        is_used[labels.data()[i]] = true;
    std::vector<std::uint8_t> used;
    for (std::size_t label = 1; label < is_used.size(); ++label) {
        if (is_used[label]) used.push_back(static_cast<std::uint8_t>(label));
    }
    return used;
}

bool is_binary(const std::vector<std::uint8_t>& labels) {
    return labels.empty() || (labels.size() == 1 && (labels[0] == 1 || labels[0] == 255));
}

/// Each class against all that is drawn, with a matching of its own: which of the equally good
/// global matchings was found must not decide a recall.
std::vector<ClassCount> match_classes(const PixelList& drawn, const TruthLists& lists) {
    if (lists.classes.empty()) return {};
    DrawnMatcher matcher(drawn, lists.disk);
    std::vector<ClassCount> classes;
    for (const ClassPixels& of_class : lists.classes) {
        classes.push_back({.label = of_class.label,
                           .k = matcher.match(of_class.pixels),
                           .n_truth = static_cast<std::int64_t>(of_class.pixels.size())});
    }
    return classes;
}

}  // namespace

std::optional<double> Score::f_of_truth() const {
    if (n_truth == 0) return std::nullopt;
    return f();
}

std::optional<double> Score::precision() const {
    if (n_pred == 0) return std::nullopt;
    return static_cast<double>(k) / static_cast<double>(n_pred);
}

std::optional<double> Score::recall() const {
    if (n_truth == 0) return std::nullopt;
    return static_cast<double>(k) / static_cast<double>(n_truth);
}

void check(const ScoreOptions& options) {
    if (!(options.tolerance_px > 0 && options.tolerance_px <= BitMatcher::kMostRadius_px)) {
        throw core::Error("tolerance",
                          fmt::format("{} px", options.tolerance_px),
                          fmt::format("more than 0, at most {} px", BitMatcher::kMostRadius_px));
    }
    if (options.threshold < 1 || options.threshold > 255) {
        throw core::Error("threshold", fmt::format("{}", options.threshold), "1..255");
    }
    if (options.band_px < 0) {
        throw core::Error("band", fmt::format("{} px", options.band_px), "0 px or more");
    }
    if (options.ignore_label && (*options.ignore_label < 1 || *options.ignore_label > 255)) {
        throw core::Error("ignore label", fmt::format("{}", *options.ignore_label), "1..255");
    }
}

ScoringTruth prepare_truth(const core::Image<std::uint8_t>& labels,
                           const ScoreOptions& options,
                           bool rethin) {
    check(options);
    ScoringTruth truth;
    truth.labels = labels;
    clear_band(truth.labels, options.band_px);
    truth.ignore = take_out_ignore(truth.labels, options.ignore_label);
    if (rethin) thin_labels(truth.labels);
    truth.labels_in_use = labels_in_use(truth.labels);
    truth.is_binary = is_binary(truth.labels_in_use);
    return truth;
}

Score score_lists(const Strokes& strokes, const PixelList& drawn, const TruthLists& lists) {
    const MatchCounts counts = match_pixels(drawn, lists.truth, lists.disk);
    Score result;
    result.k = counts.k;
    result.n_pred = static_cast<std::int64_t>(drawn.size());
    result.n_truth = static_cast<std::int64_t>(lists.truth.size());
    result.unmatched_duplicates = counts.left_reached - counts.k;
    result.false_positives = result.n_pred - counts.left_reached;
    result.unmatched_truth = counts.right_reached - counts.k;
    result.false_negatives = result.n_truth - counts.right_reached;
    result.mean_width_px = strokes.mean_width_px();
    result.classes = match_classes(drawn, lists);
    return result;
}

Score score(const edge::EdgeImage& prediction,
            const ScoringTruth& truth,
            const ScoreOptions& options) {
    const TruthLists lists = checked_lists(prediction, truth, options);
    const Strokes strokes = make_strokes(prediction, options.threshold, options);
    return score_lists(strokes, counted_pixels(strokes.thinned, lists), lists);
}

}  // namespace ink::score
