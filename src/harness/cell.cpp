#include "harness/cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/error.h"
#include "core/hash.h"
#include "harness/outside_method.h"
#include "scene/sharing/shared_work.h"

namespace ink::harness {
namespace {

using Clock = std::chrono::steady_clock;

/// The one clock: nanoseconds that `work` took.
template <class Work>
std::int64_t time_ns(Work work) {
    const auto start = Clock::now();
    work();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start).count();
}

/// Nanoseconds that a stage of making ready took, or would have taken if nothing had been shared.
template <class Work>
std::int64_t stage_ns(Work work) {
    const std::int64_t saved_before_ns = scene::SharedWork::saved_ns();
    const std::int64_t ns = time_ns(work);
    return ns + scene::SharedWork::saved_ns() - saved_before_ns;
}

/// Nearest rank, so that a quantile is always a time that was measured.
std::int64_t quantile(const std::vector<std::int64_t>& sorted, double q) {
    const auto rank =
        static_cast<std::size_t>(std::lround(q * static_cast<double>(sorted.size() - 1)));
    return sorted[rank];
}

/// Runs a method's stage; what it throws becomes the cell's status instead of ending the run.
template <class Work>
std::string failure_of(Work work) {
    try {
        work();
    } catch (const std::bad_alloc&) {
        return "out of memory";
    } catch (const core::Error& error) {
        return error.what();
    } catch (const std::exception& error) {
        return fmt::format("failed: {}", error.what());
    }
    return "";
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

Scored score_image(const edge::EdgeImage& image, const score::ScoringTruth& truth, int threshold) {
    const score::ScoreOptions options = score_options(threshold);
    Scored scored;
    scored.strokes = score::make_strokes(image, threshold, options);
    scored.at_2px = score::score_strokes(scored.strokes, truth, options);
    scored.wrong_2px = score::wrong_pixels(scored.strokes, truth, options);
    scored.tolerance_sweep =
        score::tolerance_sweep_of_strokes(scored.strokes, truth, options, kTolerances_px);
    scored.curve = score::score_curve(image, truth, options);
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
        const auto line_class = static_cast<truth::LineClass>(c.label);
        if (c.n_truth == 0) continue;
        const std::string name(truth::name(line_class));
        row.recall_by_class[name] = static_cast<double>(c.k) / static_cast<double>(c.n_truth);
        row.truth_px_by_class[name] = c.n_truth;
        row.k_by_class[name] = c.k;
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

void fill_times(std::vector<std::int64_t> draw_ns, Row& row) {
    row.draw_n = static_cast<int>(draw_ns.size());
    if (draw_ns.empty()) return;
    std::sort(draw_ns.begin(), draw_ns.end());
    row.draw_ns = quantile(draw_ns, 0.5);
    row.draw_ns_q25 = quantile(draw_ns, 0.25);
    row.draw_ns_q75 = quantile(draw_ns, 0.75);
    row.draw_ns_min = draw_ns.front();
}

void fill_skips(const DrawTimes& times, const raster::SkipSet& allowed, Row& row) {
    row.skips_off = forbidden_skips(allowed);
    if (times.failure.empty()) row.skips = times.skips;
}

PreparedMethod::PreparedMethod(const MethodConfig& config,
                               const scene::Scene& scene,
                               std::span<const std::unique_ptr<PreparedMethod>> others)
    : config_(config) {
    settings_ = config.info->complete(config.settings);
    threshold_ = threshold_of(config);
    method_ = config.info->make(config.settings);
    failure_ = failure_of([&] {
        const auto same = std::find_if(others.begin(), others.end(), [&](const auto& other) {
            return other->failure().empty() && method_->prepare_like(other->method(), scene);
        });
        prepare_ns_ = same != others.end() ? (*same)->prepare_ns_
                                           : stage_ns([&] { method_->prepare(scene); });
        pose_ns_ = stage_ns([&] { method_->pose(scene); });
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
        row.clock = "own";
        return row;
    }
    row.prepare_ns = prepare_ns_;
    row.pose_ns = pose_ns_;
    row.bytes_per_px = method_->bytes_per_px();
    row.cost = CostFacts{method_->cost(), {}};
    return row;
}

std::vector<DrawTimes> draw_in_turns(std::vector<std::unique_ptr<PreparedMethod>>& methods,
                                     const scene::View& view,
                                     const MeasureOptions& options,
                                     std::vector<edge::EdgeImage>& images) {
    const std::size_t count = methods.size();
    std::vector<DrawTimes> times(count);
    std::vector<double> spent_s(count, 0);
    std::vector<bool> is_done(count, false);
    const method::Frame frame{view, options.threads, options.skips};
    images.assign(count, edge::EdgeImage());
    edge::EdgeImage again(view.width_px, view.height_px);

    for (int round = 0; round <= options.max_repetitions; ++round) {
        for (std::size_t i = 0; i < count; ++i) {
            if (is_done[i]) continue;
            if (round == 0) images[i] = edge::EdgeImage(view.width_px, view.height_px);
            edge::EdgeImage& out = round == 0 ? images[i] : again;
            std::int64_t ns = 0;
            std::string failure = methods[i]->failure();
            if (failure.empty()) {
                failure = failure_of(
                    [&] { ns = time_ns([&] { methods[i]->method().draw(frame, out); }); });
            }
            if (failure.empty() && round > 0 && !(again == images[i])) {
                failure = "failed: two drawings of one view differ";
            }
            if (!failure.empty()) {
                times[i] = {{}, failure, {}};
                is_done[i] = true;
                continue;
            }
            if (const auto* outside = dynamic_cast<OutsideMethod*>(&methods[i]->method())) {
                if (outside->draw_ns()) times[i].draw_ns.push_back(*outside->draw_ns());
                is_done[i] = true;
            }
            if (round == 0) continue;
            times[i].draw_ns.push_back(ns);
            times[i].skips = methods[i]->method().skip_counts();
            spent_s[i] += static_cast<double>(ns) * 1e-9;
            is_done[i] = round >= options.min_repetitions && spent_s[i] > options.budget_s;
        }
    }
    return times;
}

}  // namespace ink::harness
