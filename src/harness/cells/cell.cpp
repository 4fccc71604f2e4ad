#include "harness/cells/cell.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/named.h"
#include "core/param.h"
#include "harness/truths/tracing.h"

namespace ink::harness {
namespace {

/// Nanoseconds that a stage of making ready would take if it made all by itself.
template <class Work>
std::int64_t stage_ns(const scene::PreparedScene& scene, Work work) {
    const std::int64_t saved_before_ns = scene.saved_ns();
    const std::int64_t ns = time_ns(work);
    return ns + scene.saved_ns() - saved_before_ns;
}

}  // namespace

std::string join_params(const core::ParamValues& values) {
    std::string text;
    for (const auto& [name, value] : values) {
        text += fmt::format("{}{}={}", text.empty() ? "" : ";", name, value);
    }
    return text;
}

score::ScoreOptions score_options(int threshold) {
    score::ScoreOptions options;
    options.tolerance_px = kTolerance_px;
    options.threshold = threshold;
    options.band_px = kBand_px;
    options.ignore_label = static_cast<int>(truth::LineClass::ignore);
    return options;
}

Scored score_image(const edge::EdgeImage& image,
                   std::span<const score::TruthLists> lists,
                   int threshold) {
    const score::ScoreOptions options = score_options(threshold);
    Scored scored;
    scored.strokes = score::make_strokes(image, threshold, options);
    for (std::size_t i = 0; i < kTolerances_px.size(); ++i) {
        score::PixelList drawn = score::counted_pixels(scored.strokes.thinned, lists[i]);
        if (kTolerances_px[i] != kTolerance_px) {
            scored.tolerance_sweep.push_back(score::match_counts(drawn, lists[i]));
            continue;
        }
        scored.at_2px = score::score_lists(scored.strokes, drawn, lists[i]);
        scored.wrong_2px = score::wrong_pixels(scored.strokes, drawn, lists[i], options);
        scored.curve = score::score_curve_lists(image, lists[i], options);
        scored.tolerance_sweep.push_back(scored.at_2px);
        scored.drawn = std::move(drawn);
    }
    return scored;
}

void fill_scores(const Scored& scored, Row& row) {
    fill_score_2px(scored.at_2px, row);
    const score::CurveCount& strict = scored.tolerance_sweep.front();
    row.f_1px = strict.f();
    row.k_1px = strict.k;
    row.n_pred_1px = strict.n_pred;
    row.ap = score::average_precision(scored.curve);
    row.tolerance_sweep = scored.tolerance_sweep;
    row.causes = scored.attribution.counts;
}

void fill_score_2px(const score::Score& s, Row& row) {
    row.f_2px = s.f();
    row.precision_2px = s.precision();
    row.recall_2px = s.recall();
    for (const score::ClassCount& c : s.classes) {
        const std::string_view name = truth::name(static_cast<truth::LineClass>(c.label));
        if (c.n_truth > 0) row.by_class[std::string(name)] = {c.k, c.n_truth, c.n_truth};
    }
    if (s.mean_width_px > 0) row.mean_width_px = s.mean_width_px;
    row.k_2px = s.k;
    row.n_pred = s.n_pred;
    row.n_truth = s.n_truth;
    row.unmatched_duplicates = s.unmatched_duplicates;
    row.false_positives = s.false_positives;
    row.unmatched_truth = s.unmatched_truth;
    row.false_negatives = s.false_negatives;
    row.truth_px = s.n_truth;
}

void fill_skips(const DrawTimes& times, const raster::SkipSet& allowed, Row& row) {
    row.skips_off = forbidden_skips(allowed);
    if (times.failure.empty()) row.skips = times.skips;
}

std::size_t most_at_once(const scene::Scene& scene, std::size_t triangles_at_once) {
    const std::size_t triangles = std::max<std::size_t>(1, scene::triangle_count(scene));
    return std::max<std::size_t>(1, triangles_at_once / triangles);
}

PreparedMethods prepare_methods(std::span<const method::MethodConfig> configs,
                                const scene::PreparedScene& scene) {
    PreparedMethods methods;
    for (const method::MethodConfig& config : configs)
        methods.push_back(std::make_unique<PreparedMethod>(config, scene));
    return methods;
}

PreparedMethod::PreparedMethod(const method::MethodConfig& config,
                               const scene::PreparedScene& scene)
    : config_(config) {
    settings_ = config.info->complete(config.settings);
    threshold_ = method::threshold_of(config);
    method_ = config.info->make(config.settings);
    failure_ = failure_of([&] {
        prepare_ns_ = stage_ns(scene, [&] { method_->prepare(scene); });
        pose_ns_ = stage_ns(scene, [&] { method_->pose(scene); });
    });
}

Row PreparedMethod::row() const {
    Row row;
    row.method = config_.info->name;
    row.params = join_params(settings_);
    row.threshold = threshold_;
    if (!failure_.empty()) {
        row.status = failure_;
        return row;
    }
    if (config_.is_outside) {
        row.clock = kOwnClock;
        return row;
    }
    row.prepare_ns = prepare_ns_;
    row.pose_ns = pose_ns_;
    row.bytes_per_px = method_->bytes_per_px();
    row.cost = CostFacts{method_->cost(), {}};
    return row;
}

raster::SkipSet skips_of_repeated_drawings() {
    return raster::SkipSet().set(raster::Skip::temporal_reuse, false);
}

raster::SkipSet without_skips(raster::SkipSet allowed, const std::vector<std::string>& names) {
    const auto& infos = raster::skip_infos();
    for (const std::string& name : names) {
        if (name == "all") {
            allowed = raster::SkipSet::none();
            continue;
        }
        const raster::SkipInfo* found = core::find_named(infos, name);
        if (found == nullptr) {
            std::vector<std::string> known = core::names_of(infos);
            known.emplace_back("all");
            throw core::Error("--no-skip",
                              fmt::format("there is no skip '{}'", name),
                              core::known_names(known, name));
        }
        allowed.set(found->skip, false);
    }
    return allowed;
}

std::string forbidden_skips(const raster::SkipSet& allowed) {
    std::string text;
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        if (allowed.has(info.skip)) continue;
        if (!text.empty()) text += ';';
        text += info.name;
    }
    return text;
}

}  // namespace ink::harness
