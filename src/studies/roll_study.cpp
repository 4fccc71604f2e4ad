#include "studies/roll_study.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <set>

#include "catalogue/shapes.h"
#include "core/interrupt.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "linear_code/roll_prediction.h"
#include "scene/surface.h"
#include "scene/topology.h"
#include "score/drawing.h"
#include "score/motion.h"
#include "studies/motion_study.h"
#include "truth/truth_cache.h"

namespace ink::studies {
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
    RollCurve failed;  ///< instead of the curves, once its status is not ok
    std::vector<RollCurve> curves;
    std::vector<std::optional<linear_code::RollPrediction>> predictions;

    [[nodiscard]] bool has_failed() const { return failed.status != "ok"; }
};

Entry make_entry(harness::PreparedMethod& prepared,
                 const scene::Scene& scene,
                 const std::vector<Crease>& creases,
                 const scene::Camera& start) {
    const harness::Row row = prepared.row();
    Entry entry;
    entry.failed = {.method = row.method, .params = row.params, .status = row.status};
    if (entry.has_failed()) return entry;
    const std::optional<method::LinearCode> code = prepared.method().code();
    scene::Surface surface;
    if (code) surface = scene::flatten(scene, code->inputs.normals, code->inputs.crease_rad);
    for (std::size_t i = 0; i < creases.size(); ++i) {
        RollCurve curve{.method = row.method, .params = row.params, .crease = static_cast<int>(i)};
        std::optional<linear_code::RollPrediction> prediction;
        if (code) {
            const auto n0 = flat_normal(surface, creases[i].triangle0, start);
            const auto n1 = flat_normal(surface, creases[i].triangle1, start);
            if (n0 && n1) prediction.emplace(*code, linear_code::CreaseNormals{*n0, *n1});
        }
        curve.is_predicted = prediction.has_value();
        entry.curves.push_back(std::move(curve));
        entry.predictions.push_back(prediction);
    }
    return entry;
}

/// What an image shows of each crease, by its place in `creases`.
std::vector<RollSample> see_creases(const edge::EdgeImage& image,
                                    int threshold,
                                    const truth::Truth& truth,
                                    const std::vector<Crease>& creases) {
    const score::ScoreOptions options = harness::score_options(threshold);
    const score::Strokes strokes = score::make_strokes(image, threshold, options);
    const score::ScoringTruth scoring = unbanded_truth(truth, score::Intersections::above_crease);
    std::vector<RollSample> samples(creases.size());
    for (const score::FeatureSight& sight :
         score::see_features(truth.curves, strokes.thinned.bytes(), scoring, options)) {
        if (sight.feature.line_class != truth::LineClass::crease) continue;
        for (std::size_t i = 0; i < creases.size(); ++i) {
            if (creases[i].edge != sight.feature.edge) continue;
            samples[i].length_px = sight.length_px;
            samples[i].covered_px = sight.covered_px;
        }
    }
    return samples;
}

/// The study under way: everything that does not depend on the angle.
class Roll {
  public:
    Roll(const std::vector<harness::MethodConfig>& configs, const RollOptions& options)
        : options_(options),
          scene_(roll_scene()),
          path_(roll_path(scene_, options)),
          model_(scene_, truth_options()) {
        options_.measure.max_repetitions = 0;  // the first round draws, and is not timed
        for (const harness::MethodConfig& config : configs)
            methods_.push_back(std::make_unique<harness::PreparedMethod>(config, scene_));
        creases_ = creases_of(trace(0), scene_);
        for (const auto& method : methods_)
            entries_.push_back(make_entry(*method, scene_, creases_, path_.start.camera));
    }

    void turn_round() {
        core::Progress progress("cube roll", path_.frame_count);
        for (int frame = 0; frame < path_.frame_count && !core::is_interrupted(); ++frame) {
            progress.report(frame, "");
            const double roll_rad = frame * path_.turn_rad;
            draw(roll_rad, [&](Entry& entry, std::size_t i, const RollSample& sample) {
                entry.curves[i].samples.push_back(sample);
            });
        }
    }

    /// Draws the very angles at which something must vanish.
    void visit_predictions() {
        std::set<double> angles_rad;
        for (Entry& entry : entries_) {
            for (std::size_t i = 0; i < entry.curves.size(); ++i) {
                RollCurve& curve = entry.curves[i];
                if (!entry.predictions[i]) continue;
                for (const double angle_rad : entry.predictions[i]->vanishing_rad()) {
                    curve.vanishing.push_back(
                        {angle_rad, measured_vanishing(curve.samples, angle_rad)});
                    angles_rad.insert(angle_rad);
                }
            }
        }
        for (const double angle_rad : angles_rad) {
            if (core::is_interrupted()) return;
            draw(angle_rad, [&](Entry& entry, std::size_t i, const RollSample& sample) {
                for (Vanishing& at : entry.curves[i].vanishing) {
                    if (at.predicted_rad == angle_rad) at.recall_there = sample.recall();
                }
            });
        }
    }

    [[nodiscard]] std::vector<RollCurve> curves() const {
        std::vector<RollCurve> curves;
        for (const Entry& entry : entries_) {
            if (entry.has_failed()) {
                curves.push_back(entry.failed);
                continue;
            }
            curves.insert(curves.end(), entry.curves.begin(), entry.curves.end());
        }
        return curves;
    }

  private:
    static truth::TruthOptions truth_options() {
        truth::TruthOptions options;
        options.threads = core::hardware_threads();
        options.layers = false;
        return options;
    }

    [[nodiscard]] scene::View view_at(double roll_rad) const {
        scene::CameraPath path = path_;
        path.turn_rad = roll_rad;
        return scene::frame_at(path, 1).view;
    }
    [[nodiscard]] truth::Truth trace(double roll_rad) {
        return truth::cached_truth(model_, view_at(roll_rad), options_.cache);
    }

    /// Draws one angle with every method and gives `take` a sample of each crease.
    template <class Take>
    void draw(double roll_rad, Take take) {
        const truth::Truth truth = trace(roll_rad);
        std::vector<edge::EdgeImage> images;
        const std::vector<harness::DrawTimes> times =
            harness::draw_in_turns(methods_, view_at(roll_rad), options_.measure, images);
        core::parallel_for(entries_.size(), core::hardware_threads(), [&](std::size_t m) {
            Entry& entry = entries_[m];
            if (!entry.has_failed() && !times[m].failure.empty())
                entry.failed.status = times[m].failure;
            if (entry.has_failed()) return;
            const int threshold = methods_[m]->threshold();
            auto samples = see_creases(images[m], threshold, truth, creases_);
            for (std::size_t i = 0; i < samples.size(); ++i) {
                samples[i].roll_rad = roll_rad;
                if (const auto& prediction = entry.predictions[i]) {
                    samples[i].step = prediction->step(roll_rad);
                    samples[i].is_blind = prediction->is_blind(roll_rad, threshold);
                }
                take(entry, i, samples[i]);
            }
        });
    }

    RollOptions options_;
    scene::Scene scene_;
    scene::CameraPath path_;
    truth::SceneModel model_;
    std::vector<std::unique_ptr<harness::PreparedMethod>> methods_;
    std::vector<Crease> creases_;
    std::vector<Entry> entries_;
};

}  // namespace

scene::Scene roll_scene() {
    scene::Scene scene;
    scene.name = "cube_roll";
    scene.meshes.push_back(catalogue::make_box({-1, -1, -1}, {1, 1, 1}));
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

std::vector<RollCurve> study_roll(const std::vector<harness::MethodConfig>& configs,
                                  const RollOptions& options) {
    Roll roll(configs, options);
    roll.turn_round();
    roll.visit_predictions();
    return core::is_interrupted() ? std::vector<RollCurve>{} : roll.curves();
}

}  // namespace ink::studies
