#include "experiment/view_bench.h"

#include <algorithm>
#include <utility>

#include "core/parallel.h"
#include "harness/cells/cell.h"
#include "harness/suite/suite.h"

namespace ink::experiment {
namespace {

/// Triangles times results of preparation that are kept: a hundred bytes each. With fewer results
/// than the least, methods that come again for the next view or setting find nothing of theirs
/// left.
constexpr std::size_t kTrianglesKept = 6'000'000;
constexpr std::size_t kLeastKept = 48;

}  // namespace

ViewBench::ViewBench(const Experiment& experiment, harness::TraceOptions trace)
    : experiment_(experiment), trace_(std::move(trace)), configs_(configs_of(experiment)) {
    trace_.crosscheck = experiment.crosscheck;
    skips_ =
        harness::without_skips(harness::skips_of_repeated_drawings(), experiment.compare.skips_off);
    for (const ImageSize& size : experiment.sizes)
        add_scenes(size, harness::load_scenes(experiment.scenes, views_of(experiment, size)));
}

void ViewBench::add_scenes(const ImageSize& size, std::vector<harness::SceneViews> scenes) {
    for (std::size_t s = 0; s < scenes.size(); ++s) {
        views_[{s, size.width_px, size.height_px}] = std::move(scenes[s].views);
        if (scenes_.size() > s) continue;
        scene::check_creases(scenes[s].scene, experiment_.compare.creases);
        scenes_.push_back(std::move(scenes[s].scene));
    }
    desks_.resize(scenes_.size());
}

std::size_t ViewBench::view_count(std::size_t scene, const ImageSize& size) const {
    const std::size_t all = views_.at({scene, size.width_px, size.height_px}).size();
    return experiment_.compare.views > 0
               ? std::min(all, static_cast<std::size_t>(experiment_.compare.views))
               : all;
}

const scene::View& ViewBench::view(std::size_t scene, const ImageSize& size, std::size_t n) const {
    return views_.at({scene, size.width_px, size.height_px})[n];
}

harness::CellOptions ViewBench::cell_options(int threads) const {
    harness::CellOptions options{{}, trace_, experiment_.seed};
    options.measure.threads = threads;
    // Where no time is kept, one drawing more shows whether two are equal.
    const int repetitions = experiment_.times ? experiment_.repetitions : 1;
    options.measure.max_repetitions = repetitions;
    options.measure.min_repetitions = std::min(options.measure.min_repetitions, repetitions);
    options.measure.budget_s = experiment_.budget_ms * 1e-3;
    options.measure.skips = skips_;
    options.line_width_px = scored_width_px(experiment_);
    return options;
}

std::shared_ptr<const harness::TracedView> ViewBench::traced(std::size_t scene,
                                                             const scene::View& view) {
    Desk& desk = desk_of(scene);
    const std::lock_guard lock(desk.tracing);
    auto& [last, before] = desk.traced;
    if (last.view != &view) {
        std::swap(last, before);
        if (last.view != &view) {
            last = {};
            last = {&view,
                    std::make_shared<harness::TracedView>(
                        harness::trace_with_facts(*desk.model, scenes_[scene], view, trace_))};
        }
    }
    return last.truth;
}

harness::MissPredictor& ViewBench::predictor(std::size_t scene) {
    return *desk_of(scene).predictor;
}

std::size_t ViewBench::most_at_once(std::size_t scene) const {
    return harness::most_at_once(scenes_[scene]);
}

std::unique_lock<std::mutex> ViewBench::hold_methods(std::size_t scene) {
    return std::unique_lock(desk_of(scene).using_methods);
}

std::shared_ptr<harness::PreparedMethods> ViewBench::methods(std::size_t scene, std::size_t first) {
    Desk& desk = desk_of(scene);
    if (desk.methods && first == desk.first_method) return desk.methods;
    desk.methods = {};
    const std::size_t count = std::min(configs_.size() - first, most_at_once(scene));
    desk.methods = prepared(std::span(configs_).subspan(first, count), scene);
    desk.first_method = first;
    return desk.methods;
}

std::shared_ptr<harness::PreparedMethods> ViewBench::prepared(
    std::span<const method::MethodConfig> configs, std::size_t scene) {
    return std::make_shared<harness::PreparedMethods>(
        harness::prepare_methods(configs, desk_of(scene).prepared->shared()));
}

void ViewBench::release(std::size_t scene) {
    const std::lock_guard lock(desks_mutex_);
    desks_[scene] = nullptr;
}

ViewBench::Desk& ViewBench::desk_of(std::size_t scene) {
    const std::lock_guard lock(desks_mutex_);
    if (desks_[scene]) return *desks_[scene];
    desks_[scene] = std::make_unique<Desk>();
    Desk& desk = *desks_[scene];
    truth::TruthOptions options = trace_.truth;
    options.threads = std::min(options.threads, core::share_of_threads());
    desk.model = std::make_unique<truth::SceneModel>(scenes_[scene], options);
    desk.predictor = std::make_unique<harness::MissPredictor>(scenes_[scene]);
    const std::size_t triangles = std::max<std::size_t>(1, triangle_count(scenes_[scene]));
    desk.prepared = std::make_unique<scene::PreparedScene>(
        scenes_[scene], std::max(kLeastKept, kTrianglesKept / triangles));
    return desk;
}

}  // namespace ink::experiment
