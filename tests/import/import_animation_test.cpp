// Keys and bones on their way from a file through the import into a pose.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/animation.h"
#include "tests/import/files_3ds.h"
#include "tests/import/model_files.h"
#include "tests/import/quake_files.h"

namespace ink::import {
namespace {

using ImportAnimation = ModelFiles;

std::string base64(const std::string& bytes) {
    constexpr const char* kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits =
                bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

/// A glTF file under construction: one buffer, an accessor per array.
class Gltf {
  public:
    /// Adds an array and returns its accessor.
    template <class T>
    int add(const std::vector<T>& values, const std::string& type, int component, int per_item) {
        while (buffer_.size() % 4 != 0)
            buffer_ += '\0';
        const std::size_t offset = buffer_.size();
        for (const T value : values)
            put(buffer_, value);
        views_ += fmt::format("{}{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}}}",
                              count_ == 0 ? "" : ",",
                              offset,
                              buffer_.size() - offset);
        accessors_ +=
            fmt::format("{}{{\"bufferView\":{},\"componentType\":{},\"count\":{},\"type\":\"{}\"}}",
                        count_ == 0 ? "" : ",",
                        count_,
                        component,
                        values.size() / static_cast<std::size_t>(per_item),
                        type);
        return count_++;
    }
    int floats(const std::vector<float>& values, const std::string& type, int per_item) {
        return add(values, type, 5126, per_item);
    }
    [[nodiscard]] std::string file(const std::string& rest) const {
        return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0," + rest + ",\"accessors\":[" +
               accessors_ + "],\"bufferViews\":[" + views_ +
               "],\"buffers\":[{\"byteLength\":" + std::to_string(buffer_.size()) +
               ",\"uri\":\"data:application/octet-stream;base64," + base64(buffer_) + "\"}]}";
    }

  private:
    std::string buffer_;
    std::string views_;
    std::string accessors_;
    int count_ = 0;
};

const std::vector<float> kTriangle{0, 0, 0, 1, 0, 0, 0, 1, 0};

TEST_F(ImportAnimation, GltfNodesMoveByTheirKeys) {
    Gltf gltf;
    const int positions = gltf.floats(kTriangle, "VEC3", 3);
    const int times = gltf.floats({0, 2}, "SCALAR", 1);
    const int places = gltf.floats({0, 0, 0, 0, 8, 0}, "VEC3", 3);
    const auto path = write(
        "moving.gltf",
        gltf.file(
            "\"scenes\":[{\"nodes\":[0,2]}],\"nodes\":[{\"name\":\"lift\",\"children\":[1]},"
            "{\"name\":\"cabin\",\"mesh\":0,\"translation\":[1,0,0]},{\"name\":\"still\",\"mesh\":"
            "0}],"
            "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" +
            std::to_string(positions) +
            "}}]}],\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":"
            "\"translation\"}}],\"samplers\":[{\"input\":" +
            std::to_string(times) + ",\"output\":" + std::to_string(places) + "}]}]"));
    scene::Scene scene = import_scene(path);
    ASSERT_NE(scene.animation, nullptr);
    EXPECT_NEAR(scene.animation->duration_s, 2, 1e-9);
    ASSERT_EQ(scene.instances.size(), 2U);
    const auto x1 = [&](std::size_t i) { return scene::to_world(scene.instances[i], {1, 0, 0}); };
    EXPECT_EQ(x1(0), glm::dvec3(2, 0, 0)) << "at rest";
    scene::pose_scene(scene, 0.5);
    EXPECT_LT(glm::length(x1(0) - glm::dvec3(2, 2, 0)), 1e-9);
    EXPECT_EQ(x1(1), glm::dvec3(1, 0, 0));
    scene::pose_scene(scene, 2);
    EXPECT_LT(glm::length(x1(0) - glm::dvec3(2, 8, 0)), 1e-9);
}

TEST_F(ImportAnimation, GltfSkinsBend) {
    Gltf gltf;
    const int positions = gltf.floats(kTriangle, "VEC3", 3);
    const int joints =
        gltf.add<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 5121, 4);
    const int weights = gltf.floats({1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0}, "VEC4", 4);
    const int binds = gltf.floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,
                                   1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                                  "MAT4",
                                  16);
    const int times = gltf.floats({0, 1}, "SCALAR", 1);
    const int places = gltf.floats({0, 0, 0, 0, 0, 4}, "VEC3", 3);
    const auto text = [](int n) { return std::to_string(n); };
    // The mesh's own node stands far off, which must not matter.
    const auto path = write(
        "skinned.gltf",
        gltf.file(
            "\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"name\":\"body\",\"mesh\":0,\"skin\":0,"
            "\"translation\":[100,0,0]},{\"name\":\"a\",\"children\":[2]},{\"name\":\"b\"}],"
            "\"skins\":[{\"joints\":[1,2],\"inverseBindMatrices\":" +
            text(binds) +
            "}],"
            "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" +
            text(positions) + ",\"JOINTS_0\":" + text(joints) + ",\"WEIGHTS_0\":" + text(weights) +
            "}}]}],"
            "\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":2,\"path\":"
            "\"translation\"}}],\"samplers\":[{\"input\":" +
            text(times) + ",\"output\":" + text(places) + "}]}]"));
    scene::Scene scene = import_scene(path);
    ASSERT_NE(scene.animation, nullptr);
    ASSERT_EQ(scene.animation->skins.size(), 1U);
    const auto corner = [&](std::size_t v) {
        return scene::to_world(scene.instances.at(0), scene.meshes.at(0).positions.at(v));
    };
    EXPECT_LT(glm::length(corner(1) - glm::dvec3(1, 0, 0)), 1e-6);
    scene::pose_scene(scene, 1);
    EXPECT_LT(glm::length(corner(0) - glm::dvec3(0, 0, 0)), 1e-6);
    EXPECT_LT(glm::length(corner(1) - glm::dvec3(1, 0, 4)), 1e-6);
    EXPECT_LT(glm::length(corner(2) - glm::dvec3(0, 1, 2)), 1e-6);
}

TEST_F(ImportAnimation, KeysThatAreNotFiniteAreAMessage) {
    Gltf gltf;
    const int positions = gltf.floats(kTriangle, "VEC3", 3);
    const int times = gltf.floats({0, 2}, "SCALAR", 1);
    const int places = gltf.floats({0, 0, 0, 0, NAN, 0}, "VEC3", 3);
    const auto path = write(
        "lost.gltf",
        gltf.file(
            "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"name\":\"n\",\"mesh\":0}],"
            "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" +
            std::to_string(positions) +
            "}}]}],\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":"
            "\"translation\"}}],\"samplers\":[{\"input\":" +
            std::to_string(times) + ",\"output\":" + std::to_string(places) + "}]}]"));
    EXPECT_THAT(complaint(path), testing::HasSubstr("is not finite"));
}

TEST_F(ImportAnimation, GltfCamerasRideOnTheirNodes) {
    Gltf gltf;
    const int positions = gltf.floats(kTriangle, "VEC3", 3);
    const int times = gltf.floats({0, 2}, "SCALAR", 1);
    const int places = gltf.floats({0, 0, 0, 0, 8, 0}, "VEC3", 3);
    const std::string lens =
        "{\"type\":\"perspective\",\"perspective\":{\"yfov\":0.7,\"znear\":0.1,\"aspectRatio\":1}}";
    const auto path = write(
        "ride.gltf",
        gltf.file(
            "\"scenes\":[{\"nodes\":[0,2,3]}],\"nodes\":[{\"name\":\"lift\",\"children\":[1]},"
            "{\"name\":\"rider\",\"camera\":0,\"translation\":[0,0,5]},"
            "{\"name\":\"still\",\"mesh\":0},"
            "{\"name\":\"post\",\"camera\":1,\"translation\":[0,0,7]}],"
            "\"cameras\":[" +
            lens + "," + lens + "]," +
            "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" +
            std::to_string(positions) +
            "}}]}],\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":"
            "\"translation\"}}],\"samplers\":[{\"input\":" +
            std::to_string(times) + ",\"output\":" + std::to_string(places) + "}]}]"));
    scene::Scene scene = import_scene(path);
    ASSERT_EQ(scene.cameras.size(), 2U);
    const bool rider_is_first = scene.cameras[0].name == "rider";
    scene::Camera& rider = scene.cameras[rider_is_first ? 0 : 1];
    scene::Camera& post = scene.cameras[rider_is_first ? 1 : 0];
    EXPECT_LT(glm::length(rider.eye_world - glm::dvec3(0, 0, 5)), 1e-6);
    const glm::dmat3 view_direction = rider.view_from_world;
    scene::pose_scene(scene, 0.5);
    EXPECT_LT(glm::length(rider.eye_world - glm::dvec3(0, 2, 5)), 1e-6);
    EXPECT_LT(glm::length((rider.view_from_world - view_direction)[2]), 1e-6) << "it does not turn";
    EXPECT_LT(glm::length(post.eye_world - glm::dvec3(0, 0, 7)), 1e-6);
    scene::rest_scene(scene);
    EXPECT_LT(glm::length(rider.eye_world - glm::dvec3(0, 0, 5)), 1e-6);
}

/// A triangle that rises by 12 in 2 seconds, and a camera with keys of eye and target; z is up.
std::string launch_3ds() {
    const std::string camera = raw(std::array<float, 8>{46, -52, 9, 0, 0, 10, 0, 35});
    const Keys3ds rise = {{0, {0, 0, 0}}, {60, {0, 0, 12}}};
    const Keys3ds eye = {{0, {46, -52, 9}}, {60, {40, -46, 6}}, {120, {30, -60, 14}}};
    const Keys3ds target = {{0, {0, 0, 10}}, {50, {0, 0, 12}}, {75, {0, 0, 26}}};
    return file_3ds(triangle_3ds("Rocket") + object_3ds("Camera01", chunk(0x4700, camera)),
                    node_3ds(0xb002, "Rocket", -1, track_3ds(0xb020, rise)) +
                        node_3ds(0xb003, "Camera01", -1, track_3ds(0xb020, eye)) +
                        node_3ds(0xb004, "Camera01", -1, track_3ds(0xb020, target)));
}

TEST_F(ImportAnimation, ThreeDsNodesMoveByTheirKeys) {
    scene::Scene scene = import_scene(write("launch.3ds", launch_3ds()));
    ASSERT_NE(scene.animation, nullptr);
    EXPECT_NEAR(scene.animation->duration_s, 4, 1e-6);
    for (const double time_s : {0.0, 0.5, 2.0, 4.0}) {
        scene::pose_scene(scene, time_s);
        const glm::dvec3 corner =
            scene::to_world(scene.instances.at(0), scene.meshes[0].positions.at(0));
        EXPECT_LT(glm::length(corner - glm::dvec3(0, std::min(6 * time_s, 12.0), 0)), 1e-5)
            << time_s;
    }
}

TEST_F(ImportAnimation, TheCameraOf3dsFollowsItsTarget) {
    scene::Scene scene = import_scene(write("launch.3ds", launch_3ds()));
    ASSERT_EQ(scene.cameras.size(), 1U);
    scene::Camera& camera = scene.cameras[0];
    EXPECT_EQ(camera.name, "Camera01");
    const auto expect_looks_at = [&](const glm::dvec3& target, const char* when) {
        const glm::dvec3 view = camera.view_from_world * glm::normalize(target - camera.eye_world);
        EXPECT_LT(glm::length(view - glm::dvec3(0, 0, -1)), 1e-6) << when;
        const glm::dvec3 up = camera.view_from_world * glm::dvec3(0, 1, 0);
        EXPECT_NEAR(up.x, 0, 1e-9) << when;
        EXPECT_GT(up.y, 0.5) << when;
    };
    // The file's z is our y, its y our -z. A lens of 35 is 2400/35 degrees across 4:3.
    EXPECT_LT(glm::length(camera.eye_world - glm::dvec3(46, 9, 52)), 1e-5);
    expect_looks_at({0, 10, 0}, "at rest");
    const double fov_x_rad = 2 * std::atan(std::tan(camera.fov_y_rad / 2) * 4 / 3);
    EXPECT_NEAR(fov_x_rad * 180 / std::numbers::pi, 2400.0 / 35, 1e-6);
    scene::pose_scene(scene, 2);
    EXPECT_LT(glm::length(camera.eye_world - glm::dvec3(40, 6, 46)), 1e-5);
    expect_looks_at({0, 12 + 14 * 0.4, 0}, "at 60 frames");
    scene::pose_scene(scene, 4);
    EXPECT_LT(glm::length(camera.eye_world - glm::dvec3(30, 14, 60)), 1e-5);
}

TEST_F(ImportAnimation, AFileWithoutKeysHasNone) {
    EXPECT_EQ(import_scene(write("still.obj", kTriangleObj)).animation, nullptr);
}

}  // namespace
}  // namespace ink::import
