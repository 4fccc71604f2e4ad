#include "lab/roll_study.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <set>

#include "core/parallel.h"
#include "core/progress.h"
#include "lab/interrupt.h"
#include "lab/roll_prediction.h"
#include "scene/shapes.h"
#include "scene/surface.h"
#include "scene/topology.h"
#include "score/drawing.h"
#include "score/motion.h"
#include "truth/truth_cache.h"

namespace ink::lab {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;

/// A crease of the scene: its edge, and a global triangle on either side.
struct Crease {
    std::uint32_t edge = 0;
    std::uint32_t triangle0 = 0;
    std::uint32_t triangle1 = 0;
};

/// The creases that a truth shows, by edge.
std::vector<Crease> creases_of(const truth::Truth& truth, const scene::Scene& scene) {
    const scene::Topology topology = scene::weld(scene);
    std::vector<Crease> creases;
    std::set<std::uint32_t> seen;
    for (const truth::Curve& curve : truth.curves) {
        if (curve.line_class != truth::LineClass::crease) continue;
        if (!seen.insert(curve.edge).second) continue;
        creases.push_back({curve.edge,
                           topology.faces[curve.face0].triangle,
                           topology.faces[curve.face1].triangle});
    }
    std::sort(creases.begin(), creases.end(), [](const Crease& a, const Crease& b) {
        return a.edge < b.edge;
    });
    return creases;
}

/// The one normal of a triangle's three corners towards the eye, view space; nothing if they
/// differ.
std::optional<glm::dvec3> flat_normal(const scene::Surface& surface,
                                      std::uint32_t triangle,
                                      const scene::Camera& camera) {
    const scene::Triangle& corners = surface.triangles[triangle];
    const glm::vec3 n_world = surface.n_world[corners[0]];
    for (const std::uint32_t corner : corners) {
        if (surface.n_world[corner] != n_world) return std::nullopt;
    }
    const glm::dvec3 to_eye_world = camera.eye_world - surface.p_world[corners[0]];
    const double side = glm::dot(to_eye_world, glm::dvec3(n_world)) < 0 ? -1 : 1;
    return side * (camera.view_from_world * glm::dvec3(n_world));
}

/// One method on its way through the roll: what is known of each crease, and what was seen of it.
struct Entry {
    std::vector<RollCurve> curves;
    std::vector<std::optional<RollPrediction>> predictions;
    bool has_failed = false;
};

Entry make_entry(PreparedMethod& prepared,
                 const scene::Scene& scene,
                 const std::vector<Crease>& creases,
                 const scene::Camera& start) {
    Entry entry;
    entry.has_failed = !prepared.failure().empty();
    if (entry.has_failed) return entry;
    const Row row = prepared.row();
    const std::optional<methods::LinearCode> code = prepared.method().code();
    scene::Surface surface;
    if (code) surface = scene::flatten(scene, code->inputs.normals, code->inputs.crease_rad);
    for (std::size_t i = 0; i < creases.size(); ++i) {
        RollCurve curve{.method = row.method, .params = row.params, .crease = static_cast<int>(i)};
        std::optional<RollPrediction> prediction;
        if (code) {
            const auto n0 = flat_normal(surface, creases[i].triangle0, start);
            const auto n1 = flat_normal(surface, creases[i].triangle1, start);
            if (n0 && n1) prediction.emplace(*code, CreaseNormals{*n0, *n1});
        }
        curve.is_predicted = prediction.has_value();
        entry.curves.push_back(std::move(curve));
        entry.predictions.push_back(prediction);
    }
    return entry;
}

/// Adds a frame's sample to each crease of an entry.
void take(const edge::EdgeImage& picture,
          int threshold,
          const truth::Truth& truth,
          const std::vector<Crease>& creases,
          double roll_rad,
          Entry& entry) {
    const score::ScoreOptions options = score_options(threshold);
    const score::Strokes strokes = score::make_strokes(picture, threshold, options);
    const auto scoring = score::prepare_truth(truth.labels, options, true);
    const auto sights = score::see_features(truth.curves, strokes.thinned, scoring, options);
    for (std::size_t i = 0; i < creases.size(); ++i) {
        RollSample sample{.roll_rad = roll_rad};
        for (const score::FeatureSight& sight : sights) {
            const bool is_crease = sight.feature.line_class == truth::LineClass::crease;
            if (!is_crease || sight.feature.edge != creases[i].edge) continue;
            sample.length_px = sight.length_px;
            sample.covered_px = sight.covered_px;
        }
        if (entry.predictions[i]) {
            sample.step = entry.predictions[i]->step(roll_rad);
            sample.is_blind = entry.predictions[i]->is_blind(roll_rad, threshold);
        }
        entry.curves[i].samples.push_back(sample);
    }
}

/// From one angle to another the short way, -pi..pi.
double turn_between(double from_rad, double to_rad) {
    return std::remainder(to_rad - from_rad, kTurn_rad);
}

}  // namespace

double RollCurve::least_recall() const {
    double least = 1;
    for (const RollSample& sample : samples)
        least = std::min(least, sample.recall());
    return least;
}

double RollCurve::mean_recall() const {
    if (samples.empty()) return 1;
    double sum = 0;
    for (const RollSample& sample : samples)
        sum += sample.recall();
    return sum / static_cast<double>(samples.size());
}

scene::Scene roll_scene() {
    scene::Scene scene;
    scene.name = "cube_roll";
    scene.meshes.push_back(scene::make_box({-1, -1, -1}, {1, 1, 1}));
    scene.instances.push_back({});
    return scene;
}

scene::CameraPath roll_path(const scene::Scene& scene, const RollOptions& options) {
    scene::View view{
        scene::look_at(
            {4, 3.375, 6.4375}, glm::dvec3(0), {0, 1, 0}, scene::Camera{}.fov_y_rad / 1.5),
        options.size_px,
        options.size_px};
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    scene::fit_clip_range(view.camera, bounds);
    scene::CameraPath path = scene::make_path(scene::PathKind::roll, view, bounds, 0);
    path.turn_rad = kTurn_rad / options.frame_count;
    path.frame_count = options.frame_count;
    return path;
}

std::optional<double> measured_vanishing(const std::vector<RollSample>& samples,
                                         double predicted_rad) {
    constexpr double kNear_rad = 15 * std::numbers::pi / 180;
    const std::size_t n = samples.size();
    const auto is_lost = [&](std::size_t i) { return samples[i % n].recall() < 0.5; };
    std::optional<double> nearest;
    for (std::size_t first = 0; first < n; ++first) {
        if (!is_lost(first) || is_lost(first + n - 1)) continue;
        std::size_t last = first;
        while (is_lost(last + 1))
            ++last;
        const double width = static_cast<double>(last - first) * kTurn_rad / static_cast<double>(n);
        const double middle = samples[first].roll_rad + width / 2;
        const double off = std::abs(turn_between(predicted_rad, middle));
        if (off > kNear_rad + width / 2) continue;
        if (!nearest || off < std::abs(turn_between(predicted_rad, *nearest))) nearest = middle;
    }
    if (nearest) *nearest = std::fmod(*nearest, kTurn_rad);
    return nearest;
}

std::vector<RollCurve> study_roll(const std::vector<Entrant>& entrants,
                                  const RollOptions& options) {
    const scene::Scene scene = roll_scene();
    const scene::CameraPath path = roll_path(scene, options);
    std::vector<std::unique_ptr<PreparedMethod>> methods;
    for (const Entrant& entrant : entrants)
        methods.push_back(std::make_unique<PreparedMethod>(entrant, scene));
    truth::TruthOptions truth_options;
    truth_options.threads = core::hardware_threads();
    truth_options.layers = false;
    truth::SceneModel model(scene, truth_options);
    MeasureOptions once = options.measure;
    once.max_repetitions = 0;  // the first round draws, and is not timed

    core::Progress progress("cube roll", path.frame_count);
    std::vector<Crease> creases;
    std::vector<Entry> entries;
    for (int frame = 0; frame < path.frame_count; ++frame) {
        if (is_interrupted()) return {};
        progress.report(frame, "");
        const scene::View view = scene::frame_at(path, frame).view;
        const truth::Truth truth = truth::cached_truth(model, view, options.cache);
        if (frame == 0) {
            creases = creases_of(truth, scene);
            for (const auto& method : methods)
                entries.push_back(make_entry(*method, scene, creases, path.start.camera));
        }
        std::vector<edge::EdgeImage> pictures;
        const std::vector<DrawTimes> times = draw_in_turns(methods, view, once, pictures);
        core::parallel_for(entries.size(), core::hardware_threads(), [&](std::size_t i) {
            entries[i].has_failed = entries[i].has_failed || !times[i].failure.empty();
            if (entries[i].has_failed) return;
            const int threshold = methods[i]->threshold();
            take(pictures[i], threshold, truth, creases, frame * path.turn_rad, entries[i]);
        });
    }

    std::vector<RollCurve> curves;
    for (Entry& entry : entries) {
        if (entry.has_failed) continue;
        for (std::size_t i = 0; i < entry.curves.size(); ++i) {
            RollCurve& curve = entry.curves[i];
            if (entry.predictions[i]) {
                for (const double angle_rad : entry.predictions[i]->vanishing_rad()) {
                    curve.vanishing.push_back(
                        {angle_rad, measured_vanishing(curve.samples, angle_rad)});
                }
            }
            curves.push_back(std::move(curve));
        }
    }
    return curves;
}

}  // namespace ink::lab
