#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "harness/method_configs.h"

namespace ink::studies {

/// What grows while everything else stays as it is.
enum class ScalingAxis {
    triangles,  ///< of a sphere that keeps its place in the image
    pixels,     ///< of the image
    covered,    ///< the share of the image that the sphere's disc fills
};

struct ScalingAxisInfo {
    ScalingAxis axis;
    std::string_view name;   ///< as in scaling.csv
    std::string_view noun;   ///< what x counts, in a sentence
    std::string_view title;  ///< of its chart's horizontal axis, with the unit
};
[[nodiscard]] const std::array<ScalingAxisInfo, 3>& scaling_axes();

/// Two least times of one frame differ by this share at least, whatever the machine.
inline constexpr double kTimeNoise = 0.1;

/// The least time of one method at one place on one axis.
struct ScalingPoint {
    ScalingAxis axis = ScalingAxis::triangles;
    std::string method;
    std::string params;  ///< every parameter, as in rows.csv
    double x = 0;        ///< in the axis' unit
    int width_px = 0;
    int height_px = 0;
    std::int64_t triangles = 0;
    double covered_share = 0;  ///< of the image, 0..1
    int threads = 1;
    std::int64_t draw_ns_min = 0;
    int draw_n = 0;             ///< timed frames
    double noise = kTimeNoise;  ///< how far off draw_ns_min may be, as a share of it
    std::string status = "ok";  ///< or why nothing was timed

    [[nodiscard]] bool is_timed() const { return draw_ns_min > 0; }
};

/// How a sphere is timed.
struct ScalingOptions {
    int threads = 1;
    double budget_s = 0.4;  ///< a method at a point stops repeating after this much drawing
};

/// One of the spheres of the study.
struct ScalingSphere {
    std::int64_t triangles = 0;
    int points = 0;  ///< of a method, over all axes
    double mpx = 0;  ///< of all its images
};

/// The spheres made by code that are drawn: 10^2 to 10^6 triangles, 0.3 to 33 million pixels, a
/// thousandth to all of the image covered.
[[nodiscard]] std::vector<ScalingSphere> scaling_spheres();

/// Draws the n-th sphere with every configuration, in turns, and takes the least times.
///
/// A point's noise is what its three rounds say: how far the second of their least times lies above
/// the first, kTimeNoise at least. A method that fails at a point has one there without
/// times, which says why. Ctrl-C ends it after a round, without points.
[[nodiscard]] std::vector<ScalingPoint> time_sphere(
    const std::vector<harness::MethodConfig>& configs,
    std::size_t sphere,
    const ScalingOptions& options);

}  // namespace ink::studies
