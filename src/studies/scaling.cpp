#include "studies/scaling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>

#include "catalogue/shapes.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "harness/cell.h"

namespace ink::studies {
namespace {

constexpr int kRounds = 3;
constexpr int kRepetitions = 15;  // of a round, at most

/// An image to time: which sphere, how large an image, how much of it covered.
struct Station {
    std::vector<ScalingAxis> axes;  ///< on which it is a point
    std::int64_t triangles = 10'000;
    int width_px = 1280;
    int height_px = 720;
    double covered_share = 0.25;  ///< the disc then touches no side of any of the images
};

/// All stations, by sphere, so that each is prepared once. The middle one lies on every axis.
std::vector<std::vector<Station>> stations() {
    using enum ScalingAxis;
    std::vector<Station> of_middle = {{.axes = {triangles, pixels, covered}},
                                      {.axes = {pixels}, .width_px = 640, .height_px = 480},
                                      {.axes = {pixels}, .width_px = 1920, .height_px = 1080},
                                      {.axes = {pixels}, .width_px = 3840, .height_px = 2160},
                                      {.axes = {pixels}, .width_px = 7680, .height_px = 4320}};
    for (const double share : {0.001, 0.004, 0.016, 0.064, 1.0})
        of_middle.push_back({.axes = {covered}, .covered_share = share});
    return {{{.axes = {triangles}, .triangles = 100}},
            {{.axes = {triangles}, .triangles = 1'000}},
            of_middle,
            {{.axes = {triangles}, .triangles = 100'000}},
            {{.axes = {triangles}, .triangles = 1'000'000}}};
}

/// A ball of radius 1 of about `triangles`, twice as many segments as stacks.
scene::Scene sphere_scene(std::int64_t triangles) {
    // 2 * segments * (stacks - 1) triangles with segments = 2 * stacks.
    const double stacks = std::sqrt(static_cast<double>(triangles) / 4 + 0.25) + 0.5;
    const int rounded = std::max(3, static_cast<int>(std::lround(stacks)));
    scene::Scene scene;
    scene.name = fmt::format("sphere of {} triangles", triangles);
    scene.meshes.push_back(catalogue::make_sphere(1, 2 * rounded, rounded));
    scene.instances.push_back({});
    return scene;
}

/// A camera that sees the unit ball's disc fill `share` of the image, its middle in the middle;
/// all of it from a share of 1 on.
scene::View view_of(const Station& station, const scene::Scene& scene) {
    const double width = station.width_px;
    const double height = station.height_px;
    const double radius_px =
        station.covered_share < 1
            ? std::sqrt(station.covered_share * width * height / std::numbers::pi)
            : 1.05 * std::hypot(width, height) / 2;
    const scene::Camera any;
    const double focal_px = height / 2 / std::tan(any.fov_y_rad / 2);
    // The rim of the ball is seen at the angle whose sine is 1 / distance.
    const double distance = 1 / std::sin(std::atan(radius_px / focal_px));
    const glm::dvec3 direction = glm::dvec3(3, 2, 6) / 7.0;
    scene::View view{scene::look_at(distance * direction, glm::dvec3(0), {0, 1, 0}, any.fov_y_rad),
                     station.width_px,
                     station.height_px};
    scene::fit_clip_range(view.camera, scene::bounding_sphere(scene));
    return view;
}

double x_of(const ScalingPoint& point) {
    switch (point.axis) {
        case ScalingAxis::triangles:
            return static_cast<double>(point.triangles);
        case ScalingAxis::pixels:
            return static_cast<double>(point.width_px) * point.height_px;
        case ScalingAxis::covered:
            return point.covered_share;
    }
    return 0;
}

/// Times of one method at one station, over all rounds.
struct RoundTimes {
    harness::DrawTimes all;
    std::vector<std::int64_t> least_ns;  ///< of each round

    void append(harness::DrawTimes&& round) {
        if (all.failure.empty()) all.failure = std::move(round.failure);
        if (round.draw_ns.empty()) return;
        least_ns.push_back(*std::min_element(round.draw_ns.begin(), round.draw_ns.end()));
        all.draw_ns.insert(all.draw_ns.end(), round.draw_ns.begin(), round.draw_ns.end());
    }

    [[nodiscard]] double noise() const {
        if (least_ns.size() < 2) return kTimeNoise;
        std::vector<std::int64_t> sorted = least_ns;
        std::sort(sorted.begin(), sorted.end());
        const auto second = static_cast<double>(sorted[1]);
        return std::max(kTimeNoise, second / static_cast<double>(sorted[0]) - 1);
    }
};
using Times = std::vector<RoundTimes>;

/// A sphere with every method ready for it.
class PreparedSphere {
  public:
    PreparedSphere(const std::vector<harness::MethodConfig>& configs, std::int64_t triangles)
        : scene_(sphere_scene(triangles)) {
        for (const harness::MethodConfig& config : configs)
            methods_.push_back(std::make_unique<harness::PreparedMethod>(config, scene_));
    }

    void draw(const Station& station, const harness::MeasureOptions& measure, Times& times) {
        std::vector<edge::EdgeImage> images;
        std::vector<harness::DrawTimes> round =
            harness::draw_in_turns(methods_, view_of(station, scene_), measure, images);
        times.resize(round.size());
        for (std::size_t i = 0; i < round.size(); ++i)
            times[i].append(std::move(round[i]));
    }

    [[nodiscard]] std::vector<ScalingPoint> points(const Station& station,
                                                   const Times& times,
                                                   int threads) const {
        std::vector<ScalingPoint> points;
        for (std::size_t i = 0; i < methods_.size(); ++i) {
            harness::Row row = methods_[i]->row();
            const std::string& failure = times[i].all.failure;
            if (failure.empty()) harness::fill_times(times[i].all.draw_ns, row);
            ScalingPoint point{.method = row.method,
                               .params = row.params,
                               .width_px = station.width_px,
                               .height_px = station.height_px,
                               .covered_share = station.covered_share,
                               .threads = threads,
                               .draw_ns_min = row.draw_ns_min.value_or(0),
                               .draw_n = row.draw_n,
                               .noise = times[i].noise(),
                               .status = failure.empty() ? "ok" : failure};
            point.triangles = static_cast<std::int64_t>(scene::triangle_count(scene_));
            for (const ScalingAxis axis : station.axes) {
                point.axis = axis;
                point.x = x_of(point);
                points.push_back(point);
            }
        }
        return points;
    }

  private:
    scene::Scene scene_;
    std::vector<std::unique_ptr<harness::PreparedMethod>> methods_;
};

/// One sphere at all its stations, round after round: what slows the machine for a second then
/// spoils one round of several stations, not all rounds of one.
std::vector<ScalingPoint> measure(const std::vector<harness::MethodConfig>& configs,
                                  const std::vector<Station>& stations,
                                  const ScalingOptions& options) {
    PreparedSphere sphere(configs, stations.front().triangles);
    const harness::MeasureOptions once{.threads = options.threads,
                                       .min_repetitions = 1,
                                       .max_repetitions = kRepetitions,
                                       .budget_s = options.budget_s / kRounds};
    std::vector<Times> times(stations.size());
    for (int round = 0; round < kRounds && !core::is_interrupted(); ++round) {
        for (std::size_t i = 0; i < stations.size(); ++i)
            sphere.draw(stations[i], once, times[i]);
    }
    std::vector<ScalingPoint> points;
    for (std::size_t i = 0; i < stations.size() && !core::is_interrupted(); ++i) {
        std::vector<ScalingPoint> more = sphere.points(stations[i], times[i], options.threads);
        std::move(more.begin(), more.end(), std::back_inserter(points));
    }
    return points;
}

}  // namespace

const std::array<ScalingAxisInfo, 3>& scaling_axes() {
    static constexpr std::array<ScalingAxisInfo, 3> kAxes = {{
        {ScalingAxis::triangles, "triangles", "triangles", "triangles of the sphere"},
        {ScalingAxis::pixels, "pixels", "pixels", "pixels of the image"},
        {ScalingAxis::covered, "covered", "of the image", "share of the image that is covered"},
    }};
    return kAxes;
}

std::vector<ScalingSphere> scaling_spheres() {
    std::vector<ScalingSphere> spheres;
    for (const std::vector<Station>& of_sphere : stations()) {
        ScalingSphere sphere{of_sphere.front().triangles, 0, 0};
        for (const Station& station : of_sphere) {
            sphere.points += static_cast<int>(station.axes.size());
            sphere.mpx += 1e-6 * station.width_px * station.height_px;
        }
        spheres.push_back(sphere);
    }
    return spheres;
}

std::vector<ScalingPoint> time_sphere(const std::vector<harness::MethodConfig>& configs,
                                      std::size_t sphere,
                                      const ScalingOptions& options) {
    return measure(configs, stations().at(sphere), options);
}

}  // namespace ink::studies
