#include <gmock/gmock.h>

#include "import/meshes/mesh_readers.h"
#include "import/model_bytes.h"
#include "tests/import/read_meshes.h"

namespace ink::import {
namespace {

using testing::HasSubstr;

std::string cube(const std::string& head = "OFF\n8 6 12\n",
                 const std::string& vertex_end = "\n",
                 const std::string& face_end = "\n") {
    return head + cube_corners("", vertex_end) + cube_faces("4", 0, face_end);
}

TEST(Off, Cube) {
    const ImportedMesh mesh = read_one(read_off, cube());
    expect_unit_cube(mesh);
    EXPECT_EQ(mesh.positions[4], glm::dvec3(1, 0, 0));
    EXPECT_FALSE(mesh.are_floats);
}

TEST(Off, CommentsMayStandAnywhere) {
    expect_unit_cube(read_off,
                     cube("# first\nOFF # kind\n\n# counts\n8 # vertices\n 6 12 # the rest\n",
                          " # a corner\n# between\n",
                          "# a face\n\n"));
}

TEST(Off, HeadsOfAllKinds) {
    expect_unit_cube(read_off, cube("OFF 8 6 12\n"));
    expect_unit_cube(read_off, cube("OFF\n8 6\n"));
    expect_unit_cube(read_off, cube("# a\nOFF8 6 12\n"));
    expect_unit_cube(read_off, cube("8 6 0\n"));  // the word may be missing
    expect_unit_cube(read_off, cube("COFF\n8 6 0\n", " 255 0 0\n"));
    expect_unit_cube(read_off, cube("COFF\n8 6 0\n", " .5 0 0 1\n", " 255 255 255\n"));
    expect_unit_cube(read_off, cube("STOFF\n8 6 0\n", " .5 .5\n"));
    for (const char* word : {"NOFF", "CNOFF", "NCOFF", "STCNOFF"}) {
        const bool has_more = std::string(word) != "NOFF";
        const ImportedMesh mesh = read_one(
            read_off,
            cube(std::string(word) + "\n8 6 0\n", has_more ? " 0 0 2 1 0 0 1\n" : " 0 0 2\n"));
        expect_unit_cube(mesh);
        ASSERT_EQ(mesh.normals.size(), 8U) << word;
        EXPECT_EQ(mesh.normals[7], glm::vec3(0, 0, 2)) << word;
    }
}

TEST(Off, LinesMayEndEitherWay) {
    for (const char* end : {"\r\n", "\r"})
        expect_unit_cube(read_off, replaced(cube(), "\n", end));
}

TEST(Off, IsToldByItsWord) {
    EXPECT_TRUE(is_off("OFF\n"));
    EXPECT_TRUE(is_off("# a\n STCN4OFF 3"));
    EXPECT_TRUE(is_off("OFF490 518 0"));
    EXPECT_FALSE(is_off("OFFSET 3"));
    EXPECT_FALSE(is_off("solid\n"));
}

TEST(Off, OtherKindsAreRefusedByName) {
    for (const char* head : {"4OFF\n8 6 0\n", "nOFF 3\n8 6 0\n", "OFF BINARY\n"}) {
        EXPECT_THAT(fault(read_off, cube(head)), HasSubstr("is an OFF file of the kind \""));
        EXPECT_THROW((void)read_off(cube(head), "model"), Refusal) << head;
    }
}

TEST(Off, FaultsAreNamedWithTheirLine) {
    expect_faults(read_off,
                  cube(),
                  {{"8 6 12", "8 six 12", "line 2: the count of faces is \"six\""},
                   {"4 1 5 7 3", "4 1 5 8 3", "line 16: a face has the vertex 8 (0..7)"},
                   {"4 1 5 7 3", "4 1 5 7", "line 16: a corner is missing"},
                   {"1 1 1\n", "1 1\n", "line 10: a vertex's coordinate is missing"},
                   {"1 1 1\n", "1 1 1 9 9\n", "line 10: more numbers than a vertex has"},
                   {"4 1 5 7 3\n", "", "cut short: it ends inside its faces"}});
    EXPECT_THAT(fault(read_off, "OFF\n8000000000 1 0\n"), HasSubstr("too many vertices"));
    EXPECT_THAT(fault(read_off, "OFF\n4000000000 4000000000 0\n"), HasSubstr("cut short"));
}

}  // namespace
}  // namespace ink::import
