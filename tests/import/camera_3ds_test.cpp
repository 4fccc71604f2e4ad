#include "import/camera_3ds.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numbers>
#include <string>

namespace ink::import {
namespace {

template <class T>
std::string raw(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string chunk(std::uint16_t id, const std::string& body) {
    return raw(id) + raw(static_cast<std::uint32_t>(body.size() + 6)) + body;
}

std::string camera_file(const std::array<float, 8>& camera) {
    const std::string object = std::string("Cam") + '\0' + chunk(0x4700, raw(camera));
    return chunk(0x4d4d, chunk(0x0002, raw(3)) + chunk(0x3d3d, chunk(0x4000, object)));
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
    std::string track = std::string(10, '\0') + raw(static_cast<std::uint32_t>(keys.size()));
    for (std::size_t k = 0; k < keys.size(); ++k) {
        track += raw(keys[k].first) + raw(std::uint16_t(k == 0 ? 0x3 : 0));
        if (k == 0) track += raw(0.5F) + raw(-0.5F);
        track += raw(std::array<float, 3>{keys[k].second, 2, 3});
    }
    const std::string header = std::string("Cam") + '\0' + std::string(4, '\0') + raw(parent);
    return chunk(id, chunk(0xb010, header) + chunk(0xb020, track));
}

std::string keyframer_file(const std::string& nodes) {
    return chunk(0x4d4d, chunk(0x0002, raw(3)) + chunk(0xb000, nodes));
}

std::vector<CameraKeys> keys_in(const std::string& content) {
    return read_3ds_camera_keys(std::as_bytes(std::span<const char>(content)));
}

TEST(ThreeDsCameras, KeysOfEyeAndTarget) {
    const auto cameras = keys_in(
        keyframer_file(track_node(0xb003, -1, {{0, 10}, {60, 20}, {90, 25}}) +
                       track_node(0xb002, -1, {{0, 99}}) + track_node(0xb004, -1, {{15, -1}})));
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
        const auto cameras = keys_in(keyframer_file(node));
        return cameras.empty() ? 0U : cameras[0].eye.size();
    };
    EXPECT_EQ(eyes(track_node(0xb003, 4, {{0, 10}, {60, 20}})), 0U) << "on an object";
    EXPECT_EQ(eyes(track_node(0xb003, -1, {{60, 10}, {30, 20}, {90, 30}})), 1U) << "back in time";
    const std::string whole = keyframer_file(track_node(0xb003, -1, {{0, 10}, {60, 20}}));
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
