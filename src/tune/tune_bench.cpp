#include "tune/tune_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

#include "core/error.h"
#include "core/hash.h"
#include "core/interrupt.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "harness/cells/cell.h"
#include "harness/truths/unscored_view.h"
#include "score/matching.h"
#include "statistics/spread.h"

namespace ink::tune {
namespace {

/// Of all sets that are kept, and of one.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;
constexpr std::size_t kBytesPerPixel = 4 * sizeof(float) + 1;

/// The code of these settings, if every scene has the same.
std::optional<method::LinearCode> code_of(const method::MethodConfig& config) {
    if (config.info->is_planned) return std::nullopt;
    return config.info->make(config.settings)->code();
}

/// What planes depend on.
std::string inputs_key(const method::LinearCode& code) {
    const method::CodeInputs& in = code.inputs;
    return fmt::format("{} {} {} {} {} {} {}",
                       static_cast<int>(code.encoding),
                       static_cast<int>(in.normals),
                       in.crease_rad,
                       static_cast<int>(in.depth_range),
                       static_cast<int>(in.interpolation),
                       in.at_vertices,
                       in.renormalise);
}

/// The key at an end of a parameter's range; "" if there is no code there.
std::string key_at(method::MethodConfig config, const TunedParameter& parameter, double value) {
    config.settings[parameter.param.name] = core::format_param(parameter.param, value);
    const auto code = code_of(config);
    return code ? inputs_key(*code) : "";
}

/// Makes what has this key the latest of all that is kept; false if nothing has.
template <class Kept>
bool make_latest(Kept& kept, const std::string& key) {
    const auto found =
        std::ranges::find_if(kept, [&](const auto& each) { return each.key == key; });
    if (found == kept.end()) return false;
    std::rotate(found, found + 1, kept.end());
    return true;
}

/// Settings whose images are kept: the one in hand and the one before it.
constexpr std::size_t kKeptImages = 2;

std::string key_of(const method::MethodConfig& config, DrawnBy by) {
    core::ParamValues all = config.info->complete(config.settings);
    all.erase("threshold");
    return (by == DrawnBy::planes ? "planes " : "method ") + harness::join_params(all);
}

}  // namespace

std::size_t TunePlanes::set_bytes() const {
    std::size_t pixels = 0;
    for (const BenchView& view : views_)
        pixels += view.triangle.size();
    return pixels * kBytesPerPixel;
}

bool TunePlanes::can_draw(const method::MethodConfig& config) const {
    return set_bytes() <= kMostBytes && code_of(config).has_value();
}

bool TunePlanes::can_search(const method::MethodConfig& config, const TuneSpace& space) const {
    return can_draw(config) &&
           std::ranges::all_of(space.parameters(), [&](const TunedParameter& parameter) {
               return !parameter.param.is_number() || key_at(config, parameter, parameter.low) ==
                                                          key_at(config, parameter, parameter.high);
           });
}

const TunePlanes::PlaneSet& TunePlanes::planes_of(const method::LinearCode& code, int threads) {
    const std::string key = inputs_key(code);
    if (make_latest(kept_, key)) return kept_.back();
    while (!kept_.empty() && (kept_.size() + 1) * set_bytes() > kMostBytes)
        kept_.erase(kept_.begin());
    PlaneSet set{key, std::vector<linear_code::ChannelPlanes>(views_.size())};
    core::parallel_for(scenes_.size(), threads, [&](std::size_t s) {
        const linear_code::ChannelSource source(scenes_[s].scene, code);
        for (std::size_t i = 0; i < views_.size(); ++i) {
            if (views_[i].scene_index != s) continue;
            set.views[i] = source.planes(views_[i].view, views_[i].triangle);
        }
    });
    kept_.push_back(std::move(set));
    return kept_.back();
}

std::vector<edge::EdgeImage> TunePlanes::images(const method::MethodConfig& config, int threads) {
    const auto code = code_of(config);
    assert(code);
    const PlaneSet& set = planes_of(*code, threads);
    std::vector<edge::EdgeImage> images(views_.size());
    core::parallel_for(views_.size(), threads, [&](std::size_t i) {
        images[i] = linear_code::responses_of(set.views[i], *code);
    });
    return images;
}

TuneBench::TuneBench(const std::vector<harness::SceneViews>& scenes,
                     const harness::TraceOptions& trace,
                     int threads)
    : scenes_(scenes), threads_(threads), planes_(scenes, views_) {
    int total = 0;
    for (const harness::SceneViews& scene_index : scenes)
        total += static_cast<int>(scene_index.views.size());
    core::Progress progress("truths", total);
    core::Hasher hasher;
    const score::ScoreOptions options = harness::score_options(1);
    for (std::size_t s = 0; s < scenes.size(); ++s) {
        truth::SceneModel model(scenes[s].scene, trace.truth);
        tune_views_.kind_of_scene.push_back(scenes[s].scene.kind);
        for (const scene::View& view : scenes[s].views) {
            const std::string name = fmt::format("{} {}", scenes[s].scene.name, view.camera.name);
            progress.report(static_cast<int>(views_.size()), name);
            harness::ViewTruth truth =
                harness::trace_scored_view(model, scenes[s].scene.name, view, trace);
            hasher.text(name).text(core::image_hash(truth.scoring.labels));
            hasher.text(core::image_hash(truth.scoring.ignore));
            score::TruthLists lists = score::list_truth(truth.scoring, options);
            tune_views_.scene_of_view.push_back(s);
            views_.push_back({s, view, std::move(truth.traced.layers.triangle), std::move(lists)});
            if (core::is_interrupted()) return;
        }
    }
    hash_ = hasher.hex();
}

void TuneBench::draw_scene(const method::MethodConfig& config,
                           std::size_t scene_index,
                           std::vector<edge::EdgeImage>& images,
                           std::vector<double>& times_ms) const {
    const harness::PreparedMethods prepared =
        harness::prepare_methods(std::span(&config, 1), scenes_[scene_index].scene);
    harness::MeasureOptions measure;
    if (!takes_times_) measure.max_repetitions = 0;
    for (std::size_t i = 0; i < views_.size(); ++i) {
        if (views_[i].scene_index != scene_index) continue;
        harness::Evaluation drawn =
            harness::method_evaluations(prepared, views_[i].view, measure).front();
        if (!drawn.row.is_ok())
            throw core::Error(
                config.info->name, drawn.row.status, "settings that it can draw with");
        images[i] = std::move(drawn.image);
        times_ms[i] = 1e-6 * static_cast<double>(drawn.row.draw_ns.value_or(0));
    }
}

std::vector<edge::EdgeImage> TuneBench::drawn_by_method(const method::MethodConfig& config) {
    std::vector<edge::EdgeImage> images(views_.size());
    std::vector<double> times_ms(views_.size());
    core::parallel_for(scenes_.size(), takes_times_ ? 1 : threads_, [&](std::size_t s) {
        draw_scene(config, s, images, times_ms);
    });
    draw_ms_ = statistics::quantile(times_ms, 0.5).value_or(0);
    return images;
}

const std::vector<edge::EdgeImage>& TuneBench::images_of(const method::MethodConfig& config,
                                                         DrawnBy by) {
    const std::string key = key_of(config, by);
    // With times an image is drawn for each setting: a time belongs to it.
    if (!takes_times_ && make_latest(kept_, key)) return kept_.back().images;
    Drawn drawn{key, {}};
    drawn.images =
        by == DrawnBy::planes ? planes_.images(config, threads_) : drawn_by_method(config);
    if (kept_.size() == kKeptImages) kept_.erase(kept_.begin());
    kept_.push_back(std::move(drawn));
    return kept_.back().images;
}

std::vector<score::CurveCount> TuneBench::view_counts(const method::MethodConfig& config,
                                                      DrawnBy by) {
    const std::vector<edge::EdgeImage>& images = images_of(config, by);
    const score::ScoreOptions options = harness::score_options(method::threshold_of(config));
    std::vector<score::CurveCount> by_view(views_.size());
    core::parallel_for(views_.size(), threads_, [&](std::size_t i) {
        const BenchView& view = views_[i];
        score::Strokes strokes = score::make_strokes(images[i], options.threshold, options);
        const score::PixelList drawn =
            score::counted_pixels(std::move(strokes.thinned), view.lists);
        by_view[i] = score::match_counts(drawn, view.lists);
    });
    return by_view;
}

std::vector<score::CurveCount> TuneBench::counts(const method::MethodConfig& config, DrawnBy by) {
    const std::vector<score::CurveCount> by_view = view_counts(config, by);
    std::vector<score::CurveCount> sums(scenes_.size());
    for (std::size_t i = 0; i < views_.size(); ++i)
        sums[views_[i].scene_index] += by_view[i];
    return sums;
}

PlaneAgreement TuneBench::agreement(const method::MethodConfig& config) {
    PlaneAgreement agreement;
    agreement.by_planes = counts(config, DrawnBy::planes);
    const std::vector<edge::EdgeImage> planes = images_of(config, DrawnBy::planes);
    const std::vector<edge::EdgeImage>& method = images_of(config, DrawnBy::method);
    const int threshold = method::threshold_of(config);
    for (std::size_t i = 0; i < views_.size(); ++i) {
        agreement.total_px += static_cast<std::int64_t>(method[i].size());
        for (std::size_t p = 0; p < method[i].size(); ++p) {
            const bool is_drawn = method[i].data()[p] >= threshold;
            agreement.differ_px += is_drawn != (planes[i].data()[p] >= threshold);
        }
    }
    return agreement;
}

}  // namespace ink::tune
