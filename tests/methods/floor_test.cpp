// A flat floor that fills the frame has no outline. Which depth encodings know that?

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "small_scenes.h"

namespace ink::methods {
namespace {

constexpr int kHeight_px = 100;
constexpr double kFov_deg = 20;
const std::vector<double> kAngles_deg = {20, 10, 5, 3, 2, 1.5, 1, 0.7, 0.5, 0.2, 0.1};

/// Seen from one unit above a floor, the frame's top edge `grazing_deg` below the horizon.
scene::View view_over_floor(double grazing_deg) {
    const double pitch = glm::radians(grazing_deg + kFov_deg / 2);
    scene::View view;
    view.camera = scene::look_at(
        {0, 1, 0}, {0, 1 - std::sin(pitch), -std::cos(pitch)}, {0, 1, 0}, glm::radians(kFov_deg));
    view.width_px = 130;
    view.height_px = kHeight_px;
    return view;
}

/// Distance along the gaze of the floor at the middle of every row.
std::vector<double> row_distances_w(const scene::View& view) {
    const scene::Projection projection(view);
    std::vector<double> w;
    for (int y = 0; y < view.height_px; ++y)
        w.push_back(-1 / projection.ray_world(65, y + 0.5).y);
    return w;
}

/// Whether there is a line anywhere but in the frame's own row of pixels, where a stencil reaches
/// beyond the picture and sees half a slope.
bool has_line(const edge::EdgeImage& image) {
    for (int y = 1; y + 1 < image.height_px(); ++y) {
        const std::uint8_t* row = image.row(y);
        if (std::any_of(row + 1, row + image.width_px() - 1, [](int s) { return s > 0; }))
            return true;
    }
    return false;
}

TEST(Floor, NoMethodDrawsOnIt) {
    const scene::Scene scene = scene_of({floor_mesh(4000)});
    for (const MethodInfo& info : registry()) {
        for (const double angle_deg : kAngles_deg) {
            scene::View view = view_over_floor(angle_deg);
            view.camera.near = 0.1;
            EXPECT_FALSE(has_line(drawn(info.name, {}, scene, {view, 1})))
                << info.name << " at " << angle_deg << " degrees";
        }
    }
}

/// The same by the definition: the exact distance of every row, encoded, quantised to 0..255,
/// filtered.
bool definition_fires(const scene::View& view, raster::DepthEncoding encoding) {
    std::vector<int> code;
    for (const double w : row_distances_w(view)) {
        const double d = raster::encode_depth(encoding, w, {view.camera.near, view.camera.far});
        code.push_back(static_cast<int>(std::lround(255 * d)));
    }
    for (std::size_t y = 1; y + 1 < code.size(); ++y) {
        if (std::abs(2 * code[y] - code[y - 1] - code[y + 1]) > 3) return true;
    }
    return false;
}

struct Case {
    std::string encoding;
    double fires_from_deg;  ///< the largest of kAngles_deg at which it draws a line; 0: at none
};

class FloorEncoding : public testing::TestWithParam<Case> {};

TEST_P(FloorEncoding, FiresFromItsGrazingAngleOn) {
    const std::vector<std::string> names = {
        "inverse", "linear", "log", "zbuffer24", "zbuffer16", "reversed_float"};
    const auto index = std::find(names.begin(), names.end(), GetParam().encoding) - names.begin();
    const scene::Scene scene = scene_of({floor_mesh(4000)});
    for (const double angle_deg : kAngles_deg) {
        scene::View view = view_over_floor(angle_deg);
        const std::vector<double> w = row_distances_w(view);
        view.camera.near = w.back() * 0.9;
        view.camera.far = w.front() * 1.1;
        const auto image = drawn("mote2",
                                 {{"packing", "pixel"},
                                  {"depth_range", "camera"},
                                  {"depth_encoding", GetParam().encoding},
                                  {"range_depth", "255"},
                                  {"range_normal", "0"}},
                                 scene,
                                 {view, 1});
        const bool fires = angle_deg <= GetParam().fires_from_deg;
        EXPECT_EQ(has_line(image), fires) << angle_deg << " degrees";
        EXPECT_EQ(definition_fires(view, static_cast<raster::DepthEncoding>(index)), fires)
            << angle_deg << " degrees";
    }
}

INSTANTIATE_TEST_SUITE_P(Table,
                         FloorEncoding,
                         testing::Values(Case{"inverse", 0},
                                         Case{"linear", 2},
                                         Case{"log", 0.5},
                                         Case{"zbuffer24", 0},
                                         Case{"zbuffer16", 0},
                                         Case{"reversed_float", 0}),
                         [](const auto& row) { return row.param.encoding; });

}  // namespace
}  // namespace ink::methods
