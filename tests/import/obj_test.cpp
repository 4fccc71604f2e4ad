#include <gmock/gmock.h>

#include "import/meshes/mesh_readers.h"
#include "import/model_bytes.h"
#include "tests/import/read_meshes.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string cube() {
    return cube_corners("v ") + cube_faces("f", 1);
}

std::vector<std::string> names_in(const ImportReply& reply) {
    std::vector<std::string> names;
    for (const ImportedInstance& instance : reply.instances)
        names.push_back(instance.name);
    return names;
}

TEST(Obj, Cube) {
    const ImportedMesh mesh = read_one(read_obj, cube());
    expect_unit_cube(mesh);
    EXPECT_EQ(mesh.positions.size(), 8U);
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_FALSE(mesh.are_floats);
}

TEST(Obj, LinesMayEndEitherWayAndGoOn) {
    for (const char* end : {"\r\n", "\r", "  \n\n", " # comment\n", " \\\n \n", "\\\r\n\r\n"})
        expect_unit_cube(read_obj, replaced(cube(), "\n", end));
    expect_unit_cube(read_obj, replaced(cube(), " ", " \\\n\t"));
    expect_unit_cube(read_obj, replaced(cube(), "f ", "fo "));
}

TEST(Obj, CornersMayBeNamedInAllWays) {
    // After the place, and once more from the end.
    for (const char* rest : {"", "/1", "//1", "/1/1", "/", "//", "-", "-/-1/-1"}) {
        const bool is_back = rest[0] == '-';
        const auto corner = [&](int i) {
            return std::to_string(is_back ? i - 4 : i) + (rest + (is_back ? 1 : 0)) + ' ';
        };
        const std::string corners = corner(1) + corner(2) + corner(3);
        const ImportedMesh mesh =
            read_one(read_obj, kThree + "vt 0 0\nvn 0 0 1\nf " + corners + '\n');
        EXPECT_THAT(mesh.triangles, ElementsAre(scene::Triangle{0, 1, 2})) << corners;
        EXPECT_THAT(mesh.positions,
                    ElementsAre(glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)));
    }
    EXPECT_EQ(read_one(read_obj, "f 1 2 3\n" + kThree).triangles.size(), 1U) << "before they come";
}

TEST(Obj, VerticesMayHaveWeightsAndColours) {
    expect_unit_cube(read_obj, cube_corners("v ", " 1\n") + cube_faces("f", 1));
    expect_unit_cube(read_obj, cube_corners("v ", " 1 0 .5\n") + cube_faces("f", 1));
    expect_unit_cube(read_obj, cube_corners("v ", " 1 1 0 .5\n") + cube_faces("f", 1));
}

TEST(Obj, DigitsAreKept) {
    const ImportedMesh mesh =
        read_one(read_obj, "v 5000003.1 0 1e-3\nv +1 .5 -2.\nv 1E2 1e+2 1e-400\nf 1 2 3\n");
    EXPECT_THAT(
        mesh.positions,
        ElementsAre(
            glm::dvec3(5000003.1, 0, 1e-3), glm::dvec3(1, .5, -2), glm::dvec3(100, 100, 0)));
}

TEST(Obj, AVertexIsAPairOfPositionAndNormal) {
    const ImportedMesh mesh = read_one(
        read_obj, kThree + "v 1 1 0\nvn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 2//1 4//2 3//2\n");
    EXPECT_EQ(mesh.positions.size(), 5U) << "vertex 3 with both normals";
    EXPECT_THAT(mesh.triangles, ElementsAre(scene::Triangle{0, 1, 2}, scene::Triangle{1, 3, 4}));
    EXPECT_EQ(mesh.positions[2], mesh.positions[4]);
    EXPECT_THAT(mesh.normals,
                ElementsAre(glm::vec3(0, 0, 1),
                            glm::vec3(0, 0, 1),
                            glm::vec3(0, 0, 1),
                            glm::vec3(0, 1, 0),
                            glm::vec3(0, 1, 0)));
}

ImportReply read_obj_with_texcoords(std::string_view file, const std::string& name) {
    return read_obj(file, name, {}, true);
}

TEST(Obj, TextureCoordinatesPartVerticesWhereTheyAreAskedFor) {
    const std::string file = kThree + "v 1 1 0\nvt 0.25 0.75\nvt 1\nf 1/1 2/1 3/1\nf 2/1 4 3/-1\n";
    EXPECT_EQ(read_one(read_obj, file).positions.size(), 4U);
    EXPECT_TRUE(read_one(read_obj, file).texcoords.empty());
    const ImportedMesh mesh = read_one(read_obj_with_texcoords, file);
    EXPECT_THAT(mesh.triangles, ElementsAre(scene::Triangle{0, 1, 2}, scene::Triangle{1, 3, 4}));
    EXPECT_EQ(mesh.positions[2], mesh.positions[4]);
    const glm::vec2 first(0.25, 0.25);  // v of glTF goes down
    EXPECT_THAT(mesh.texcoords, ElementsAre(first, first, first, glm::vec2(0), glm::vec2(1)));
    EXPECT_TRUE(read_one(read_obj_with_texcoords, cube()).texcoords.empty());
}

TEST(Obj, ObjectsAreMadeByOAlone) {
    const ImportReply reply = read_obj(kThree +
                                           "g ground\nf 1 2 3\no first one\nusemtl a\nf 1 2 3\n"
                                           "g x y\ns 1\nf 3 2 1\no second\no third\nf 1 2 3\n",
                                       "model");
    EXPECT_THAT(names_in(reply), ElementsAre("model", "first one", "third"))
        << "second has no face";
    EXPECT_EQ(reply.meshes[1].triangles.size(), 2U);
    EXPECT_THAT(names_in(read_obj(kThree + "g a\nf 1 2 3\ng b\nf 3 2 1\n", "model")),
                ElementsAre("model"));
}

TEST(Obj, NamesMayGoOnInTheNextLine) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        const ImportReply reply =
            read_obj(replaced("o first\\\none # it\n" + kThree + "f 1 2 3\n", "\n", end), "model");
        EXPECT_THAT(names_in(reply), ElementsAre("first one"));
    }
}

TEST(Obj, AnObjectThatComesAgainGoesOn) {
    const ImportReply reply =
        read_obj(kThree + "o a\nf 1 2 3\no b\nf 1 2 3\no a\nf 3 2 1\n", "model");
    EXPECT_THAT(names_in(reply), ElementsAre("a", "b"));
    EXPECT_EQ(reply.meshes[0].triangles.size(), 2U);
}

TEST(Obj, MaterialsMakeParts) {
    const ImportedMesh mesh =
        read_one(read_obj,
                 "mtllib none.mtl\n" + kThree +
                     "usemtl m\nf 1 2 3\nusemtl n\nf 1 2 3\nusemtl m\nf 1 2 3\n"
                     "usemtl m\nf 3 2 1\n");
    ASSERT_EQ(mesh.parts.size(), 3U);
    EXPECT_EQ(mesh.parts[1].first_triangle, 1U);
    EXPECT_EQ(mesh.parts[2].first_triangle, 2U);
    EXPECT_EQ(mesh.parts[0].material, mesh.parts[2].material);
    EXPECT_NE(mesh.parts[0].material, mesh.parts[1].material);
}

TEST(Obj, WhatHasNoAreaIsLeftOutWithANote) {
    const ImportReply reply = read_obj(
        cube() +
            "l 1 2\np 3\nf 1 2\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\nodd 1\n",
        "model");
    expect_unit_cube(reply.meshes.at(0));
    EXPECT_THAT(reply.notes,
                ElementsAre(HasSubstr("3 lines of the file"),
                            HasSubstr("1 curve"),
                            HasSubstr("1 line that OBJ does not know, first line 23")));
    EXPECT_THAT(read_obj(cube(), "model").notes, IsEmpty());
}

TEST(Obj, TransparentMaterialsInUseAreNoted) {
    const auto notes = [](const std::string& library) {
        const FilesBeside beside = [&](const std::string& name) {
            return name == "my shape.mtl" ? library : std::string();
        };
        const std::string file =
            "mtllib my shape.mtl\n" + kThree + "usemtl thin glass\nf 1 2 3\nusemtl wood\nf 1 2 3\n";
        return read_obj(file, "model", beside).notes;
    };
    EXPECT_THAT(notes(""), IsEmpty()) << "no such file";
    EXPECT_THAT(notes("newmtl thin glass\nd 1\nnewmtl wood\nTr 0\nnewmtl other\nd 0.5\n"),
                IsEmpty());
    EXPECT_THAT(notes("newmtl thin glass # see\n Kd 1 1 1\n d 0.5\n"),
                ElementsAre("1 transparent material is drawn opaque"));
    EXPECT_THAT(notes("newmtl thin glass\nd 0.5\nnewmtl wood\nTr 1\n"),
                ElementsAre("2 transparent materials are drawn opaque"));
}

TEST(Obj, MaterialsInUseHaveTheirColours) {
    const auto colors = [](const std::string& library) {
        const FilesBeside beside = [&](const std::string& name) {
            return name == "a.mtl" ? library : std::string();
        };
        const std::string file =
            "mtllib a.mtl\n" + kThree + "usemtl red\nf 1 2 3\nusemtl grey\nf 1 2 3\n";
        return read_obj(file, "model", beside).base_colors;
    };
    EXPECT_THAT(colors(""), IsEmpty()) << "no such file";
    EXPECT_THAT(colors("newmtl other\nKd 1 0 0\n"), IsEmpty());
    EXPECT_THAT(colors("Kd 9 9 9\nnewmtl red\nKd 1 0.5 0\nd 0.25\nnewmtl grey\nKd 0.5\n"),
                ElementsAre(glm::vec4(1, 0.5, 0, 0.25), glm::vec4(0.5, 0.5, 0.5, 1)));
    EXPECT_THAT(colors("newmtl red\nKd spectral x.rfl\nKd xyz 1 1 1\n"),
                ElementsAre(glm::vec4(1), glm::vec4(1)));
}

TEST(Obj, SurfacesAreRefused) {
    for (const char* statement : {"surf 0 1 0 1 1 2 3 4", "bzp 1 2 3", "call other.obj"}) {
        const std::string file = cube() + statement + "\nend\n";
        EXPECT_THAT(fault(read_obj, file), HasSubstr("line 15: \"")) << statement;
        EXPECT_THROW((void)read_obj(file, "model"), Refusal) << statement;
    }
}

TEST(Obj, FaultsAreNamedWithTheirLine) {
    const auto complaint = [](const std::string& lines) { return fault(read_obj, kThree + lines); };
    EXPECT_THAT(complaint("f 1 2 9\n"), HasSubstr("line 4: a corner has the vertex 9 (1..3)"));
    EXPECT_THAT(complaint("f 1 2 0\n"), HasSubstr("line 4: a corner has the number 0 (1..3"));
    EXPECT_THAT(complaint("f 1 2 -4\n"), HasSubstr("line 4: a corner has the number -4 (1..3"));
    EXPECT_THAT(complaint("f 1 2 3x\n"),
                HasSubstr("line 4: a corner has the number \"3x\" (v, v/vt"));
    EXPECT_THAT(complaint("f 1//1 2//1 3//1\n"),
                HasSubstr("line 4: a corner has the normal 1 (a file"));
    EXPECT_THAT(complaint("\nv 0 one 0\n"), HasSubstr("line 5: a vertex's coordinate is \"one\""));
    EXPECT_THAT(complaint("v 0 \\\n 0\n"), HasSubstr("line 5: a vertex's coordinate is missing"));
    EXPECT_THAT(complaint("vn 0 1\n"), HasSubstr("line 4: a normal's coordinate is missing"));
    const std::string faces = kThree + "vt 0 0\nf 1/1 2/1 3/2\n";
    EXPECT_EQ(read_one(read_obj, faces).triangles.size(), 1U) << "not asked for";
    EXPECT_THAT(fault(read_obj_with_texcoords, faces),
                HasSubstr("line 5: a corner has the texture coordinate 2 (1..1)"));
    EXPECT_THAT(fault(read_obj_with_texcoords, kThree + "vt 0 x\n"),
                HasSubstr("line 4: a texture coordinate is \"x\""));
}

}  // namespace
}  // namespace ink::import
