#include <gmock/gmock.h>

#include "import/meshes/mesh_readers.h"
#include "tests/import/quake_files.h"
#include "tests/import/read_meshes.h"

namespace ink::import {
namespace {

using testing::HasSubstr;

/// Three corners of each triangle of the cube.
std::vector<std::array<std::array<int, 3>, 3>> cube_facets() {
    std::vector<std::array<std::array<int, 3>, 3>> facets;
    for (const auto& f : kCubeFaces) {
        facets.push_back({cube_corner(f[0]), cube_corner(f[1]), cube_corner(f[2])});
        facets.push_back({cube_corner(f[0]), cube_corner(f[2]), cube_corner(f[3])});
    }
    return facets;
}

std::string text_cube(const std::string& name = "box") {
    std::string text = "solid " + name + '\n';
    for (const auto& facet : cube_facets()) {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for (const auto& p : facet) {
            text += "      vertex " + std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' +
                    std::to_string(p[2]) + '\n';
        }
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid " + name + '\n';
}

std::string binary_cube(const std::string& header = "binary") {
    std::string bytes = header + std::string(80 - header.size(), '\0');
    put(bytes, std::uint32_t{12});
    for (const auto& facet : cube_facets()) {
        bytes += std::string(12, '\0');
        for (const auto& p : facet)
            for (const int c : p)
                put(bytes, static_cast<float>(c));
        bytes += std::string(2, '\7');
    }
    return bytes;
}

std::string upper_case(std::string text) {
    for (char& c : text)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

TEST(Stl, TextCube) {
    const ImportedMesh mesh = read_one(read_stl, text_cube());
    expect_unit_cube(mesh);
    EXPECT_EQ(mesh.name, "box");
    EXPECT_FALSE(mesh.are_floats);
}

TEST(Stl, BinaryCube) {
    const ImportedMesh mesh = read_one(read_stl, binary_cube());
    expect_unit_cube(mesh);
    EXPECT_EQ(mesh.name, "model");
    EXPECT_TRUE(mesh.are_floats);
}

TEST(Stl, TextIsToldByMoreThanItsFirstWord) {
    for (const std::string& file : {upper_case(text_cube()),
                                    "solid x" + upper_case(text_cube()).substr(9),
                                    "\n \r\n" + text_cube(),
                                    replaced(text_cube(), "\n", "\r\n"),
                                    replaced(text_cube(), "\n", "\r"),
                                    replaced(text_cube(), "solid box", "solid"),
                                    replaced(text_cube(), "  ", "\t"),
                                    replaced(text_cube(), "loop\n", "loop "),
                                    text_cube() + "\n\x1a",
                                    text_cube() + std::string(8, '\0')})
        expect_unit_cube(read_stl, file);
}

TEST(Stl, BinaryMayBeginWithSolidAndEndWithMore) {
    for (const std::string& file : {binary_cube("solid but binary"),
                                    binary_cube("solid facet normal"),
                                    binary_cube() + "ten bytes.",
                                    binary_cube("solid") + "more"})
        expect_unit_cube(read_stl, file);
}

TEST(Stl, SolidsOfAFileAreOneObject) {
    const ImportedMesh two =
        read_one(read_stl, text_cube("a") + "solid none\nendsolid none\n" + text_cube("b"));
    EXPECT_EQ(two.triangles.size(), 24U);
    EXPECT_EQ(two.name, "model") << "neither's";
    const ImportedMesh one = read_one(read_stl, "solid none\nendsolid\n" + text_cube("b c"));
    expect_unit_cube(one);
    EXPECT_EQ(one.name, "b c");
}

TEST(Stl, NormalsOfFacetsAreTheirCorners) {
    const ImportedMesh mesh =
        read_one(read_stl, replaced(text_cube(), "normal 0 0 0", "normal 0 -1e-1 1"));
    ASSERT_EQ(mesh.normals.size(), 36U);
    EXPECT_EQ(mesh.normals[35], glm::vec3(0, -0.1F, 1));
    // As Windows writes numbers that are none.
    const ImportedMesh bad =
        read_one(read_stl, replaced(text_cube(), "normal 0 0 0", "normal 1.#QNAN -nan(ind) 0"));
    EXPECT_FALSE(glm::length(bad.normals.at(0)) > 0);
    expect_unit_cube(bad);
}

TEST(Stl, DigitsAreKept) {
    const ImportedMesh mesh =
        read_one(read_stl, replaced(text_cube(), "vertex 1", "vertex 5000000.1"));
    EXPECT_EQ(mesh.positions[7].x, mesh.positions[7].x);
    EXPECT_NE(std::find(mesh.positions.begin(), mesh.positions.end(), glm::dvec3(5000000.1, 0, 0)),
              mesh.positions.end());
}

TEST(Stl, FaultsAreNamedWithTheirPlace) {
    expect_faults(
        read_stl,
        text_cube(),
        {{"vertex 1 1 1", "vertex 1 1 one", "a vertex's coordinate is \"one\" (a number)"},
         {"vertex 1 1 1", "vertex 1 1", "a vertex's coordinate is missing"},
         {"    endloop",
          "vertex 0 0 0\n    endloop",
          "line 7: \"vertex\" stands where \"endloop\" belongs"},
         {"endsolid box", "", "cut short: its end mark is missing"},
         {"endsolid box", "endsolid box\nsold", "\"sold\" stands outside of a solid"}});
    EXPECT_THAT(fault(read_stl, "solid a\nfacet normal 0 0 0\nouter"),
                HasSubstr("cut short: it ends inside a solid"));
    EXPECT_THAT(fault(read_stl, "shape of a cube, made by hand\n"),
                HasSubstr("line 1: \"shape\" stands outside of a solid (solid)"));
    EXPECT_THAT(fault(read_stl, binary_cube().substr(0, 500)),
                HasSubstr("its header promises 684 bytes, it has 500"));
    EXPECT_THAT(fault(read_stl, std::string(50, '\0')), HasSubstr("nor long enough for binary"));
}

}  // namespace
}  // namespace ink::import
