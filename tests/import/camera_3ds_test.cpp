#include "import/stage_3ds.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "tests/import/files_3ds.h"

namespace ink::import {
namespace {

std::string camera_file(const std::array<float, 8>& camera) {
    return file_3ds(object_3ds("Cam", chunk(0x4700, raw(camera))));
}

std::vector<ImportedCamera> cameras_in(const std::string& content) {
    return read_3ds_cameras(std::as_bytes(std::span<const char>(content)));
}

TEST(ThreeDsCameras, EyeTargetRollAndLens) {
    const auto cameras = cameras_in(camera_file({1, 2, 3, 1, 7, 3, 90, 48}));
    ASSERT_EQ(cameras.size(), 1U);
    EXPECT_EQ(cameras[0].name, "Cam");
    EXPECT_EQ(cameras[0].eye_world, glm::dvec3(1, 2, 3));
    EXPECT_EQ(cameras[0].target_world, glm::dvec3(1, 7, 3));
    // z turned by 90 degrees about the view direction +y is x.
    EXPECT_NEAR(cameras[0].up_world.x, 1, 1e-12);
    EXPECT_NEAR(cameras[0].up_world.z, 0, 1e-12);
    // 2400 / 48 = 50 degrees across a 4:3 image.
    const double half_x_rad = std::atan(std::tan(cameras[0].fov_y_rad / 2) * 4 / 3);
    EXPECT_NEAR(2 * half_x_rad * 180 / std::numbers::pi, 50, 1e-9);
}

/// A node of the keyframer with a track of positions: frame, x for each; the first key is eased.
std::string track_node(std::uint16_t id,
                       std::int16_t parent,
                       const std::vector<std::pair<std::uint32_t, float>>& keys) {
    Keys3ds places;
    for (const auto& [frame, x] : keys)
        places.push_back({frame, {x, 2, 3}});
    return node_3ds(id, "Cam", parent, track_3ds(0xb020, places));
}

std::vector<CameraKeys> keys_in(const std::string& content) {
    return read_3ds_camera_keys(std::as_bytes(std::span<const char>(content)));
}

TEST(ThreeDsCameras, KeysOfEyeAndTarget) {
    const auto cameras = keys_in(file_3ds("",
                                          track_node(0xb003, -1, {{0, 10}, {60, 20}, {90, 25}}) +
                                              track_node(0xb002, -1, {{0, 99}}) +
                                              track_node(0xb004, -1, {{15, -1}})));
    ASSERT_EQ(cameras.size(), 1U);
    EXPECT_EQ(cameras[0].name, "Cam");
    ASSERT_EQ(cameras[0].eye.size(), 3U);
    EXPECT_EQ(cameras[0].eye[0].time_s, 0);
    EXPECT_EQ(cameras[0].eye[0].value, glm::dvec3(10, 2, 3));
    EXPECT_EQ(cameras[0].eye[1].time_s, 2) << "30 frames a second";
    EXPECT_EQ(cameras[0].eye[2].value, glm::dvec3(25, 2, 3));
    ASSERT_EQ(cameras[0].target.size(), 1U);
    EXPECT_EQ(cameras[0].target[0].time_s, 0.5);
}

TEST(ThreeDsCameras, KeysThatAreNoUseAreLeftOut) {
    const auto eyes = [](const std::string& node) {
        const auto cameras = keys_in(file_3ds("", node));
        return cameras.empty() ? 0U : cameras[0].eye.size();
    };
    EXPECT_EQ(eyes(track_node(0xb003, 4, {{0, 10}, {60, 20}})), 0U) << "on an object";
    EXPECT_EQ(eyes(track_node(0xb003, -1, {{60, 10}, {30, 20}, {90, 30}})), 1U) << "back in time";
    const std::string whole = file_3ds("", track_node(0xb003, -1, {{0, 10}, {60, 20}}));
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const auto cameras = keys_in(whole.substr(0, size));
        EXPECT_LT(cameras.empty() ? 0U : cameras[0].eye.size(), 2U) << size;
    }
}

TEST(ThreeDsCameras, DamageIsSkipped) {
    EXPECT_TRUE(cameras_in(camera_file({1, 2, 3, 1, 7, 3, 0, 0})).empty()) << "no lens";
    const std::string whole = camera_file({1, 2, 3, 1, 7, 3, 0, 48});
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_TRUE(cameras_in(whole.substr(0, size)).empty()) << size;
    }
}

}  // namespace
}  // namespace ink::import
