#include "experiment/view_bench.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "harness/skip_switches.h"
#include "harness/suite.h"

namespace ink::experiment {
namespace {

/// Triangles times methods that are ready together: a method prepares 600 bytes a triangle in the
/// mean, and 2 GB beside the truth of a large scene keep a comparison of all methods below 4.
constexpr std::size_t kTrianglesAtOnce = 3'000'000;

}  // namespace

ViewBench::ViewBench(const Experiment& experiment, harness::TraceOptions trace)
    : experiment_(experiment), trace_(std::move(trace)), configs_(configs_of(experiment)) {
    trace_.crosscheck = experiment.crosscheck;
    skips_ = harness::without_skips(harness::skips_of_repeated_drawings(),
                                    fmt::format("{}", fmt::join(experiment.skips_off, ",")));
    for (const ImageSize& size : experiment.sizes) {
        harness::ViewRequest request = experiment.view_request;
        request.width_px = size.width_px;
        request.height_px = size.height_px;
        std::vector<harness::SceneViews> scenes = harness::load_scenes(experiment.scenes, request);
        for (std::size_t s = 0; s < scenes.size(); ++s) {
            views_[{s, size.width_px, size.height_px}] = std::move(scenes[s].views);
            if (scenes_.size() == s) scenes_.push_back(std::move(scenes[s].scene));
        }
    }
}

std::size_t ViewBench::view_count(std::size_t scene, const ImageSize& size) const {
    const std::size_t all = views_.at({scene, size.width_px, size.height_px}).size();
    return experiment_.views > 0 ? std::min(all, static_cast<std::size_t>(experiment_.views)) : all;
}

const scene::View& ViewBench::view(std::size_t scene, const ImageSize& size, std::size_t n) const {
    return views_.at({scene, size.width_px, size.height_px})[n];
}

harness::CellOptions ViewBench::cell_options(int threads) const {
    harness::CellOptions options{{}, trace_, experiment_.seed};
    options.measure.threads = threads;
    options.measure.max_repetitions = experiment_.repetitions;
    options.measure.min_repetitions =
        std::min(options.measure.min_repetitions, experiment_.repetitions);
    options.measure.budget_s = experiment_.budget_s;
    options.measure.skips = skips_;
    return options;
}

const harness::TracedView& ViewBench::traced(std::size_t scene, const scene::View& view) {
    turn_to(scene);
    if (traced_view_ != &view) {
        traced_ = harness::trace_with_facts(*model_, scenes_[scene], view, trace_);
        traced_view_ = &view;
    }
    return traced_;
}

harness::MissPredictor& ViewBench::predictor(std::size_t scene) {
    turn_to(scene);
    return *predictor_;
}

std::size_t ViewBench::most_at_once(std::size_t scene) const {
    const std::size_t triangles = std::max<std::size_t>(1, triangle_count(scenes_[scene]));
    return std::max<std::size_t>(1, kTrianglesAtOnce / triangles);
}

std::vector<std::unique_ptr<harness::PreparedMethod>>& ViewBench::methods(std::size_t scene,
                                                                          std::size_t first) {
    turn_to(scene);
    if (!methods_.empty() && first == first_method_) return methods_;
    methods_.clear();
    const std::size_t end = first + std::min(configs_.size() - first, most_at_once(scene));
    methods_ = prepared({configs_.begin() + static_cast<std::ptrdiff_t>(first),
                         configs_.begin() + static_cast<std::ptrdiff_t>(end)},
                        scene,
                        Preparation::own);
    first_method_ = first;
    return methods_;
}

std::vector<std::unique_ptr<harness::PreparedMethod>> ViewBench::prepared(
    const std::vector<harness::MethodConfig>& configs,
    std::size_t scene,
    Preparation preparation) const {
    std::vector<std::unique_ptr<harness::PreparedMethod>> methods;
    const std::vector<std::unique_ptr<harness::PreparedMethod>> none;
    for (const harness::MethodConfig& config : configs)
        methods.push_back(std::make_unique<harness::PreparedMethod>(
            config, scenes_[scene], preparation == Preparation::shared ? methods : none));
    return methods;
}

void ViewBench::turn_to(std::size_t scene) {
    if (model_ && scene_ == scene) return;
    scene_ = scene;
    methods_.clear();
    traced_view_ = nullptr;
    model_ = std::make_unique<truth::SceneModel>(scenes_[scene], trace_.truth);
    predictor_ = std::make_unique<harness::MissPredictor>(scenes_[scene]);
}

}  // namespace ink::experiment
