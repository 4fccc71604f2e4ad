#include "harness/truths/tracing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <memory>
#include <optional>

#include "core/progress.h"
#include "harness/cells/cell.h"
#include "scene/precision/weld_tolerance.h"
#include "truth/cracks.h"
#include "truth/curve_facts.h"
#include "truth/label_image.h"
#include "truth/truth_cache.h"

namespace ink::harness {
namespace {

score::ScoringTruth scoring_of(const core::Image<std::uint8_t>& labels) {
    score::ScoreOptions options;
    options.band_px = kBand_px;
    options.ignore_label = static_cast<int>(truth::LineClass::ignore);
    score::ScoringTruth scoring = score::prepare_truth(labels, options, true);
    // A traced truth is one of classes, also where it shows contours only (label 1 looks binary).
    scoring.is_binary = false;
    return scoring;
}

score::ScoringTruth scoring_of(const truth::Truth& traced, score::Intersections intersections) {
    return scoring_of(score::counted_labels(traced.labels, traced.below_crease, intersections));
}

/// The truth as if no part of the image were too dense to score.
score::ScoringTruth scoring_with_crowded(const truth::Truth& traced,
                                         double crease_rad,
                                         score::Intersections intersections) {
    const truth::LabelImage image = truth::draw_labels(traced.curves,
                                                       traced.labels.width_px(),
                                                       traced.labels.height_px(),
                                                       crease_rad,
                                                       truth::Crowded::count);
    return scoring_of(score::counted_labels(image.labels, image.below_crease, intersections));
}

/// The intersections below the crease angle that are pixels of `all`.
score::PixelList below_crease_of(core::Image<std::uint8_t> below, const score::ScoringTruth& all) {
    for (std::size_t i = 0; i < below.size(); ++i) {
        if (all.labels.data()[i] == 0) below.data()[i] = 0;
    }
    return score::PixelList(below);
}

score::TruthLists list_at(const score::ScoringTruth& truth, double tolerance_px) {
    score::ScoreOptions options = score_options(1);  // images have thresholds of their own
    options.tolerance_px = tolerance_px;
    return score::list_truth(truth, options);
}

}  // namespace

void report_progress(truth::TruthOptions& options) {
    // Made when the first lines are done, gone with the last copy of the options.
    auto progress = std::make_shared<std::optional<core::Progress>>();
    options.progress = [progress](std::size_t done, std::size_t total) {
        if (!*progress) progress->emplace("truth", static_cast<int>(total));
        (*progress)->report(static_cast<int>(done), "lines");
        if (done == total) progress->reset();
    };
}

double TraceOptions::crease_deg() const {
    constexpr double kPerDegree = 1e9;
    return std::round(glm::degrees(truth.crease_rad) * kPerDegree) / kPerDegree;
}

core::Image<std::uint8_t> ViewTruth::counted_labels() const {
    return score::counted_labels(traced.labels, traced.below_crease, intersections);
}

ViewTruth trace_view(truth::SceneModel& scene, const scene::View& view, const TraceOptions& trace) {
    using enum score::Intersections;
    ViewTruth result;
    result.traced = truth::cached_truth(scene, view, trace.cache);
    result.intersections = trace.intersections;
    result.crease_rad = scene.options().crease_rad;
    result.cracks = truth::draw_cracks(result.traced.curves, view.width_px, view.height_px);
    result.scoring = scoring_of(result.traced, trace.intersections);
    if (result.traced.counts.crowded_share > 0) {
        result.with_crowded =
            scoring_with_crowded(result.traced, result.crease_rad, trace.intersections);
    }
    const auto& below = result.traced.below_crease;
    if (std::count(below.data(), below.data() + below.size(), 0) ==
        static_cast<std::ptrdiff_t>(below.size()))
        return result;
    const bool is_all = trace.intersections == all;
    result.other = scoring_of(result.traced, is_all ? above_crease : all);
    result.below_crease = below_crease_of(below, is_all ? result.scoring : *result.other);
    return result;
}

std::string truth_summary(const truth::Truth& truth) {
    std::string text =
        fmt::format("{:<14} {:>9} {:>9} {:>12}\n", "class", "pixels", "curves", "length px");
    for (const truth::LineClass c : truth::kLineClasses) {
        const auto label = static_cast<std::uint8_t>(c);
        const auto pixels =
            std::count(truth.labels.data(), truth.labels.data() + truth.labels.size(), label);
        std::size_t curves = 0;
        double length_px = 0;
        for (const truth::Curve& curve : truth.curves) {
            if (curve.line_class != c) continue;
            ++curves;
            length_px +=
                std::hypot(curve.end.x_px - curve.begin.x_px, curve.end.y_px - curve.begin.y_px);
        }
        text += fmt::format(
            "{:<14} {:>9} {:>9} {:>12.1f}\n", truth::name(c), pixels, curves, length_px);
    }
    const truth::ContourLengths behind = truth::contour_lengths(truth.curves);
    text +=
        fmt::format("behind contours: sky {:.1f} px, another object {:.1f} px, itself {:.1f} px\n",
                    behind.sky_px,
                    behind.other_object_px,
                    behind.self_px);
    const truth::TruthCounts& n = truth.counts;
    text += fmt::format(
        "triangles {} (degenerate {}, duplicate {}), defect edges {}, feature edges in the frustum "
        "{}\n"
        "pairs of triangles tested {}, crossings {}, contacts {}\n"
        "samples {}, rays {}, merged by thinning {} px, crowded {:.2f} % of truth pixels\n"
        "traced in {:.3f} s\n",
        n.triangles,
        n.degenerate,
        n.duplicate,
        n.defect_edges,
        n.candidate_edges,
        n.pairs_tested,
        n.crossings,
        n.contacts,
        n.samples,
        n.rays,
        n.merged_px,
        100 * n.crowded_share,
        truth.trace_s);
    if (n.rounding_px > scene::kUnseen_px) {
        text += fmt::format("rounding of coordinates may move what is seen by {:.3g} px\n",
                            n.rounding_px);
    }
    if (n.joined_vertices > 0) {
        text += fmt::format("the weld's epsilon joined {} vertices and collapsed {} triangles\n",
                            n.joined_vertices,
                            n.collapsed);
    }
    return text;
}

ViewLists list_view(const ViewTruth& truth) {
    ViewLists lists{list_at(truth.scoring, kTolerance_px)};
    if (truth.other) lists.other = list_at(*truth.other, kTolerance_px);
    if (truth.with_crowded) lists.with_crowded = list_at(*truth.with_crowded, kTolerance_px);
    return lists;
}

std::vector<score::TruthLists> list_tolerances(const score::ScoringTruth& truth) {
    std::vector<score::TruthLists> lists;
    for (const double tolerance_px : kTolerances_px)
        lists.push_back(list_at(truth, tolerance_px));
    return lists;
}

}  // namespace ink::harness
