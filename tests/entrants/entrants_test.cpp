#include "entrants/entrant.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "catalogue/catalogue.h"
#include "core/error.h"
#include "core/whole_file.h"
#include "entrants/view_files.h"
#include "harness/cells/cell.h"
#include "harness/clock/outside_method.h"
#include "harness/suite/suite.h"
#include "image_io/image_file.h"
#include "import/import.h"
#include "tests/core/temp_folder.h"

namespace ink::entrants {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr double kCrease_rad = 0.7;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

class Entrants : public testing::Test {
  protected:
    std::string write_program(const std::string& name, const std::string& text) const {
        const fs::path path = folder_ / name;
        core::write_whole_file(path, text);
        fs::permissions(path, fs::perms::owner_all);
        return path.string();
    }
    /// What drawing the cube by an entrant says.
    harness::DrawTimes draw(const std::string& path,
                            edge::EdgeImage& image,
                            double wall_s = 20) const {
        const harness::SceneViews cube = cube_view();
        const auto config = entrant_config(parse_entrant("mine=" + path), wall_s);
        const auto methods = harness::prepare_methods(std::span(&config, 1), cube.scene);
        std::vector<edge::EdgeImage> images;
        auto times = harness::draw_in_turns(methods, cube.views.front(), {}, images);
        image = images.front();
        return times.front();
    }
    static harness::SceneViews cube_view() {
        harness::ViewRequest request;
        request.width_px = 64;
        request.height_px = 36;
        return harness::load_one_view("cube", "", request);
    }

    const core::TempFolder folder_;
};

TEST_F(Entrants, AnImageFolderIsReadBySceneAndViewWithItsTimes) {
    const harness::SceneViews cube = cube_view();
    edge::EdgeImage dark(64, 36, 255);
    dark.at(5, 7) = 0;
    const fs::path file = folder_ / "cube" / (cube.views.front().camera.name + ".png");
    fs::create_directories(file.parent_path());
    image_io::write_png(dark, file);
    core::write_whole_file(folder_ / "times.csv",
                           "scene,view,draw_ms\ncube," + cube.views.front().camera.name + ",1.5\n");
    edge::EdgeImage image;
    const harness::DrawTimes times = draw(folder_.string(), image);
    EXPECT_EQ(times.failure, "");
    EXPECT_EQ(image.at(5, 7), 255) << "dark lines on light are lines";
    EXPECT_EQ(image.at(6, 7), 0);
    EXPECT_EQ(times.clock, "own");
    EXPECT_THAT(times.draws_ns(), testing::ElementsAre(1'500'000)) << "its own clock, once";
}

TEST_F(Entrants, AProgramGetsTheViewAndItsImageIsTaken) {
    const std::string source = (folder_ / "source.png").string();
    edge::EdgeImage light(64, 36, 0);
    light.at(9, 3) = 255;
    image_io::write_png(light, source);
    const std::string program =
        write_program("draws",
                      "#!/bin/sh\ngrep -q '\"scene\": \"cube\"' \"$1\" || exit 4\n"
                      "cp " +
                          source + " \"$2\"\necho draw_ms 2.25\n");
    edge::EdgeImage image;
    const harness::DrawTimes times = draw(program, image);
    EXPECT_EQ(times.failure, "");
    EXPECT_EQ(image, light);
    EXPECT_EQ(times.clock, "own");
    EXPECT_THAT(times.draws_ns(), testing::ElementsAre(2'250'000));
}

TEST_F(Entrants, AProgramThatNamesNoTimeIsTimedByWhatItAndItsChildrenWork) {
    const std::string source = (folder_ / "source.png").string();
    image_io::write_png(edge::EdgeImage(64, 36, 255), source);
    const std::string works = "python3 -c 'import time\nwhile time.process_time() < 0.2: pass'\n";
    const std::string program =
        write_program("works", "#!/bin/sh\n" + works + "sleep 0.3\ncp " + source + " \"$2\"\n");
    edge::EdgeImage image;
    const harness::DrawTimes times = draw(program, image);
    ASSERT_EQ(times.failure, "");
    EXPECT_EQ(times.clock, "children");
    ASSERT_EQ(times.draws.size(), 1U);
    EXPECT_GE(times.draws[0].cpu_ns, 200'000'000);
    EXPECT_GE(times.draws[0].wall_ns, 500'000'000) << "it slept, too";
    EXPECT_LT(times.draws[0].cpu_ns, times.draws[0].wall_ns - 200'000'000);
    EXPECT_EQ(times.draws_ns().front(), times.draws[0].cpu_ns);
}

TEST_F(Entrants, AProgramThatFailsSaysHow) {
    edge::EdgeImage image;
    const auto failure = [&](const std::string& script, double wall_s = 20) {
        return draw(write_program("fails", "#!/bin/sh\n" + script + "\n"), image, wall_s).failure;
    };
    EXPECT_THAT(failure("echo 'no camera' >&2; exit 3"), HasSubstr("exit code 3: no camera"));
    EXPECT_THAT(failure("kill -SEGV $$"), HasSubstr("crashed (signal 11)"));
    EXPECT_THAT(failure("sleep 60", 0.2), HasSubstr("longer than 0.2 s"));
    EXPECT_THAT(failure("true"), HasSubstr("wrote no image"));
    EXPECT_THAT(failure("echo text > \"$2\""), HasSubstr("of its image: not an image"));
    EXPECT_THAT(failure("yes"), HasSubstr("printed more than 1 MiB"));
}

TEST_F(Entrants, MemoryIsLimitedByWhatIsWrittenNotByWhatIsReserved) {
    if (kIsSanitized) GTEST_SKIP() << "skipped: no memory limit is set under the sanitizer";
    const auto failure = [&](const std::string& access, const std::string& size) {
        const std::string program =
            write_program("maps",
                          "#!/usr/bin/python3\nimport mmap\nmmap.mmap(-1, " + size +
                              ", mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS, mmap." + access + ")\n");
        edge::EdgeImage image;
        return draw(program, image).failure;
    };
    EXPECT_THAT(failure("PROT_READ", "64 << 30"), HasSubstr("wrote no image")) << "it went on";
    EXPECT_THAT(failure("PROT_WRITE", "1 << 20"), HasSubstr("wrote no image")) << "it went on";
    EXPECT_THAT(failure("PROT_WRITE", "9 << 30"), HasSubstr("Cannot allocate memory"));
}

TEST_F(Entrants, AWrongSizeAndAMissingViewAreThatViewsFailure) {
    edge::EdgeImage image;
    EXPECT_THAT(draw(folder_.string(), image).failure, HasSubstr("no such file"));
    const fs::path file = folder_ / "cube" / (cube_view().views.front().camera.name + ".png");
    fs::create_directories(file.parent_path());
    image_io::write_png(edge::EdgeImage(10, 12, 0), file);
    EXPECT_THAT(draw(folder_.string(), image).failure,
                HasSubstr("its size is 10 x 12 px (accepted: 64 x 36 px"));
}

TEST_F(Entrants, NamesAndPathsAreChecked) {
    EXPECT_THROW((void)parse_entrant("mine"), core::Error);
    EXPECT_THROW((void)parse_entrant("=" + folder_.string()), core::Error);
    EXPECT_THROW((void)parse_entrant("mote4=" + folder_.string()), core::Error) << "a method";
    EXPECT_THROW((void)parse_entrant("oracle=" + folder_.string()), core::Error) << "a baseline";
    EXPECT_THROW((void)parse_entrant("mine=" + (folder_ / "nowhere").string()), core::Error);
    core::write_whole_file(folder_ / "text", "hello");
    EXPECT_THROW((void)parse_entrant("mine=" + (folder_ / "text").string()), core::Error);
    EXPECT_FALSE(parse_entrant("mine=" + folder_.string()).is_program);
}

TEST_F(Entrants, AMethodSaysWhatItIs) {
    const std::string program = write_program("draw.sh", "#!/bin/sh\n");
    const auto summary = [](const std::string& path) {
        return entrant_config(parse_entrant("mine=" + path)).info->summary;
    };
    EXPECT_EQ(summary(program), "a program from outside");
    EXPECT_EQ(summary(folder_.string()), "images from outside");
}

TEST_F(Entrants, AnotherImageIsAnotherExperiment) {
    const auto params = [&] {
        const auto config = entrant_config(parse_entrant("mine=" + folder_.string()));
        return config.info->complete({});
    };
    const auto before = params();
    EXPECT_EQ(params(), before);
    core::write_whole_file(folder_ / "new.png", "x");
    EXPECT_NE(params().at("content"), before.at("content"));
}

TEST_F(Entrants, ObjHasEveryTriangleInWorldSpace) {
    const scene::Scene scene = catalogue::make_catalogue_scene("blocks");
    write_obj(scene, folder_ / "mesh.obj");
    std::ifstream file(folder_ / "mesh.obj");
    std::string word;
    std::size_t objects = 0;
    std::size_t faces = 0;
    std::vector<glm::dvec3> points;
    while (file >> word) {
        objects += word == "o" ? 1 : 0;
        faces += word == "f" ? 1 : 0;
        if (word != "v") continue;
        glm::dvec3& p = points.emplace_back();
        file >> p.x >> p.y >> p.z;
    }
    EXPECT_EQ(objects, scene.instances.size());
    EXPECT_EQ(faces, scene::triangle_count(scene));
    std::size_t n = 0;
    for (const scene::Instance& instance : scene.instances) {
        for (const glm::vec3& p : scene.meshes[instance.mesh].positions)
            EXPECT_EQ(points[n++], scene::to_world(instance, p)) << "to the last bit";
    }
}

TEST_F(Entrants, GlbHoldsTheMeshesAndNodes) {
    const scene::Scene scene = catalogue::make_catalogue_scene("figure");
    write_glb(scene, {}, folder_ / "mesh.glb");
    const std::string bytes = core::read_whole_file(folder_ / "mesh.glb").value_or("");
    ASSERT_EQ(bytes.substr(0, 4), "glTF");
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 12, sizeof length);
    const auto gltf = nlohmann::json::parse(bytes.substr(20, length));
    EXPECT_EQ(gltf["nodes"].size(), scene.instances.size());
    EXPECT_EQ(gltf["meshes"].size(), scene.meshes.size());
    std::size_t corners = 0;
    for (const auto& mesh : gltf["meshes"]) {
        for (const auto& primitive : mesh["primitives"])
            corners += gltf["accessors"][primitive["indices"].get<std::size_t>()]["count"]
                           .get<std::size_t>();
    }
    std::size_t expected = 0;
    for (const scene::Mesh& mesh : scene.meshes)
        expected += 3 * mesh.triangles.size();
    EXPECT_EQ(corners, expected);
    // A viewer without anything to mirror shows metal black.
    for (const auto& material : gltf["materials"])
        EXPECT_EQ(material["pbrMetallicRoughness"]["metallicFactor"], 0);
}

TEST_F(Entrants, GlbHoldsCamerasThatComeBack) {
    const scene::Scene scene = catalogue::make_catalogue_scene("figure");
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    std::vector<scene::View> views = {{scene.cameras.front(), 160, 90},
                                      {scene.cameras.back(), 160, 90}};
    views[1].camera = scene::projected(scene::ProjectionKind::parallel, views[1].camera, bounds);
    views[1].camera.name = "flat";
    write_glb(scene, views, folder_ / "mesh.glb");
    const scene::Scene again = import::import_scene(folder_ / "mesh.glb");
    ASSERT_EQ(again.cameras.size(), 2U);
    EXPECT_EQ(again.cameras[0].fov_y_rad, views[0].camera.fov_y_rad);
    EXPECT_FALSE(again.cameras[0].is_parallel());
    EXPECT_EQ(again.cameras[1].name, "flat");
    EXPECT_NEAR(again.cameras[1].height_world, views[1].camera.height_world, 1e-12);
    for (std::size_t v = 0; v < 2; ++v) {
        // Where a parallel camera stands along its view direction is of no account.
        glm::dvec3 moved_view = views[v].camera.view_from_world *
                                (again.cameras[v].eye_world - views[v].camera.eye_world);
        if (views[v].camera.is_parallel()) moved_view.z = 0;
        EXPECT_LT(glm::length(moved_view), 1e-12);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LT(glm::distance(again.cameras[v].view_from_world[axis],
                                    views[v].camera.view_from_world[axis]),
                      1e-9);
        }
    }
}

class Projected : public testing::TestWithParam<scene::ProjectionKind> {};

INSTANTIATE_TEST_SUITE_P(Either,
                         Projected,
                         testing::Values(scene::ProjectionKind::perspective,
                                         scene::ProjectionKind::parallel));

TEST_P(Projected, BuffersAreThoseOfTheSurfaceThatIsSeen) {
    harness::ViewRequest request;
    request.projections = {GetParam()};
    request.width_px = 160;
    request.height_px = 90;
    const harness::SceneViews ball = harness::load_one_view("sphere", "", request);
    const scene::View& view = ball.views.front();
    const ViewBuffers buffers = view_buffers(ball.scene, view, kCrease_rad);
    const scene::Projection projection(view);
    const scene::Sphere bounds = scene::bounding_sphere(ball.scene);
    int seen = 0;
    for (int y = 0; y < view.height_px; ++y) {
        for (int x = 0; x < view.width_px; ++x) {
            const float w = buffers.w.at(x, y);
            if (std::isinf(w)) {
                EXPECT_EQ(buffers.object.at(x, y), 0xffffffffU);
                continue;
            }
            ++seen;
            EXPECT_EQ(buffers.object.at(x, y), 0U);
            const glm::dvec3 p_world = projection.at(x + 0.5, y + 0.5, static_cast<double>(w));
            const glm::dvec3 out = (p_world - bounds.center_world) / bounds.radius;
            EXPECT_NEAR(glm::length(out), 1, 0.02) << "on the ball";
            const glm::dvec3 n_view = view.camera.view_from_world * glm::normalize(out);
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(buffers.normal[i].at(x, y), n_view[static_cast<int>(i)], 0.1);
        }
    }
    EXPECT_GT(seen, 500);
}

TEST_P(Projected, MatricesOfJsonPutPointsWhereTheProjectionDoes) {
    harness::ViewRequest request;
    request.projections = {GetParam()};
    request.width_px = 160;
    request.height_px = 90;
    const harness::SceneViews cube = harness::load_one_view("cube", "", request);
    const scene::View& view = cube.views.front();
    const auto json = nlohmann::json::parse(view_json(cube.scene, view, {}));
    const auto times = [&](const char* matrix, const std::array<double, 4>& p) {
        std::array<double, 4> result{};
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j)
                result[i] += json[matrix][i][j].get<double>() * p[j];
        }
        return result;
    };
    for (const glm::dvec3 p : {glm::dvec3(0.1, 0.2, 0.3), {-0.5, 0.4, 0.2}}) {
        const auto clip = times("clip_from_view", times("view_from_world", {p.x, p.y, p.z, 1}));
        const glm::dvec3 expected = scene::Projection(view).to_clip(p);
        EXPECT_NEAR((clip[0] / clip[3] + 1) / 2 * 160, expected.x / expected.z, 1e-9);
        EXPECT_NEAR((1 - clip[1] / clip[3]) / 2 * 90, expected.y / expected.z, 1e-9);
        EXPECT_LT(std::abs(clip[2] / clip[3]), 1) << "between near and far";
    }
}

}  // namespace
}  // namespace ink::entrants
