// Kinds of files on which readers of models are known to fail, from a file to a scene.

#include <gmock/gmock.h>

#include "import/imported_scene.h"
#include "tests/import/model_files.h"
#include "tests/import/quake_files.h"
#include "tests/import/read_meshes.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using FieldFiles = ModelFiles;

const std::string kObjCube = cube_corners("v ") + cube_faces("f", 1);
const std::string kOffCube = "OFF\n8 6 12\n" + cube_corners() + cube_faces("4", 0);
const std::string kStlTriangle =
    "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid x\n";
const std::string kPlyTriangle =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 "
    "1 2\n";

std::string utf16(const std::string& text, bool has_mark, bool is_big) {
    std::string wide;
    if (has_mark) wide = is_big ? "\xfe\xff" : "\xff\xfe";
    for (const char c : text)
        wide += is_big ? std::string{'\0', c} : std::string{c, '\0'};
    return wide;
}

TEST_F(FieldFiles, AByteOrderMarkIsReadOver) {
    EXPECT_EQ(scene::triangle_count(import_scene(write("a.obj", "\xef\xbb\xbf" + kObjCube))), 12U);
    EXPECT_EQ(scene::triangle_count(import_scene(write("a.off", "\xef\xbb\xbf" + kOffCube))), 12U);
    EXPECT_EQ(scene::triangle_count(import_scene(write("a.stl", "\xef\xbb\xbf" + kStlTriangle))),
              1U);
    EXPECT_EQ(scene::triangle_count(import_scene(write("a.ply", "\xef\xbb\xbf" + kPlyTriangle))),
              1U);
}

TEST_F(FieldFiles, Utf16IsRefusedByName) {
    for (const bool has_mark : {false, true})
        for (const bool is_big : {false, true}) {
            EXPECT_THAT(complaint(write("a.obj", utf16(kObjCube, has_mark, is_big))),
                        HasSubstr("is UTF-16 text"));
            EXPECT_THAT(complaint(write("a.stl", utf16(kStlTriangle, has_mark, is_big))),
                        HasSubstr("is UTF-16 text"));
        }
}

TEST_F(FieldFiles, PlyStlTextAndOffAreToldByContent) {
    for (const auto& [content, triangles] :
         {std::pair{kOffCube, 12U}, {kStlTriangle, 1U}, {kPlyTriangle, 1U}}) {
        EXPECT_EQ(scene::triangle_count(import_scene(write("odd.model", content))), triangles);
        EXPECT_EQ(scene::triangle_count(import_scene(write("odd.obj", content))), triangles);
    }
}

TEST_F(FieldFiles, AnEmptyPartBesideGoodOnesIsLeftOut) {
    const scene::Scene scene =
        import_scene(write("a.stl", "solid empty\nendsolid empty\n" + kStlTriangle));
    ASSERT_EQ(scene.instances.size(), 1U);
    EXPECT_EQ(scene.instances[0].name, "x");
}

TEST_F(FieldFiles, FaultsGoToTheUserWithTheirPlace) {
    EXPECT_EQ(complaint(write("a.off", replaced(kOffCube, "4 1 5 7 3", "4 1 5 9 3"))),
              "is damaged; line 16: a face has the vertex 9 (accepted: 0..7)");
    EXPECT_THAT(
        complaint(write("points.ply",
                        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty "
                        "float y\nproperty float z\nend_header\n0 0 0\n")),
        HasSubstr("it holds no triangle"));
}

TEST_F(FieldFiles, CoordinatesBeyondFloatsKeepTheirShape) {
    // 0.1 wide, 5e6 from zero, where floats are 0.5 apart.
    const scene::Scene scene = import_scene(
        write("far.obj", "v 5000000.1 0 5e6\nv 5000000.2 0 5e6\nv 5000000.1 .1 5e6\nf 1 2 3\n"));
    const auto& p = scene.meshes.at(0).positions;
    EXPECT_NEAR(p[1].x - p[0].x, 0.1, 1e-7);
    const glm::dvec3 in_file =
        scene.origin + glm::dvec3(scene::to_world(scene.instances.at(0), p[1]));
    EXPECT_NEAR(in_file.x, 5000000.2, 1e-7);
}

TEST_F(FieldFiles, NamesAreKeptInAnyScript) {
    const scene::Scene scene = import_scene(
        write("names.obj", "o Größe\n" + std::string(kTriangleObj) + "o 平面\nf 3 2 1\n"));
    ASSERT_EQ(scene.instances.size(), 2U);
    EXPECT_EQ(scene.instances[0].name, "Größe");
    EXPECT_EQ(scene.instances[1].name, "平面");
}

TEST_F(FieldFiles, NotesGoToTheScene) {
    const scene::Scene scene =
        import_scene(write("mixed.obj", std::string(kTriangleObj) + "l 1 2\np 3\n"));
    EXPECT_THAT(scene.file.notes,
                ElementsAre(HasSubstr("2 lines of the file with lines or points")));
}

}  // namespace
}  // namespace ink::import
