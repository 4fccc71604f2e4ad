#include "import/import.h"

#include <gmock/gmock.h>

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <vector>

#include "core/whole_file.h"
#include "scene/topology.h"
#include "tests/core/error_text.h"
#include "tests/import/model_files.h"
#include "tests/import/quake_files.h"
#include "tests/import/solids.h"
#include "tests/models/fetched_model.h"
#include "tests/scene/edge_counts.h"

namespace ink::import {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

using Import = ModelFiles;
using ImportRefuses = ModelFiles;

/// One triangle (0,0,0) (1,0,0) (0,1,0), placed as it is, mirrored in x and moved, and under a
/// turned parent; a camera 10 in front of it.
constexpr const char* kPlacedGltf = R"({
 "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2, 4]}],
 "nodes": [
  {"name": "plain", "mesh": 0},
  {"name": "mirrored", "mesh": 0, "scale": [-1, 1, 1], "translation": [0, 0, 5]},
  {"name": "parent", "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476],
   "translation": [10, 0, 0], "children": [3]},
  {"name": "child", "mesh": 0, "translation": [1, 0, 0]},
  {"name": "../eye", "camera": 0, "translation": [0, 2, 10]}],
 "cameras": [{"type": "perspective", "name": "../eye",
  "perspective": {"yfov": 0.8, "aspectRatio": 1.5, "znear": 0.1}}],
 "meshes": [{"name": "tri", "primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
  "min": [0, 0, 0], "max": [1, 1, 0]}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri":
  "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]
})";

/// A unit cube whose six quads are shared out between two materials.
constexpr const char* kTwoMaterialCube =
    "mtllib cube.mtl\n"
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "usemtl red\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\n"
    "usemtl blue\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

std::string binary_stl(const std::vector<std::array<float, 12>>& facets) {
    std::string bytes(80, ' ');
    put(bytes, static_cast<std::uint32_t>(facets.size()));
    for (const auto& facet : facets) {
        put(bytes, facet);
        put(bytes, std::uint16_t{0});
    }
    return bytes;
}

const scene::Instance& instance_named(const scene::Scene& scene, const std::string& name) {
    for (const scene::Instance& instance : scene.instances) {
        if (instance.name == name) return instance;
    }
    ADD_FAILURE() << "no instance " << name;
    return scene.instances.front();
}

TEST_F(Import, ReadsATriangleAsItStands) {
    const scene::Scene scene = import_scene(write("tri.obj", kTriangleObj));
    EXPECT_EQ(scene.name, "tri");
    EXPECT_EQ(scene.split, scene::Split::real);
    ASSERT_EQ(scene.meshes.size(), 1U);
    ASSERT_EQ(scene.instances.size(), 1U);
    const scene::Mesh& mesh = scene.meshes[0];
    EXPECT_THAT(mesh.positions,
                testing::ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
    EXPECT_THAT(mesh.triangles, testing::ElementsAre(scene::Triangle{0, 1, 2}));
    EXPECT_TRUE(mesh.normals.empty()) << "the file has none, and none are made up";
    EXPECT_EQ(scene.instances[0].world_from_object, glm::dmat4{1});
    EXPECT_TRUE(scene.cameras.empty());
}

TEST_F(Import, KeepsPlacementsMirrorsAndParents) {
    const scene::Scene scene = import_scene(write("placed.gltf", kPlacedGltf));
    EXPECT_EQ(scene.meshes.size(), 1U) << "one mesh, three times placed";
    ASSERT_EQ(scene.instances.size(), 3U);
    const glm::vec3 corner{1, 0, 0};
    EXPECT_EQ(scene::to_world(instance_named(scene, "plain"), corner), glm::dvec3(1, 0, 0));
    const scene::Instance mirrored = instance_named(scene, "mirrored");
    EXPECT_EQ(scene::to_world(mirrored, corner), glm::dvec3(-1, 0, 5));
    EXPECT_TRUE(scene::is_mirrored(mirrored));
    EXPECT_FALSE(scene::is_mirrored(instance_named(scene, "child")));
    // The parent turns by 90 degrees about z: (1,0,0) + (1,0,0) comes to (10,2,0).
    const glm::dvec3 turned = scene::to_world(instance_named(scene, "child"), corner);
    EXPECT_LT(glm::length(turned - glm::dvec3(10, 2, 0)), 1e-6);
}

TEST_F(Import, TakesTheFilesCamera) {
    const scene::Scene scene = import_scene(write("placed.gltf", kPlacedGltf));
    ASSERT_EQ(scene.cameras.size(), 1U);
    const scene::Camera& camera = scene.cameras[0];
    EXPECT_EQ(camera.name, "___eye") << "a word that is safe in a file name";
    EXPECT_EQ(camera.eye_world, glm::dvec3(0, 2, 10));
    EXPECT_NEAR(camera.fov_y_rad, 0.8, 1e-6);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(camera.view_from_world[axis][axis], 1, 1e-12) << "it looks along -z, y up";
    }
    EXPECT_GT(camera.near, 0);
    EXPECT_GT(camera.far, 10);
}

TEST_F(Import, FileSplitByMaterialWeldsIntoOneClosedSurface) {
    (void)write("cube.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    const scene::Scene scene = import_scene(write("cube.obj", kTwoMaterialCube));
    EXPECT_EQ(scene.meshes.size(), 1U) << "materials do not part an object";
    const scene::Topology topology = scene::weld(scene);
    EXPECT_EQ(topology.p_world.size(), 8U);
    EXPECT_EQ(topology.faces.size(), 12U);
    EXPECT_EQ(topology.edges.size(), 18U);
    EXPECT_EQ(scene::edge_counts(topology).boundary, 0U);
    std::map<std::uint32_t, int> faces_of_material;
    for (const scene::Face& face : topology.faces)
        ++faces_of_material[face.material];
    ASSERT_EQ(faces_of_material.size(), 2U);
    for (const auto& [material, faces] : faces_of_material)
        EXPECT_EQ(faces, 6) << material;
}

TEST_F(Import, KeepsTheFilesNormalsMadeUnit) {
    const scene::Scene scene =
        import_scene(write("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 3 4\nf 1//1 2//1 3//1\n"));
    ASSERT_EQ(scene.meshes[0].normals.size(), 3U);
    EXPECT_EQ(scene.meshes[0].normals[0], glm::vec3(0, 0.6F, 0.8F));
}

TEST_F(Import, NormalsThatAreNoneCountAsAbsent) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const std::array<float, 12> good{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::array<float, 12> zero{0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::array<float, 12> not_a_number{kNan, kNan, kNan, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::array<float, 12> without_area{0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0};
    const auto normals = [&](const std::vector<std::array<float, 12>>& facets) {
        return import_scene(write("facets.stl", binary_stl(facets))).meshes.at(0).normals.size();
    };
    EXPECT_EQ(normals({good, good}), 6U);
    EXPECT_EQ(normals({good, zero}), 0U);
    EXPECT_EQ(normals({good, not_a_number}), 0U);
    EXPECT_EQ(normals({good, without_area}), 6U) << "nobody sees that one";
}

TEST_F(Import, NamesArePrintable) {
    const scene::Scene scene =
        import_scene(write("names.obj", "o a\x1b[31mb\xff\n" + std::string(kTriangleObj)));
    EXPECT_EQ(scene.instances[0].name, "a?[31mb?");
}

TEST_F(Import, PathMayHoldSpacesAndDashes) {
    EXPECT_EQ(scene::triangle_count(import_scene(write("--help $(x) 'y'.obj", kTriangleObj))), 1U);
}

TEST_F(Import, ImportsTheSameTwice) {
    const auto path = write("placed.gltf", kPlacedGltf);
    EXPECT_EQ(scene::scene_hash(import_scene(path)), scene::scene_hash(import_scene(path)));
}

TEST_F(ImportRefuses, PathsThatAreNoFile) {
    EXPECT_EQ(complaint(in_folder("absent.obj")), "no such file");
    EXPECT_EQ(complaint(in_folder("")), "is a folder");
    EXPECT_EQ(complaint("/dev/null"), "is not a regular file");
}

TEST_F(ImportRefuses, AFileThatMayNotBeRead) {
    const auto path = write("secret.obj", kTriangleObj);
    std::filesystem::permissions(path, std::filesystem::perms::none);
    if (geteuid() == 0) GTEST_SKIP() << "skipped: root may read everything";
    EXPECT_EQ(complaint(path), "cannot be opened: Permission denied");
}

TEST_F(ImportRefuses, FilesThatAreNoModel) {
    std::string noise;
    std::uint32_t state = 1;
    for (int i = 0; i < 5000; ++i)
        noise.push_back(static_cast<char>((state = state * 1664525 + 1013904223) >> 24));
    EXPECT_EQ(complaint(write("empty.obj", "")), "the file is empty");
    EXPECT_EQ(complaint(write("prose.obj", "It was a dark and stormy night.\n")),
              "it holds no triangle");
    EXPECT_THAT(complaint(write("noise.glb", noise)),
                StartsWith("its content is not what its extension says"));
    EXPECT_THAT(complaint(write("noise.xyz", noise)), StartsWith("is not a kind of model file"));
    EXPECT_THAT(complaint(write("noextension", noise)), StartsWith("is not a kind of model file"));
    EXPECT_THAT(core::error_text([&] { return import_scene(in_folder("noise.xyz")); }),
                AllOf(HasSubstr(".obj"), HasSubstr(".glb"), HasSubstr(".md3")));
}

TEST_F(ImportRefuses, ModelsWithoutATriangle) {
    EXPECT_EQ(complaint(write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")),
              "it holds no triangle");
    EXPECT_EQ(complaint(write("line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n")), "it holds no triangle");
}

TEST_F(ImportRefuses, NumbersThatAreNotFinite) {
    EXPECT_EQ(complaint(write("nan.obj", "v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")),
              "mesh 0: vertex 0 is not finite");
    EXPECT_EQ(complaint(write("inf.obj", "v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n")),
              "mesh 0: vertex 1 is not finite");
}

TEST_F(ImportRefuses, FilesCutShort) {
    const std::array<float, 12> facet{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::string stl = binary_stl({facet, facet, facet});
    EXPECT_THAT(complaint(write("cut.stl", stl.substr(0, stl.size() - 60))),
                StartsWith("is damaged; the file is cut short: its header promises 234 bytes, it "
                           "has 174"));
    EXPECT_THAT(
        complaint(write("text.stl",
                        "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                        "vertex 0 1 0\nendloop\nendfacet\n")),
        StartsWith("is damaged; the file is cut short: its end mark is missing"));
    // Of parts that our readers do not look at.
    std::string lengths = "IDP2" + std::string(60, 'x');
    put(lengths, std::uint32_t{500});
    EXPECT_THAT(complaint(write("cut.md2", lengths)), HasSubstr("header promises 500 bytes"));
}

TEST_F(ImportRefuses, RealFilesCutShort) {
    for (const char* name :
         {"jeep.glb", "engine.glb", "duck.glb", "spider.stl", "dragon_coarse.ply"}) {
        const auto whole = fetched_model(name);
        INK_SKIP_WITHOUT(whole);
        const std::string bytes = core::read_whole_file(whole).value_or("");
        for (const double part : {0.1, 0.5, 0.9}) {
            const auto size = static_cast<std::size_t>(part * static_cast<double>(bytes.size()));
            EXPECT_NE(complaint(write(std::string("cut_") + name, bytes.substr(0, size))), "")
                << name << part;
        }
    }
}

TEST_F(ImportRefuses, MoreTrianglesThanItMayPlace) {
    ImportLimits limits;
    limits.triangles = 2;
    EXPECT_EQ(complaint(write("placed.gltf", kPlacedGltf), limits), "it holds 3 triangles");
}

/// A model that `experiments/models/fetch` gets, and what is in its file, counted from the bytes by
/// a few lines of Python.
struct KnownModel {
    const char* file;
    std::size_t triangles;
    std::size_t meshes;
    std::size_t instances;
    bool has_normals;
    glm::dvec3 low, high;
};

constexpr KnownModel kKnownModels[] = {
    {"aggressor.obj", 3300, 1, 1, false, {-736, -256, -1072}, {640, 576, 416}},
    {"bunny_coarse.obj",
     3674,
     1,
     1,
     false,
     {-4.95848, -.00315, -3.72983},
     {4.94885, 9.65475, 3.81064}},
    {"dragon_coarse.ply",
     47794,
     1,
     1,
     false,
     {-.107673, .052774, -.050051},
     {.095982, .196644, .040826}},
    {"engine.glb", 121496, 29, 67, true, {-371.692, -180.972, -140}, {371.692, 92.0416, 128}},
    {"penguin.obj", 1764, 1, 1, false, {-22.8438, -13.7969, -21.7889}, {22.4944, 34.4285, 24.6486}},
    {"spider.stl", 1368, 1, 1, true, {-3.114895, -4, -1.649329}, {3.114895, 4, 1.649329}},
    {"wuson.obj", 3732, 1, 1, true, {-.459976, -.000566, -1.622242}, {.459976, 1.515251, 1.622242}},
};

class KnownModels : public testing::TestWithParam<KnownModel> {};

TEST_P(KnownModels, HaveWhatTheirFilesHold) {
    const KnownModel& known = GetParam();
    const auto path = fetched_model(known.file);
    INK_SKIP_WITHOUT(path);
    const scene::Scene scene = import_scene(path);
    EXPECT_EQ(scene::triangle_count(scene), known.triangles);
    EXPECT_EQ(scene.meshes.size(), known.meshes);
    EXPECT_EQ(scene.instances.size(), known.instances);
    EXPECT_EQ(!scene.meshes[0].normals.empty(), known.has_normals);
    std::vector<glm::dvec3> places;
    for (const scene::Instance& instance : scene.instances)
        for (const glm::vec3& p : scene.meshes[instance.mesh].positions)
            places.push_back(scene::to_world(instance, p));
    // The table has six digits.
    expect_box(solid_of(places), known.low, known.high, 1e-5 * glm::length(known.high - known.low));
}

INSTANTIATE_TEST_SUITE_P(Import,
                         KnownModels,
                         testing::ValuesIn(kKnownModels),
                         [](const auto& test) {
                             const std::string file = test.param.file;
                             return file.substr(0, file.find('.'));
                         });

}  // namespace
}  // namespace ink::import
