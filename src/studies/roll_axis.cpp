#include "studies/roll_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <set>
#include <utility>

#include "catalogue/shapes.h"
#include "core/parallel.h"
#include "harness/cell.h"
#include "scene/surface.h"
#include "scene/topology.h"
#include "scene/views/camera_path.h"
#include "score/drawing.h"
#include "score/motion.h"
#include "studies/motion_study.h"
#include "studies/roll_prediction.h"

namespace ink::studies {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;
constexpr double kRadPerDeg = std::numbers::pi / 180;

/// A crease of the scene: its edge, and a global triangle on either side.
struct Crease {
    std::uint32_t edge = 0;
    std::uint32_t triangle0 = 0;
    std::uint32_t triangle1 = 0;
};

/// What a method makes of each crease, as its code foretells.
using Predictions = std::vector<std::optional<RollPrediction>>;

scene::View view_at(const scene::Scene& cube, double roll_deg, int size_px) {
    return {rolled_camera(cube, roll_deg), size_px, size_px};
}

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
    const glm::dvec3 to_eye_world = -camera.viewpoint().sight(surface.p_world[corners[0]]);
    const double side = glm::dot(to_eye_world, glm::dvec3(n_world)) < 0 ? -1 : 1;
    return side * (camera.view_from_world * glm::dvec3(n_world));
}

Predictions predict(const method::MethodConfig& config,
                    const scene::Scene& cube,
                    const std::vector<Crease>& creases,
                    const scene::Camera& start) {
    Predictions predictions(creases.size());
    harness::PreparedMethod prepared(config, cube);
    if (!prepared.failure().empty()) return predictions;
    const std::optional<method::LinearCode> code = prepared.method().code();
    if (!code) return predictions;
    const scene::Surface surface =
        scene::flatten(cube, code->inputs.normals, code->inputs.crease_rad);
    for (std::size_t i = 0; i < creases.size(); ++i) {
        const auto n0 = flat_normal(surface, creases[i].triangle0, start);
        const auto n1 = flat_normal(surface, creases[i].triangle1, start);
        if (n0 && n1) predictions[i].emplace(*code, CreaseNormals{*n0, *n1});
    }
    return predictions;
}

/// As it is written into the column `value`.
double degrees_of(double angle_rad) {
    return std::stod(fmt::format("{:.10g}", angle_rad / kRadPerDeg));
}

/// What holds at every angle.
struct Cube {
    RollOptions options;
    scene::Scene scene = roll_scene();
    std::vector<Crease> creases = {};
    std::vector<Predictions> predictions = {};  ///< by method

    Cube(const std::vector<method::MethodConfig>& configs, const RollOptions& asked)
        : options(asked) {
        const scene::View start = view_at(scene, 0, options.size_px);
        creases = creases_of(truth::trace_truth(scene, start, {}), scene);
        for (const method::MethodConfig& config : configs)
            predictions.push_back(predict(config, scene, creases, start.camera));
    }

    [[nodiscard]] std::vector<double> even_angles_deg() const {
        std::vector<double> angles_deg;
        for (int i = 0; i < options.angles; ++i)
            angles_deg.push_back(i * 360.0 / options.angles);
        return angles_deg;
    }

    [[nodiscard]] std::vector<double> all_angles_deg() const {
        std::vector<double> even = even_angles_deg();
        std::set<double> angles_deg(even.begin(), even.end());
        for (const Predictions& of_method : predictions) {
            for (const auto& prediction : of_method) {
                if (!prediction) continue;
                for (const double angle_rad : prediction->vanishing_rad())
                    angles_deg.insert(degrees_of(angle_rad));
            }
        }
        return {angles_deg.begin(), angles_deg.end()};
    }
};

/// What an image shows of each crease.
std::vector<RollSample> see_creases(const harness::Evaluation& drawn,
                                    const truth::Truth& truth,
                                    const std::vector<Crease>& creases) {
    const score::ScoreOptions options = harness::score_options(drawn.threshold);
    const score::Strokes strokes = score::make_strokes(drawn.image, drawn.threshold, options);
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

class RollObserver final : public AxisObserver {
  public:
    explicit RollObserver(std::shared_ptr<const Cube> cube)
        : cube_(std::move(cube)),
          even_deg_(cube_->even_angles_deg()),
          seen_(cube_->predictions.size()) {}

    void see(const Case& one,
             const harness::TracedView& traced,
             std::span<const harness::Evaluation> drawn,
             std::int64_t first_cell) override {
        if (!traced.has_truth()) return;
        std::vector<std::vector<RollSample>> samples(seen_.size());
        core::parallel_for(seen_.size(), core::hardware_threads(), [&](std::size_t m) {
            if (drawn[m].row.is_ok())
                samples[m] = see_creases(drawn[m], traced.truth.traced, cube_->creases);
        });
        for (std::size_t m = 0; m < seen_.size(); ++m)
            note(m, one.value, first_cell + static_cast<std::int64_t>(m), drawn[m], samples[m]);
    }

    Lines lines() override {
        for (std::size_t m = 0; m < seen_.size(); ++m) {
            for (std::size_t crease = 0; crease < cube_->creases.size(); ++crease) {
                if (const auto& prediction = cube_->predictions[m][crease])
                    add_vanishing(seen_[m], crease, *prediction);
            }
        }
        return std::move(lines_);
    }

  private:
    /// What a method drew at an angle.
    struct Angle {
        std::int64_t cell = 0;
        std::vector<RollSample> samples;  ///< by crease
    };
    using Turn = std::map<double, Angle>;  ///< by degrees

    void note(std::size_t m,
              double roll_deg,
              std::int64_t cell,
              const harness::Evaluation& drawn,
              std::vector<RollSample>& samples) {
        const bool is_even = std::binary_search(even_deg_.begin(), even_deg_.end(), roll_deg);
        for (std::size_t crease = 0; crease < samples.size(); ++crease) {
            RollSample& sample = samples[crease];
            const auto& prediction = cube_->predictions[m][crease];
            sample.crease = static_cast<int>(crease);
            sample.is_predicted = prediction.has_value();
            sample.roll_rad = roll_deg * kRadPerDeg;
            if (prediction) {
                sample.step = prediction->step(sample.roll_rad);
                sample.is_blind = prediction->is_blind(sample.roll_rad, drawn.threshold);
            }
            if (!is_even) continue;
            lines_["creases.csv"] += creases_table().line(cell, sample);
        }
        if (!samples.empty()) seen_[m][roll_deg] = {cell, std::move(samples)};
    }

    void add_vanishing(const Turn& turn, std::size_t crease, const RollPrediction& prediction) {
        std::vector<RollSample> even;
        for (const double angle_deg : even_deg_) {
            const auto at = turn.find(angle_deg);
            if (at != turn.end()) even.push_back(at->second.samples[crease]);
        }
        for (const double angle_rad : prediction.vanishing_rad()) {
            const auto at = turn.find(degrees_of(angle_rad));
            if (at == turn.end()) continue;
            lines_["vanishing.csv"] +=
                vanishing_table().line(at->second.cell,
                                       {static_cast<int>(crease),
                                        angle_rad,
                                        measured_vanishing(even, angle_rad),
                                        at->second.samples[crease].recall()});
        }
    }

    std::shared_ptr<const Cube> cube_;
    std::vector<double> even_deg_;
    std::vector<Turn> seen_;  ///< by method
    Lines lines_;
};

/// From one angle to another the short way, -pi..pi.
double turn_between(double from_rad, double to_rad) {
    return std::remainder(to_rad - from_rad, kTurn_rad);
}

}  // namespace

std::optional<double> measured_vanishing(const std::vector<RollSample>& samples,
                                         double predicted_rad) {
    constexpr double kNear_rad = 15 * kRadPerDeg;
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

scene::Scene roll_scene() {
    scene::Scene scene;
    scene.name = "cube_roll";
    scene.meshes.push_back(catalogue::make_box({-1, -1, -1}, {1, 1, 1}));
    scene.instances.push_back({});
    return scene;
}

scene::Camera rolled_camera(const scene::Scene& scene, double roll_deg) {
    scene::View view{
        scene::look_at(
            {4, 3.375, 6.4375}, glm::dvec3(0), {0, 1, 0}, scene::Camera{}.fov_y_rad / 1.5),
        1,
        1};
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    scene::fit_clip_range(view.camera, bounds);
    scene::CameraPath path = scene::make_path(scene::PathKind::roll, view, bounds, 0);
    path.turn_rad = roll_deg * kRadPerDeg;
    return scene::frame_at(path, 1).view.camera;
}

Axis roll_axis(const std::vector<method::MethodConfig>& configs, const RollOptions& options) {
    const auto cube = std::make_shared<const Cube>(configs, options);
    Axis axis;
    axis.name = "roll";
    axis.title = "roll of the camera";
    axis.unit = "deg";
    axis.scale = AxisScale::linear;
    axis.values = cube->all_angles_deg();
    axis.sentence = "A camera rolls once round in front of a cube.";
    axis.study = harness::Study::roll;
    axis.scene = cube->scene.name;
    axis.cases_of_value = 1;
    axis.cases = [cube](double value, const CaseSize&) {
        Case one{
            "roll", value, {cube->scene, {view_at(cube->scene, value, cube->options.size_px)}}};
        one.scene_views.views.front().camera.name = fmt::format("roll={}", value);
        return std::vector<Case>{std::move(one)};
    };
    axis.observer = [cube] { return std::make_unique<RollObserver>(cube); };
    axis.tables = {creases_table(), vanishing_table()};
    return axis;
}

}  // namespace ink::studies
