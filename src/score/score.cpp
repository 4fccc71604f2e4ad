#include "score/score.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "edge/thin.h"
#include "score/matching.h"
#include "score/pixel_list.h"

namespace ink::score {
namespace {

constexpr double kMaxTolerance = 64;

/// Sets a band along the frame to 0.
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

/// Moves the ignore label from the labels to a mask of its own.
edge::Mask take_out_ignore(core::Image<std::uint8_t>& labels, std::optional<int> ignore_label) {
    edge::Mask ignore(labels.width_px(), labels.height_px());
    if (!ignore_label) return ignore;
    for (int y = 0; y < labels.height_px(); ++y) {
        for (int x = 0; x < labels.width_px(); ++x) {
            if (labels.at(x, y) != *ignore_label) continue;
            labels.at(x, y) = 0;
            ignore.at(x, y) = 1;
        }
    }
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

/// The truth's side of a comparison, as lists.
struct TruthLists {
    PixelList truth;
    PixelList ignore;
    Disk disk;
};

TruthLists list_truth(const edge::EdgeImage& prediction,
                      const ScoringTruth& truth,
                      const ScoreOptions& options) {
    check(options);
    if (prediction.width_px() != truth.labels.width_px() ||
        prediction.height_px() != truth.labels.height_px()) {
        throw core::Error("score",
                          fmt::format("the prediction is {} x {} px and the truth {} x {} px",
                                      prediction.width_px(),
                                      prediction.height_px(),
                                      truth.labels.width_px(),
                                      truth.labels.height_px()),
                          "two pictures of one size");
    }
    return {PixelList(truth.labels), PixelList(truth.ignore), Disk(options.tolerance_px)};
}

/// What of a prediction is compared.
struct Drawing {
    PixelList pixels;
    double mean_width_px = 0;
};

std::int64_t count(const edge::Mask& mask) {
    return std::count(mask.data(), mask.data() + mask.size(), std::uint8_t{1});
}

/// Threshold, thin, band.
Drawing thin_pixels(const edge::EdgeImage& prediction, int threshold, const ScoreOptions& options) {
    edge::Mask mask = edge::threshold(prediction, threshold);
    const auto n_drawn = static_cast<double>(count(mask));
    if (options.thin) mask = edge::thin(mask);
    const auto n_thin = static_cast<double>(count(mask));
    clear_band(mask, options.band_px);
    return {PixelList(mask), n_thin > 0 ? n_drawn / n_thin : 0};
}

/// Drops what has an ignored pixel and no true one in reach.
void drop_ignored(const TruthLists& lists, PixelList& drawn) {
    if (lists.ignore.is_empty()) return;
    std::vector<std::uint8_t> is_dropped = within_reach(drawn, lists.ignore, lists.disk);
    const auto has_truth = within_reach(drawn, lists.truth, lists.disk);
    for (std::size_t i = 0; i < is_dropped.size(); ++i) {
        if (has_truth[i] != 0) is_dropped[i] = 0;
    }
    drawn.drop(is_dropped);
}

Drawing drawn_pixels(const edge::EdgeImage& prediction,
                     int threshold,
                     const TruthLists& lists,
                     const ScoreOptions& options) {
    Drawing drawing = thin_pixels(prediction, threshold, options);
    drop_ignored(lists, drawing.pixels);
    return drawing;
}

CurveCount match_counts(const PixelList& drawn, const TruthLists& lists) {
    return {.k = match_pixels(drawn, lists.truth, lists.disk).k,
            .n_pred = static_cast<std::int64_t>(drawn.size()),
            .n_truth = static_cast<std::int64_t>(lists.truth.size())};
}

/// Each class against all that is drawn, with a matching of its own: which of the equally good
/// global matchings was found must not decide a recall.
std::vector<ClassCount> match_classes(const PixelList& drawn,
                                      const ScoringTruth& truth,
                                      const Disk& disk) {
    std::vector<ClassCount> classes;
    for (const std::uint8_t label : truth.labels_in_use) {
        const PixelList of_class(truth.labels, label);
        classes.push_back({.label = label,
                           .k = match_pixels(drawn, of_class, disk).k,
                           .n_truth = static_cast<std::int64_t>(of_class.size())});
    }
    return classes;
}

}  // namespace

double Score::f() const {
    return CurveCount{k, n_pred, n_truth}.f();
}

CurveCount& CurveCount::operator+=(const CurveCount& other) {
    k += other.k;
    n_pred += other.n_pred;
    n_truth += other.n_truth;
    return *this;
}

double CurveCount::f() const {
    const std::int64_t all = n_pred + n_truth;
    return all > 0 ? 2.0 * static_cast<double>(k) / static_cast<double>(all) : 1.0;
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
    if (!(options.tolerance_px > 0 && options.tolerance_px <= kMaxTolerance)) {
        throw core::Error("tolerance",
                          fmt::format("{} px", options.tolerance_px),
                          fmt::format("more than 0, at most {} px", kMaxTolerance));
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

Score score(const edge::EdgeImage& prediction,
            const ScoringTruth& truth,
            const ScoreOptions& options) {
    const TruthLists lists = list_truth(prediction, truth, options);
    const Drawing drawing = drawn_pixels(prediction, options.threshold, lists, options);
    const MatchCounts counts = match_pixels(drawing.pixels, lists.truth, lists.disk);
    Score result;
    result.k = counts.k;
    result.n_pred = static_cast<std::int64_t>(drawing.pixels.size());
    result.n_truth = static_cast<std::int64_t>(lists.truth.size());
    result.surplus = counts.left_reached - counts.k;
    result.off_line = result.n_pred - counts.left_reached;
    result.lost = counts.right_reached - counts.k;
    result.missing = result.n_truth - counts.right_reached;
    result.mean_width_px = drawing.mean_width_px;
    if (!truth.is_binary) result.classes = match_classes(drawing.pixels, truth, lists.disk);
    return result;
}

std::array<CurveCount, 99> score_curve(const edge::EdgeImage& prediction,
                                       const ScoringTruth& truth,
                                       const ScoreOptions& options) {
    const TruthLists lists = list_truth(prediction, truth, options);
    std::array<std::int64_t, 257> n_at_least{};  // pixels of at least this strength
    for (std::size_t i = 0; i < prediction.size(); ++i)
        ++n_at_least[prediction.data()[i]];
    for (std::size_t s = 255; s > 0; --s)
        n_at_least[s] += n_at_least[s + 1];

    std::array<CurveCount, 99> curve;
    std::int64_t n_before = -1;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const int threshold = edge::strength_at_percent(static_cast<int>(i) + 1);
        const std::int64_t n_drawn = n_at_least[static_cast<std::size_t>(threshold)];
        // The masks are nested, so as many pixels are the same pixels.
        if (n_drawn == n_before) {
            curve[i] = curve[i - 1];
            continue;
        }
        n_before = n_drawn;
        const Drawing drawing = drawn_pixels(prediction, threshold, lists, options);
        curve[i] = match_counts(drawing.pixels, lists);
    }
    return curve;
}

std::vector<CurveCount> score_ladder(const edge::EdgeImage& prediction,
                                     const ScoringTruth& truth,
                                     const ScoreOptions& options,
                                     std::span<const double> tolerances_px) {
    std::vector<CurveCount> ladder;
    if (tolerances_px.empty()) return ladder;
    ScoreOptions at = options;
    at.tolerance_px = tolerances_px.front();
    TruthLists lists = list_truth(prediction, truth, at);
    const Drawing drawing = thin_pixels(prediction, options.threshold, options);
    for (const double tolerance_px : tolerances_px) {
        at.tolerance_px = tolerance_px;
        check(at);
        lists.disk = Disk(tolerance_px);
        PixelList drawn = drawing.pixels;
        drop_ignored(lists, drawn);
        ladder.push_back(match_counts(drawn, lists));
    }
    return ladder;
}

double average_precision(const std::array<CurveCount, 99>& curve) {
    const auto n_truth = static_cast<double>(curve[0].n_truth);
    if (n_truth == 0) {
        const bool fires = std::any_of(
            curve.begin(), curve.end(), [](const CurveCount& c) { return c.n_pred > 0; });
        return fires ? 0 : 1;
    }
    std::vector<std::pair<double, double>> points;  // recall, precision
    for (const CurveCount& c : curve) {
        if (c.n_pred == 0) continue;
        const auto k = static_cast<double>(c.k);
        points.emplace_back(k / n_truth, k / static_cast<double>(c.n_pred));
    }
    std::sort(points.begin(), points.end());
    double area = 0;
    double best_precision = 0;
    for (std::size_t i = points.size(); i-- > 0;) {
        best_precision = std::max(best_precision, points[i].second);
        const double recall_below = i > 0 ? points[i - 1].first : 0;
        area += (points[i].first - recall_below) * best_precision;
    }
    return area;
}

}  // namespace ink::score
