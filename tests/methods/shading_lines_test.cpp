#include <gtest/gtest.h>

#include <cmath>

#include "catalogue/shapes.h"
#include "tests/methods/small_scenes.h"

// Today's methods that look at one pixel's surface, or at the mask of all objects.

namespace ink::methods {
namespace {

constexpr int kSize_px = 201;
constexpr double kEye = 4;  ///< distance from the centre of a ball of radius 1

/// A ball in the middle of the image.
scene::Scene ball() {
    return scene_of({catalogue::make_sphere(1, 128, 64)});
}
scene::View ball_view() {
    return view_from(ball(), {0, 0, kEye}, {0, 0, 0}, {kSize_px, kSize_px});
}

/// The radius on the image, in px, at which |n.v| of the ball is `ratio`.
double radius_at(double ratio) {
    // By the law of sines, in the triangle of eye, centre and surface point.
    const double eye_angle = std::asin(std::sqrt(1 - ratio * ratio) / kEye);
    const double focal_px = 0.5 * kSize_px / std::tan(ball_view().camera.fov_y_rad / 2);
    return focal_px * std::tan(eye_angle);
}

int drawn_at(const edge::EdgeImage& image, double radius_px) {
    return image.at(kSize_px / 2 + static_cast<int>(std::lround(radius_px)), kSize_px / 2);
}

TEST(Rim, DrawsTheRingOfABallWhereItTurnsAway) {
    const double limit = 0.4;
    const edge::EdgeImage image = drawn("rim", {{"limit", "0.4"}}, ball(), {ball_view(), 1});
    EXPECT_EQ(drawn_at(image, radius_at(limit) - 1.5), 0) << "inside the ring";
    EXPECT_GT(drawn_at(image, radius_at(limit) + 1.5), 0) << "in it";
    EXPECT_NEAR(drawn_at(image, radius_at(limit / 2)), 128, 24) << "half way to the contour";
    EXPECT_EQ(drawn_at(image, radius_at(0) + 2), 0) << "the sky";
}

TEST(BlurredSilhouette, IsOnePixelOutsideTheMask) {
    const edge::EdgeImage image = drawn("blurred_silhouette", {}, ball(), {ball_view(), 1});
    const double contour_px = radius_at(0);
    EXPECT_EQ(drawn_at(image, contour_px - 2), 0) << "inside";
    EXPECT_GE(drawn_at(image, std::floor(contour_px) + 1), 64) << "beside the contour";
    EXPECT_EQ(drawn_at(image, contour_px + 3), 0) << "beyond the blur";
}

TEST(BlurredSilhouette, EachRoundReachesOnePixelFurther) {
    for (const int rounds : {1, 2, 4, 8}) {
        const edge::EdgeImage image = drawn(
            "blurred_silhouette", {{"rounds", std::to_string(rounds)}}, ball(), {ball_view(), 1});
        int widest = 0;
        for (int x = kSize_px / 2; x < kSize_px; ++x)
            widest = image.at(x, kSize_px / 2) > 0 ? x : widest;
        const int rim_px = kSize_px / 2 + static_cast<int>(std::lround(radius_at(0)));
        EXPECT_LE(widest - rim_px, rounds + 1) << rounds;
        EXPECT_GE(widest - rim_px, rounds / 2) << rounds << ": its tails round to 0";
    }
}

TEST(BlurredSilhouette, TheFrameIsNoBorder) {
    // The ball fills the image.
    const scene::View near = view_from(ball(), {0, 0, 1.2}, {0, 0, 0}, {64, 48});
    const edge::EdgeImage image =
        drawn("blurred_silhouette", {{"side", "both"}, {"rounds", "4"}}, ball(), {near, 1});
    for (int i = 0; i < 64 * 48; ++i)
        ASSERT_EQ(image.data()[i], 0) << i;
}

TEST(IdsDepth, FindsAStepWithinOneIdThatIdsLack) {
    // Two sheets of one object, one behind the other, joined nowhere on the image.
    scene::Mesh sheets;
    scene::add_quad(sheets, {-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
    scene::add_quad(sheets, {0, -9, 1}, {9, 0, 0}, {0, 18, 0});
    const scene::Scene scene = scene_of({sheets});
    const scene::View view = view_from(scene, {0, 0, 5}, {0, 0, 0}, {101, 51});
    const core::ParamValues objects{{"of", "object"}};
    const auto has_step = [&](const char* method) {
        const edge::EdgeImage image = drawn(method, objects, scene, {view, 1});
        for (int x = 45; x < 56; ++x) {
            if (image.at(x, 25) > 0) return true;
        }
        return false;
    };
    EXPECT_FALSE(has_step("ids"));
    EXPECT_TRUE(has_step("ids_depth"));
}

}  // namespace
}  // namespace ink::methods
