#include "method/depth_code.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ink::method {
namespace {

using raster::DepthEncoding;
using raster::Interpolation;

scene::Camera camera_at(double distance) {
    scene::Camera camera = scene::look_at({0, 0, distance}, {0, 0, 0}, {0, 1, 0}, 0.7);
    camera.near = 0.5;
    camera.far = 200;
    return camera;
}

TEST(DepthRange, FitSpansTheSphereAlongTheViewDirection) {
    const auto range = depth_range(RangeSource::fit, camera_at(10), {{0, 0, 0}, 2});
    EXPECT_DOUBLE_EQ(range.near, 8);
    EXPECT_DOUBLE_EQ(range.far, 12);
    // Off the axis only the distance along the view direction counts.
    const auto aside = depth_range(RangeSource::fit, camera_at(10), {{7, 0, 0}, 2});
    EXPECT_DOUBLE_EQ(aside.near, 8);
}

TEST(DepthRange, CameraTakesItsNearAndFar) {
    const auto range = depth_range(RangeSource::camera, camera_at(10), {{0, 0, 0}, 2});
    EXPECT_EQ(range.near, 0.5);
    EXPECT_EQ(range.far, 200);
}

TEST(DepthRange, IsUsableWhereverTheSphereLies) {
    for (const double distance : {-10.0, -2.0, 1.0, 2.0, 10.0}) {
        for (const double radius : {0.0, 2.0, 1e6}) {
            const auto range =
                depth_range(RangeSource::fit, camera_at(distance), {{0, 0, -5}, radius});
            EXPECT_GT(range.near, 0);
            EXPECT_GT(range.far, range.near);
        }
    }
}

/// What a pixel at 31/100 of the way on the screen from distance 2 to 6 sees, exactly: 1/w is
/// affine there.
constexpr double kBetween_w = 1 / (0.69 / 2 + 0.31 / 6);

class Carrier : public testing::TestWithParam<std::tuple<DepthEncoding, Interpolation>> {};

TEST_P(Carrier, IsExactBetweenVerticesInEveryEncoding) {
    const auto [encoding, interpolation] = GetParam();
    const raster::DepthRange range{2, 6};
    const DepthCarrier carrier(encoding, interpolation, range);
    const float near = carrier.at_vertex(2);
    const float far = carrier.at_vertex(6);
    // Perspective interpolation weighs a vertex by its screen share of 1/w.
    const double share_near = interpolation == Interpolation::affine ? 0.69 : 0.69 / 2 * kBetween_w;
    const auto carried = static_cast<float>(share_near * near + (1 - share_near) * far);
    float encoded = carried;
    if (!carrier.is_encoded()) carrier.encode_row(&carried, -1, &encoded, 1);
    EXPECT_NEAR(encoded, raster::encode_depth(encoding, kBetween_w, range), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(All,
                         Carrier,
                         testing::Combine(testing::Values(DepthEncoding::inverse,
                                                          DepthEncoding::linear,
                                                          DepthEncoding::log,
                                                          DepthEncoding::zbuffer24,
                                                          DepthEncoding::zbuffer16,
                                                          DepthEncoding::reversed_float),
                                          testing::Values(Interpolation::affine,
                                                          Interpolation::perspective)));

TEST(DepthCarrier, WritesSkyWhereNothingWasDrawn) {
    const DepthCarrier carrier(DepthEncoding::log, Interpolation::affine, {1, 10});
    const std::array<float, 2> carried = {kNothingDrawn, carrier.at_vertex(10)};
    std::array<float, 2> encoded{};
    carrier.encode_row(carried.data(), -0.25F, encoded.data(), 2);
    EXPECT_EQ(encoded[0], -0.25F);
    EXPECT_NEAR(encoded[1], 0, 1e-6);
}

TEST(DepthCarrier, StaysFiniteFarOutsideItsRange) {
    for (const auto encoding :
         {DepthEncoding::inverse, DepthEncoding::linear, DepthEncoding::log}) {
        for (const auto interpolation : {Interpolation::affine, Interpolation::perspective}) {
            const DepthCarrier carrier(encoding, interpolation, {1, 1.000001});
            for (const double w : {1e-30, 1e-3, 1e12, 1e30}) {
                const float carried = carrier.at_vertex(w);
                float encoded = carried;
                carrier.encode_row(&carried, 0, &encoded, 1);
                EXPECT_TRUE(std::isfinite(carried) && std::isfinite(encoded)) << w;
            }
        }
    }
}

}  // namespace
}  // namespace ink::method
