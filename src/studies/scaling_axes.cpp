#include "studies/scaling_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "catalogue/shapes.h"

namespace ink::studies {
namespace {

/// What stays as it is along the other axes. The disc then touches no side of any of the images.
constexpr double kTriangles = 10'000;
constexpr CaseSize kSize{1280, 720};
constexpr double kCovered = 0.25;

constexpr CaseSize kSizes[] = {{640, 480}, kSize, {1920, 1080}, {3840, 2160}, {7680, 4320}};

/// A ball of radius 1 of about `triangles`, twice as many segments as stacks.
scene::Mesh ball_of(double triangles) {
    // 2 * segments * (stacks - 1) triangles with segments = 2 * stacks.
    const double stacks = std::sqrt(triangles / 4 + 0.25) + 0.5;
    const int rounded = std::max(3, static_cast<int>(std::lround(stacks)));
    return catalogue::make_sphere(1, 2 * rounded, rounded);
}

/// A camera that sees the unit ball's disc fill `share` of the image, its middle in the middle;
/// all of it from a share of 1 on.
scene::View view_of(double share, const CaseSize& size, const scene::Scene& scene) {
    const double width = size.width_px;
    const double height = size.height_px;
    const double radius_px = share < 1 ? std::sqrt(share * width * height / std::numbers::pi)
                                       : 1.05 * std::hypot(width, height) / 2;
    const scene::Camera any;
    const double focal_px = height / 2 / std::tan(any.fov_y_rad / 2);
    // The rim of the ball is seen at the angle whose sine is 1 / distance.
    const double distance = 1 / std::sin(std::atan(radius_px / focal_px));
    const glm::dvec3 direction = glm::dvec3(3, 2, 6) / 7.0;
    scene::View view{scene::look_at(distance * direction, glm::dvec3(0), {0, 1, 0}, any.fov_y_rad),
                     size.width_px,
                     size.height_px};
    scene::fit_clip_range(view.camera, scene::bounding_sphere(scene));
    return view;
}

struct Ball {
    double triangles = kTriangles;
    CaseSize size = kSize;
    double covered = kCovered;
};

Case case_of(const char* axis, double value, const Ball& ball) {
    Case one{axis, value, {}};
    scene::Scene& scene = one.scene_views.scene;
    scene.name = "scaling_sphere";
    scene.meshes.push_back(ball_of(ball.triangles));
    scene.instances.push_back({});
    one.scene_views.views.push_back(view_of(ball.covered, ball.size, scene));
    one.scene_views.views.front().camera.name = fmt::format("{}={}", axis, value);
    return one;
}

/// The sphere of an axis at a value.
using BallAt = Ball (*)(double value);

Axis make_axis(const char* name, std::string title, std::string sentence, BallAt ball_at) {
    Axis axis;
    axis.name = name;
    axis.title = std::move(title);
    axis.sentence = std::move(sentence);
    axis.study = harness::Study::scaling;
    axis.is_scored = false;
    axis.repetitions = 45;
    axis.budget_s = 0.4;
    axis.cases = [name, ball_at](double value, const CaseSize&) {
        return std::vector<Case>{case_of(name, value, ball_at(value))};
    };
    return axis;
}

double pixels(const CaseSize& size) {
    return static_cast<double>(size.width_px) * size.height_px;
}

}  // namespace

std::vector<Axis> scaling_axes() {
    std::vector<Axis> axes = {
        make_axis("triangles",
                  "triangles of the sphere",
                  "A sphere that covers a quarter of 1280 x 720 px, of more and more triangles.",
                  [](double value) { return Ball{.triangles = value}; }),
        make_axis("pixels",
                  "pixels of the image",
                  "A sphere of ten thousand triangles that covers a quarter of the image.",
                  [](double value) {
                      const auto* size = std::find_if(std::begin(kSizes),
                                                      std::end(kSizes) - 1,
                                                      [&](auto& s) { return pixels(s) == value; });
                      return Ball{.size = *size};
                  }),
        make_axis("covered",
                  "share of the image that is covered",
                  "A sphere of ten thousand triangles at 1280 x 720 px, from so far that it is a "
                  "speck to so near that it fills the image.",
                  [](double value) { return Ball{.covered = value}; })};
    for (const double about : {1e2, 1e3, 1e4, 1e5, 1e6})
        axes[0].values.push_back(static_cast<double>(ball_of(about).triangles.size()));
    for (const CaseSize& size : kSizes)
        axes[1].values.push_back(pixels(size));
    axes[2].values = {0.001, 0.004, 0.016, 0.064, kCovered, 1};
    return axes;
}

}  // namespace ink::studies
