// A flat floor that fills the frame has no outline. Which depth encodings know that?

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "tests/methods/names.h"
#include "tests/methods/small_scenes.h"

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

/// Distance along the view direction of the floor at the middle of every row.
std::vector<double> row_distances_w(const scene::View& view) {
    const scene::Projection projection(view);
    std::vector<double> w;
    for (int y = 0; y < view.height_px; ++y)
        w.push_back(-1 / projection.ray_world(65, y + 0.5).y);
    return w;
}

/// Whether there is a line anywhere but in the frame's outermost pixels, where a stencil reaches
/// beyond the image and sees half a slope.
bool has_line(const edge::EdgeImage& image, int threshold = 1, int margin_px = 1) {
    for (int y = margin_px; y + margin_px < image.height_px(); ++y) {
        const std::uint8_t* row = image.row(y);
        if (std::any_of(row + margin_px, row + image.width_px() - margin_px, [&](int s) {
                return s >= threshold;
            }))
            return true;
    }
    return false;
}

TEST(Floor, NoMethodDrawsOnIt) {
    const scene::Scene scene = scene_of({floor_mesh(4000)});
    for (const method::MethodInfo& info : registry()) {
        for (const double angle_deg : kAngles_deg) {
            scene::View view = view_over_floor(angle_deg);
            view.camera.near = 0.1;
            if (draws_grazing_planes(info.name)) continue;
            EXPECT_FALSE(has_line(drawn(info.name, {}, scene, {view, 1})))
                << info.name << " at " << angle_deg << " degrees";
        }
        const bool is_drawn = has_line(drawn(info.name, {}, scene, {view_over_floor(1), 1}));
        EXPECT_EQ(is_drawn, draws_grazing_planes(info.name)) << info.name;
    }
}

/// The encodings as section 3 of the design has them: 1 at the range's near end, 0 at its far.
double encoded(const std::string& encoding, double w, double near, double far) {
    const double hyperbolic = (1 / w - 1 / far) / (1 / near - 1 / far);
    if (encoding == "linear") return (far - w) / (far - near);
    if (encoding == "log") return std::log(far / w) / std::log(far / near);
    if (encoding == "zbuffer24") return std::round(hyperbolic * 16777215) / 16777215;
    if (encoding == "zbuffer16") return std::round(hyperbolic * 65535) / 65535;
    if (encoding == "reversed_float") return static_cast<float>(near / w);
    return hyperbolic;
}

/// The encoded depth of the middle of every row.
std::vector<double> row_depths(const scene::View& view, const std::string& encoding) {
    std::vector<double> depths;
    for (const double w : row_distances_w(view))
        depths.push_back(encoded(encoding, w, view.camera.near, view.camera.far));
    return depths;
}

/// MOTE's filter by its definition: depth quantised to 0..255, the Laplacian, two bits clipped.
bool laplacian_fires(const scene::View& view, const std::string& encoding) {
    std::vector<int> code;
    for (const double d : row_depths(view, encoding))
        code.push_back(static_cast<int>(std::lround(255 * d)));
    for (std::size_t y = 1; y + 1 < code.size(); ++y) {
        if (std::abs(2 * code[y] - code[y - 1] - code[y + 1]) > 3) return true;
    }
    return false;
}

/// Decaudin's by its definition, on rows that are all alike: four of the eight neighbours' weights
/// lie above, four below. k = 0.02, a line from edge response 146 of 255 on.
bool decaudin_fires(const scene::View& view, const std::string& encoding) {
    const std::vector<double> d = row_depths(view, encoding);
    std::vector<double> g(d.size());
    for (std::size_t y = 1; y + 1 < d.size(); ++y)
        g[y] = (4 * std::abs(d[y - 1] - d[y]) + 4 * std::abs(d[y + 1] - d[y])) / 8;
    for (std::size_t y = 2; y + 2 < d.size(); ++y) {
        const double spread =
            std::max({g[y - 1], g[y], g[y + 1]}) - std::min({g[y - 1], g[y], g[y + 1]});
        const double p = std::min(spread / 0.02 * (spread / 0.02), 1.0);
        if (std::floor(255 * p + 0.5) >= 146) return true;
    }
    return false;
}

/// The floor with a depth range that just holds what is seen of it.
scene::View view_with_range(double grazing_deg) {
    scene::View view = view_over_floor(grazing_deg);
    const std::vector<double> w = row_distances_w(view);
    view.camera.near = w.back() * 0.9;
    view.camera.far = w.front() * 1.1;
    return view;
}

struct Case {
    std::string encoding;
    double laplacian_from_deg;  ///< the largest of kAngles_deg at which it draws a line; 0: at none
    double decaudin_from_deg;
};

class FloorEncoding : public testing::TestWithParam<Case> {
  protected:
    const scene::Scene scene_ = scene_of({floor_mesh(4000)});
};

TEST_P(FloorEncoding, FiresFromItsGrazingAngleOnInAByte) {
    for (const double angle_deg : kAngles_deg) {
        const scene::View view = view_with_range(angle_deg);
        const auto image = drawn("mote2",
                                 {{"packing", "pixel"},
                                  {"depth_range", "camera"},
                                  {"depth_encoding", GetParam().encoding},
                                  {"range_depth", "255"},
                                  {"range_normal", "0"}},
                                 scene_,
                                 {view, 1});
        const bool fires = angle_deg <= GetParam().laplacian_from_deg;
        EXPECT_EQ(has_line(image), fires) << angle_deg << " degrees";
        EXPECT_EQ(laplacian_fires(view, GetParam().encoding), fires) << angle_deg << " degrees";
    }
}

TEST_P(FloorEncoding, FiresFromItsGrazingAngleOnInFullBuffers) {
    for (const double angle_deg : kAngles_deg) {
        const scene::View view = view_with_range(angle_deg);
        const auto image =
            drawn("decaudin",
                  {{"depth_range", "camera"}, {"depth_encoding", GetParam().encoding}},
                  scene_,
                  {view, 1});
        const bool fires = angle_deg <= GetParam().decaudin_from_deg;
        EXPECT_EQ(has_line(image, 146, 2), fires) << angle_deg << " degrees";
        EXPECT_EQ(decaudin_fires(view, GetParam().encoding), fires) << angle_deg << " degrees";
    }
}

INSTANTIATE_TEST_SUITE_P(Table,
                         FloorEncoding,
                         testing::Values(Case{"inverse", 0, 0},
                                         Case{"linear", 2, 2},
                                         Case{"log", 0.5, 0.7},
                                         Case{"zbuffer24", 0, 0},
                                         Case{"zbuffer16", 0, 0},
                                         Case{"reversed_float", 0, 0}),
                         [](const auto& row) { return row.param.encoding; });

TEST(Floor, RobertsFiresWhereAPlanesOwnSlopeIsAStepUnlessItIsGuarded) {
    // Rows are all alike, so that half a cross is the step between two of them.
    constexpr double kStep = 0.05;
    const scene::Scene scene = scene_of({floor_mesh(4000)});
    int firing = 0;
    for (const double angle_deg : kAngles_deg) {
        scene::View view = view_over_floor(angle_deg);
        view.camera.near = 0.1;
        const std::vector<double> w = row_distances_w(view);
        bool is_step = false;
        for (std::size_t y = 1; y + 2 < w.size(); ++y)
            is_step = is_step || (1 / w[y + 1] - 1 / w[y]) / (1 / w[y + 1]) >= kStep;
        firing += is_step ? 1 : 0;
        for (const std::string guard : {"none", "cosine"}) {
            const auto image =
                drawn("roberts", {{"guard", guard}, {"depth_step", "0.05"}}, scene, {view, 1});
            EXPECT_EQ(has_line(image), is_step && guard == "none") << guard << ' ' << angle_deg;
        }
    }
    EXPECT_GT(firing, 2);
    EXPECT_LT(firing, static_cast<int>(kAngles_deg.size()));
}

}  // namespace
}  // namespace ink::methods
