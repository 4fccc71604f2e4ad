#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "import/meshes/mesh_readers.h"
#include "tests/core/error_text.h"
#include "tests/import/quake_files.h"
#include "tests/import/read_meshes.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "property list uchar int vertex_indices\n";

std::string header(const std::string& format, const std::string& elements) {
    return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

std::string text_cube() {
    return header("ascii", "element vertex 8\n" + kXyz + "element face 6\n" + kFaces) +
           cube_corners() + cube_faces("4", 0);
}

TEST(Ply, TextCube) {
    const ImportedMesh mesh = read_one(read_ply, text_cube());
    expect_unit_cube(mesh);
    EXPECT_EQ(mesh.name, "model");
    EXPECT_EQ(mesh.positions[1], glm::dvec3(0, 0, 1)) << "in the file's order";
    EXPECT_FALSE(mesh.are_floats) << "decimal text";
}

TEST(Ply, LinesMayEndEitherWay) {
    for (const char* end : {"\r\n", "\r"})
        expect_unit_cube(read_ply, replaced(text_cube(), "\n", end));
}

TEST(Ply, HeaderMayHoldRemarks) {
    const std::string remarks = "comment element vertex 99\nobj_info by hand\n\n";
    expect_unit_cube(read_ply, replaced(text_cube(), "element face", remarks + "element face"));
    // As Blender 2.4 wrote it.
    expect_unit_cube(read_ply,
                     replaced(text_cube(), "element vertex", "Created by Blender\nelement vertex"));
}

template <class T>
void put_in_order(std::string& bytes, T value, bool is_big) {
    put(bytes, value);
    if (is_big) std::reverse(bytes.end() - static_cast<std::ptrdiff_t>(sizeof value), bytes.end());
}

/// The cube as binary: x of type X, y of Y, z of Z, lists of type Count and Index.
template <class X, class Y, class Z, class Count, class Index>
std::string binary_cube(const std::array<std::string, 5>& types, bool is_big) {
    std::string file =
        header(is_big ? "binary_big_endian" : "binary_little_endian",
               "element vertex 8\nproperty " + types[0] + " x\nproperty " + types[1] +
                   " y\nproperty " + types[2] + " z\nelement face 6\nproperty list " + types[3] +
                   ' ' + types[4] + " vertex_index\n");
    for (int i = 0; i < 8; ++i) {
        const auto p = cube_corner(i);
        put_in_order(file, static_cast<X>(p[0]), is_big);
        put_in_order(file, static_cast<Y>(p[1]), is_big);
        put_in_order(file, static_cast<Z>(p[2]), is_big);
    }
    for (const auto& face : kCubeFaces) {
        put_in_order(file, static_cast<Count>(4), is_big);
        for (const int corner : face)
            put_in_order(file, static_cast<Index>(corner), is_big);
    }
    return file;
}

TEST(Ply, AllTypesInBothOrdersByBothNames) {
    for (const bool is_big : {false, true}) {
        expect_unit_cube(read_ply,
                         binary_cube<float, double, std::int8_t, std::uint8_t, std::int32_t>(
                             {"float", "double", "char", "uchar", "int"}, is_big));
        expect_unit_cube(
            read_ply,
            binary_cube<std::int16_t, std::uint16_t, std::uint32_t, std::uint16_t, std::int16_t>(
                {"int16", "uint16", "uint32", "uint16", "int16"}, is_big));
        expect_unit_cube(read_ply,
                         binary_cube<std::int32_t, float, double, std::uint32_t, std::uint8_t>(
                             {"int32", "float32", "float64", "uint", "uint8"}, is_big));
    }
}

TEST(Ply, BinaryFloatsAreFloatsAndDoublesAreKept) {
    const std::string faces = "element face 0\n" + kFaces;
    const auto read = [&](const std::string& type, const std::string& body) {
        return read_ply(header("binary_little_endian",
                               "element vertex 1\nproperty " + type + " x\nproperty " + type +
                                   " y\nproperty " + type + " z\n" + faces) +
                            body,
                        "model")
            .meshes.at(0);
    };
    std::string floats;
    std::string doubles;
    for (int i = 0; i < 3; ++i) {
        put(floats, 0.1F);
        put(doubles, 0.1);
    }
    EXPECT_TRUE(read("float", floats).are_floats);
    EXPECT_EQ(read("float", floats).positions[0].x, double{0.1F});
    EXPECT_FALSE(read("double", doubles).are_floats);
    EXPECT_EQ(read("double", doubles).positions[0].x, 0.1);
}

TEST(Ply, TextIsKeptToTheLastDigit) {
    const std::string file = replaced(text_cube(), "0 0 1\n", "0 0 5000003.1000000001\n");
    EXPECT_EQ(read_one(read_ply, file).positions[1].z, 5000003.1000000001);
}

TEST(Ply, BodyMayBeginWithTheByteOfALineFeed) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        const std::string file =
            replaced(header("binary_little_endian",
                            "element vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar "
                            "z\nelement face 1\n" +
                                kFaces),
                     "\n",
                     end) +
            std::string("\n\0\0\r\1\0\0\0\1", 9) + std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
        const ImportedMesh mesh = read_one(read_ply, file);
        EXPECT_THAT(mesh.positions,
                    ElementsAre(glm::dvec3(10, 0, 0), glm::dvec3(13, 1, 0), glm::dvec3(0, 0, 1)));
    }
}

TEST(Ply, IndicesThatAreNoNumbersAreShown) {
    std::string body;
    for (int i = 0; i < 9; ++i)
        put(body, 0.1F);
    body += '\3';
    for (int i = 0; i < 3; ++i)
        put(body, std::numeric_limits<float>::quiet_NaN());
    const std::string file = header("binary_little_endian",
                                    "element vertex 3\nproperty float x\nproperty float y\n"
                                    "property float z\nelement face 1\n"
                                    "property list uchar float vertex_indices\n") +
                             body;
    EXPECT_THAT(core::error_text([&] { return read_ply(file, "model"); }),
                testing::HasSubstr("a face has the vertex nan"));
}

TEST(Ply, ElementsAndPropertiesComeInAnyOrder) {
    const std::string file =
        header("ascii",
               "element material 1\nproperty int a\nproperty list uchar float b\nelement face 6\n"
               "property list uchar float texcoord\nproperty list uchar int vertex_indices\n"
               "property uchar red\nelement vertex 8\nproperty uchar red\nproperty double z\n"
               "property double y\nproperty double x\n") +
        "7 3 .1 .2 .3\n" + replaced(cube_faces("2 .5 .5 4", 0, " 255\n"), "\n", "\n") + [] {
            std::string vertices;
            for (int i = 0; i < 8; ++i) {
                const auto p = cube_corner(i);
                vertices += "9 " + std::to_string(p[2]) + ' ' + std::to_string(p[1]) + ' ' +
                            std::to_string(p[0]) + '\n';
            }
            return vertices;
        }();
    expect_unit_cube(read_ply, file);
}

TEST(Ply, StripsTurnAsOpenGlTurnsThemAndBeginAnewAtMinusOne) {
    const ImportedMesh mesh =
        read_one(read_ply,
                 header("ascii",
                        "element vertex 6\n" + kXyz +
                            "element tristrips 1\nproperty list int int vertex_indices\n") +
                     "0 0 0\n0 1 0\n1 0 0\n1 1 0.5\n2 0 0\n2 1 0.7\n9 0 1 2 3 -1 5 4 3 2\n");
    EXPECT_THAT(mesh.triangles,
                ElementsAre(scene::Triangle{0, 1, 2},
                            scene::Triangle{2, 1, 3},
                            scene::Triangle{5, 4, 3},
                            scene::Triangle{3, 4, 2}));
}

TEST(Ply, KeepsNormals) {
    const ImportedMesh mesh = read_one(
        read_ply,
        header("ascii",
               "element vertex 3\n" + kXyz +
                   "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n" +
                   kFaces) +
            "0 0 0 0 0 1\n1 0 0 0 1 0\n0 1 0 1 0 0\n3 0 1 2\n");
    EXPECT_THAT(mesh.normals,
                ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0)));
}

TEST(Ply, KeepsTextureCoordinatesByAllNames) {
    for (const auto& [u, v] : {std::pair("s", "t"), {"u", "v"}, {"texture_u", "texture_v"}}) {
        const std::string properties =
            kXyz + "property float " + u + "\nproperty float " + v + '\n';
        const ImportedMesh mesh = read_one(
            read_ply,
            header("ascii", "element vertex 3\n" + properties + "element face 1\n" + kFaces) +
                "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0.5 0.75\n3 0 1 2\n");
        EXPECT_THAT(mesh.texcoords,
                    ElementsAre(glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(0.5, 0.25)))
            << u;
    }
}

TEST(Ply, WhatHasNoAreaIsLeftOutWithANote) {
    const ImportReply reply =
        read_ply(header("ascii",
                        "element vertex 8\n" + kXyz + "element face 7\n" + kFaces +
                            "element edge 2\nproperty int vertex1\nproperty int vertex2\n") +
                     cube_corners() + cube_faces("4", 0) + "2 0 1\n0 1\n1 2\n",
                 "model");
    expect_unit_cube(reply.meshes.at(0));
    EXPECT_THAT(reply.notes,
                ElementsAre(HasSubstr("1 face of less than 3 corners"), HasSubstr("2 edges")));
}

TEST(Ply, ElementsWithoutRowsMayLackAnything) {
    const ImportReply reply = read_ply(
        header("ascii", "element vertex 1\n" + kXyz + "element face 0\n") + "0 0 0\n", "model");
    EXPECT_TRUE(reply.meshes.at(0).triangles.empty());
}

TEST(Ply, NumbersBehindTheLastRowAreLeftAlone) {
    expect_unit_cube(read_ply, text_cube() + "1 2 3\n");
}

TEST(Ply, FaultsAreNamedWithTheirLine) {
    expect_faults(
        read_ply,
        text_cube(),
        {{"float y", "float8 y", "line 5: the type is \"float8\" (char, "},
         {"ascii", "utf8", "line 2: the format is \"utf8\" (ascii, "},
         {"1.0", "2.0", "line 2: the version is \"2.0\" (1.0)"},
         {"element face", "elemen face", "line 7: the header says \"elemen\""},
         {"vertex 8", "vertex -8", "line 3: the element's count is \"-8\""},
         // The first face is read as a vertex.
         {"vertex 8", "vertex 9", "more numbers than the properties"},
         {"face 6", "face 7", "cut short: it ends in element \"face\", row 7"},
         {"4 1 5 7 3", "4 1 5 8 3", "line 23: a face has the vertex 8 (0..7)"},
         {"4 1 5 7 3", "4 1 5 -1 3", "a face has the vertex -1 (0..7)"},
         {"1 1 1\n", "1 one 1\n", "line 17: a number of element \"vertex\" is \"one\" (a number)"},
         {"1 1 1\n", "1 1\n", "line 17: a number of element \"vertex\" is missing"},
         {"float z", "float w", "line 3: vertices lack x, y or z"},
         {"vertex_indices", "corners", "line 7: element \"face\" has no list"},
         {"list uchar", "list float", "the length of a list is a fraction"},
         {"end_header", "end", "line 9: the header says \"end\""},
         {"element vertex", "element point", "no element \"vertex\""}});
    EXPECT_THAT(fault(read_ply, "ply\nformat ascii 1.0\n"), HasSubstr("ends inside its header"));
    EXPECT_THAT(fault(read_ply, "plough\nend_header\n"), HasSubstr("line 1: the file begins with"));
}

TEST(Ply, HostileCountsAllocateNothing) {
    const std::string many =
        "element vertex 4000000000\n" + kXyz + "element face 4000000000\n" + kFaces;
    EXPECT_THAT(fault(read_ply, header("binary_little_endian", many)), HasSubstr("cut short"));
    EXPECT_THAT(fault(read_ply, header("ascii", many)), HasSubstr("cut short"));
    EXPECT_THAT(fault(read_ply, header("ascii", "element vertex 8000000000\n" + kXyz)),
                HasSubstr("too many vertices"));
    const std::string list = header(
        "binary_little_endian",
        "element vertex 0\n" + kXyz + "element face 1\nproperty list uint int vertex_indices\n");
    EXPECT_THAT(fault(read_ply, list + "\xff\xff\xff\xff"), HasSubstr("cut short"));
    (void)read_ply(header("ascii", "element nothing 4000000000\nelement vertex 0\n" + kXyz),
                   "model");
}

TEST(Ply, CutAnywhereIsAFault) {
    for (const std::string& whole : {text_cube(),
                                     binary_cube<float, float, float, std::uint8_t, std::int32_t>(
                                         {"float", "float", "float", "uchar", "int"}, false)}) {
        for (std::size_t size = 4; size + 3 < whole.size(); size += 3)
            EXPECT_THROW((void)read_ply(whole.substr(0, size), "model"), core::Error) << size;
    }
}

}  // namespace
}  // namespace ink::import
