#include "tune/tune_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/error.h"
#include "core/hash.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "harness/cell.h"
#include "harness/interrupt.h"
#include "score/matching.h"
#include "statistics/spread.h"

namespace ink::tune {
namespace {

using Clock = std::chrono::steady_clock;

/// Settings whose pictures are kept: the one in hand and the one before it.
constexpr std::size_t kKeptPictures = 2;

std::string key_of(const harness::Entrant& entrant, DrawnBy by) {
    core::ParamValues all = entrant.info->complete(entrant.settings);
    all.erase("threshold");
    return (by == DrawnBy::planes ? "planes " : "method ") + harness::join_params(all);
}

int threshold_of(const harness::Entrant& entrant) {
    return std::stoi(entrant.info->complete(entrant.settings).at("threshold"));
}

}  // namespace

TuneBench::TuneBench(const std::vector<harness::Subject>& subjects,
                     const harness::TraceOptions& trace,
                     int threads)
    : subjects_(subjects), threads_(threads), planes_(subjects) {
    int total = 0;
    for (const harness::Subject& subject : subjects)
        total += static_cast<int>(subject.views.size());
    core::Progress progress("truths", total);
    core::Hasher hasher;
    const score::ScoreOptions options = harness::score_options(1);
    for (std::size_t s = 0; s < subjects.size(); ++s) {
        truth::SceneModel model(subjects[s].scene, trace.truth);
        for (const scene::View& view : subjects[s].views) {
            const std::string name = fmt::format("{} {}", subjects[s].scene.name, view.camera.name);
            progress.report(static_cast<int>(views_.size()), name);
            try {
                harness::ViewTruth truth = harness::trace_view(model, view, trace.cache);
                hasher.text(name).text(core::image_hash(truth.scoring.labels));
                hasher.text(core::image_hash(truth.scoring.ignore));
                score::TruthLists lists = score::list_truth(truth.scoring, options);
                views_.push_back({s, view, std::move(truth.scoring), std::move(lists)});
                planes_.add_view(s, view, std::move(truth.traced.layers.triangle));
            } catch (const truth::TooLarge& reason) {
                throw core::Error(name, reason.what(), "scenes whose truth can be traced");
            }
            if (harness::is_interrupted()) return;
        }
    }
    hash_ = hasher.hex();
}

void TuneBench::draw_subject(const harness::Entrant& entrant,
                             std::size_t subject,
                             std::vector<edge::EdgeImage>& pictures,
                             std::vector<double>& times_ms) const {
    const scene::Scene& scene = subjects_[subject].scene;
    const auto method = entrant.info->make(entrant.settings);
    method->prepare(scene);
    method->pose(scene);
    for (std::size_t i = 0; i < views_.size(); ++i) {
        if (views_[i].subject != subject) continue;
        pictures[i] = edge::EdgeImage(views_[i].view.width_px, views_[i].view.height_px);
        const auto start = Clock::now();
        method->draw({views_[i].view, 1}, pictures[i]);
        times_ms[i] = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }
}

std::vector<edge::EdgeImage> TuneBench::drawn_by_method(const harness::Entrant& entrant) {
    std::vector<edge::EdgeImage> pictures(views_.size());
    std::vector<double> times_ms(views_.size());
    core::parallel_for(subjects_.size(), takes_times_ ? 1 : threads_, [&](std::size_t s) {
        draw_subject(entrant, s, pictures, times_ms);
    });
    draw_ms_ = statistics::quantile(times_ms, 0.5).value_or(0);
    return pictures;
}

const std::vector<edge::EdgeImage>& TuneBench::pictures_of(const harness::Entrant& entrant,
                                                           DrawnBy by) {
    const std::string key = key_of(entrant, by);
    const auto found = std::find_if(
        kept_.begin(), kept_.end(), [&](const Drawn& drawn) { return drawn.key == key; });
    // With times a picture is drawn for each setting: a time belongs to it.
    if (found != kept_.end() && !takes_times_) {
        std::rotate(found, found + 1, kept_.end());
        return kept_.back().pictures;
    }
    Drawn drawn{key, {}};
    drawn.pictures =
        by == DrawnBy::planes ? planes_.pictures(entrant, threads_) : drawn_by_method(entrant);
    if (kept_.size() == kKeptPictures) kept_.erase(kept_.begin());
    kept_.push_back(std::move(drawn));
    return kept_.back().pictures;
}

std::vector<score::CurveCount> TuneBench::counts(const harness::Entrant& entrant, DrawnBy by) {
    const std::vector<edge::EdgeImage>& pictures = pictures_of(entrant, by);
    const score::ScoreOptions options = harness::score_options(threshold_of(entrant));
    std::vector<score::CurveCount> by_view(views_.size());
    core::parallel_for(views_.size(), threads_, [&](std::size_t i) {
        const BenchView& view = views_[i];
        score::Strokes strokes = score::make_strokes(pictures[i], options.threshold, options);
        const score::PixelList drawn =
            score::counted_pixels(std::move(strokes.thinned), view.lists, options);
        by_view[i] = {.k = score::match_pixels(drawn, view.lists.truth, view.lists.disk).k,
                      .n_pred = static_cast<std::int64_t>(drawn.size()),
                      .n_truth = static_cast<std::int64_t>(view.lists.truth.size())};
    });
    std::vector<score::CurveCount> by_scene(subjects_.size());
    for (std::size_t i = 0; i < views_.size(); ++i)
        by_scene[views_[i].subject] += by_view[i];
    return by_scene;
}

PlaneAgreement TuneBench::agreement(const harness::Entrant& entrant) {
    PlaneAgreement agreement;
    agreement.by_planes = counts(entrant, DrawnBy::planes);
    const std::vector<edge::EdgeImage> planes = pictures_of(entrant, DrawnBy::planes);
    const std::vector<edge::EdgeImage>& method = pictures_of(entrant, DrawnBy::method);
    const int threshold = threshold_of(entrant);
    for (std::size_t i = 0; i < views_.size(); ++i) {
        agreement.total_px += static_cast<std::int64_t>(method[i].size());
        for (std::size_t p = 0; p < method[i].size(); ++p) {
            const bool is_drawn = method[i].data()[p] >= threshold;
            agreement.differ_px += is_drawn != (planes[i].data()[p] >= threshold);
        }
    }
    return agreement;
}

std::array<score::CurveCount, 99> TuneBench::curve(const harness::Entrant& entrant, DrawnBy by) {
    const std::vector<edge::EdgeImage>& pictures = pictures_of(entrant, by);
    std::vector<std::array<score::CurveCount, 99>> by_view(views_.size());
    core::parallel_for(views_.size(), threads_, [&](std::size_t i) {
        by_view[i] = score::score_curve(pictures[i], views_[i].truth, harness::score_options(1));
    });
    std::array<score::CurveCount, 99> sum{};
    for (const auto& curve : by_view) {
        for (std::size_t t = 0; t < sum.size(); ++t)
            sum[t] += curve[t];
    }
    return sum;
}

}  // namespace ink::tune
