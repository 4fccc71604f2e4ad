#include "harness/suite/suite.h"

#include <gmock/gmock.h>

#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>

#include "catalogue/catalogue.h"
#include "core/error.h"
#include "tests/core/error_text.h"
#include "tests/scene/small_meshes.h"

namespace ink::harness {
namespace {

/// A user's model: called as no built-in scene is.
scene::Scene model() {
    scene::Mesh mesh = scene::unit_cube();
    mesh.name = "crate";
    return scene::scene_of(mesh);
}

TEST(SceneViews, AModelGetsThreeViewsRoundItUnlessAsked) {
    const SceneViews three = make_scene_views(model(), {});
    EXPECT_EQ(three.views.size(), 3U);
    EXPECT_EQ(three.views[0].width_px, 1280);
    ViewRequest five;
    five.orbit_count = 5;
    EXPECT_EQ(make_scene_views(model(), five).views.size(), 5U);
}

TEST(SceneViews, NamedViewsLookWhereTheirNamesSay) {
    scene::Scene scene = model();
    scene.instances[0].world_from_object[3] = {1, 2, 3, 1};
    ViewRequest request;
    request.directions.assign(scene::drawing_views().begin(), scene::drawing_views().end());
    const SceneViews scene_views = make_scene_views(scene, request);
    const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    // Right, up and back of each on the page.
    const std::map<std::string, std::array<glm::dvec3, 3>> expected = {{"front", {x, y, z}},
                                                                       {"back", {-x, y, -z}},
                                                                       {"left", {z, y, -x}},
                                                                       {"right", {-z, y, x}},
                                                                       {"top", {x, -z, y}},
                                                                       {"bottom", {x, z, -y}}};
    ASSERT_EQ(scene_views.views.size(), 7U);
    for (const scene::View& view : scene_views.views) {
        const scene::Camera& camera = view.camera;
        const glm::dvec3 out = glm::normalize(camera.eye_world - glm::dvec3(1, 2, 3));
        if (camera.name == "iso") {
            EXPECT_NEAR(glm::dot(out, glm::normalize(x + y + z)), 1, 1e-12);
            EXPECT_GT((camera.view_from_world * y).y, 0.8) << "y is up on the page";
            continue;
        }
        const auto& [right, up, back] = expected.at(camera.name);
        EXPECT_EQ(camera.view_from_world * right, x) << camera.name;
        EXPECT_EQ(camera.view_from_world * up, y) << camera.name;
        EXPECT_EQ(camera.view_from_world * back, z) << camera.name;
        EXPECT_NEAR(glm::dot(out, back), 1, 1e-12) << camera.name;
    }
}

TEST(SceneViews, NamedViewsTurnWithTheAxisThatIsUp) {
    const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    using Axes =
        std::map<std::string, std::array<glm::dvec3, 3>>;  // right, up and back on the page
    const std::map<UpAxis, Axes> expected = {
        {UpAxis::z, {{"front", {x, z, -y}}, {"right", {y, z, x}}, {"top", {x, y, z}}}},
        {UpAxis::x, {{"front", {-y, x, z}}, {"right", {-z, x, -y}}, {"top", {-y, -z, x}}}}};
    ViewRequest request;
    request.directions.assign(scene::drawing_views().begin(), scene::drawing_views().end());
    for (const auto& [up, axes] : expected) {
        request.up = up;
        const SceneViews scene_views = make_scene_views(model(), request);
        EXPECT_EQ(scene_views.up, up);
        EXPECT_TRUE(scene_views.has_named_views);
        for (const scene::View& view : scene_views.views) {
            const auto found = axes.find(view.camera.name);
            if (found == axes.end()) continue;
            const glm::dmat3 world_from_page = glm::transpose(view.camera.view_from_world);
            for (int i = 0; i < 3; ++i)
                EXPECT_EQ(world_from_page[i], found->second[static_cast<std::size_t>(i)])
                    << name(up) << ' ' << view.camera.name << ' ' << i;
        }
    }
}

TEST(SceneViews, ViewsFromAllAroundKnowNoUp) {
    ViewRequest request;
    const SceneViews plain = make_scene_views(model(), request);
    request.up = UpAxis::z;
    const SceneViews turned = make_scene_views(model(), request);
    EXPECT_FALSE(turned.has_named_views);
    for (std::size_t v = 0; v < plain.views.size(); ++v)
        EXPECT_EQ(plain.views[v].camera.eye_world, turned.views[v].camera.eye_world);
}

TEST(UpAxis, IsAsAskedElseAsTheFormatHasIt) {
    ViewRequest request;
    for (const char* z_up : {"part.stl", "folder.obj/PART.STL"})
        EXPECT_EQ(up_of(request, z_up), UpAxis::z) << z_up;
    for (const char* y_up : {"bracket", "part.obj", "stl", "part.stl.ply", "a.glb", ""})
        EXPECT_EQ(up_of(request, y_up), UpAxis::y) << y_up;
    request.up = UpAxis::x;
    EXPECT_EQ(up_of(request, "part.stl"), UpAxis::x);
}

TEST(SceneViews, NamedViewsAreFramedAsAsked) {
    ViewRequest request;
    request.directions = {scene::drawing_views()[0]};
    const double far = make_scene_views(model(), request).views[0].camera.eye_world.z;
    request.fit = Fit::box;
    EXPECT_LT(make_scene_views(model(), request).views[0].camera.eye_world.z, far);
    EXPECT_EQ(make_scene_views(model(), request).views[0].camera.name, "front");
}

TEST(SceneViews, ACatalogueSceneHasItsOwnViews) {
    const auto& entry = catalogue::catalogue().front();
    const SceneViews scene_views = make_scene_views(load_scene(entry.name), {});
    ASSERT_EQ(scene_views.views.size(), scene_views.scene.cameras.size());
    EXPECT_EQ(scene_views.views[0].camera.name, scene_views.scene.cameras[0].name);
}

TEST(SceneViews, AnAskedEyeIsTheEyeWithItsClipRangeFitted) {
    ViewRequest request;
    request.cameras.push_back({{0, 0, 10}, std::nullopt});
    const SceneViews scene_views = make_scene_views(model(), request);
    ASSERT_EQ(scene_views.views.size(), 1U);
    const scene::Camera& camera = scene_views.views[0].camera;
    EXPECT_EQ(camera.eye_world, glm::dvec3(0, 0, 10));
    EXPECT_NEAR(camera.near, 10 - std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(camera.far, 10 + std::sqrt(3.0), 1e-9);
}

TEST(SceneViews, FileCamerasThatAreNotThereAreAnError) {
    ViewRequest request;
    request.file_cameras = true;
    EXPECT_THROW((void)make_scene_views(model(), request), core::Error);
}

TEST(SceneViews, ACameraOfTheUserStandsInTheFilesOwnCoordinates) {
    scene::Scene far = model();
    far.origin = {691000, 0, 5335000};
    ViewRequest request;
    request.cameras.push_back({{691000, 1, 5335010}, glm::dvec3(691000, 1, 5335000)});
    const scene::Camera camera = make_scene_views(far, request).views[0].camera;
    EXPECT_EQ(camera.eye_world, glm::dvec3(0, 1, 10));
    EXPECT_EQ(camera.view_from_world, glm::dmat3(1)) << "it looks along -z";
}

TEST(SceneViews, ProjectionsAreAsAskedAndBothHaveNames) {
    using enum scene::ProjectionKind;
    ViewRequest request;
    request.orbit_count = 2;
    request.projections = {perspective, parallel};
    const auto views = make_scene_views(model(), request).views;
    ASSERT_EQ(views.size(), 4U);
    EXPECT_EQ(views[1].camera.name, "view1");
    EXPECT_EQ(views[3].camera.name, "view1.parallel");
    EXPECT_FALSE(views[1].camera.is_parallel());
    EXPECT_TRUE(views[3].camera.is_parallel());
    request.projections = {parallel};
    request.height_world = 2.5;
    const auto high = make_scene_views(model(), request).views;
    EXPECT_EQ(high[0].camera.name, "view0");
    EXPECT_EQ(high[0].camera.height_world, 2.5);
}

TEST(SceneViews, NamedViewsAreParallelUnlessAskedOtherwise) {
    ViewRequest request;
    request.directions = {scene::drawing_views()[0]};
    EXPECT_TRUE(make_scene_views(model(), request).views[0].camera.is_parallel());
    request.projections = {scene::ProjectionKind::perspective};
    EXPECT_FALSE(make_scene_views(model(), request).views[0].camera.is_parallel());
}

TEST(SceneViews, AFilesCameraKeepsItsProjection) {
    scene::Scene scene = model();
    scene.cameras = scene::orbit_cameras(scene::bounding_sphere(scene), 1, 1.5);
    scene.cameras[0].height_world = 3;
    ViewRequest request;
    request.file_cameras = true;
    EXPECT_EQ(make_scene_views(scene, request).views[0].camera.height_world, 3);
    request.projections = {scene::ProjectionKind::perspective};
    EXPECT_FALSE(make_scene_views(scene, request).views[0].camera.is_parallel());
}

TEST(Size, AbsurdSizesNameTheLimits) {
    for (const auto& [w, h] : {std::pair{0, 10}, {10, -1}, {100000, 100000}, {16384, 16384}}) {
        EXPECT_THAT(core::error_text([w = w, h = h] { check_size(w, h); }),
                    testing::HasSubstr("1..16384 px a side"));
    }
    EXPECT_NO_THROW(check_size(1, 1));
    EXPECT_NO_THROW(check_size(7680, 4320));
}

TEST(LoadScene, AWordThatIsNeitherSceneNorFileListsTheScenes) {
    EXPECT_THAT(core::error_text([] { return load_scene("no_such_thing"); }),
                testing::HasSubstr(catalogue::catalogue().front().name));
}

TEST(LoadOneView, AnUnknownViewListsTheViews) {
    const auto& entry = catalogue::catalogue().front();
    const std::string first = entry.make().cameras.front().name;
    EXPECT_EQ(load_one_view(entry.name, "", {}).views.size(), 1U);
    EXPECT_THAT(core::error_text([&] { return load_one_view(entry.name, "from_nowhere", {}); }),
                testing::HasSubstr(first));
}

}  // namespace
}  // namespace ink::harness
