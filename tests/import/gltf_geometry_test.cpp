// What glTF 2.0 makes of numbers: component types, modes, sparse accessors, nodes, copies, names.

#include <gmock/gmock.h>

#include "scene/topology.h"
#include "tests/import/glb_files.h"
#include "tests/import/model_files.h"
#include "tests/import/solids.h"
#include "tests/scene/edge_counts.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using GltfGeometry = ModelFiles;

/// A cube whose positions are integers, under a node that scales.
template <class T>
GlbFile quantised_cube(int size, const Json& more, double scale) {
    GlbFile file;
    const std::size_t positions = file.accessor(cube_corners<T>(size), "VEC3", more);
    file.put("meshes", {{"primitives", {cube_primitive(file, positions)}}});
    file.put("nodes", {{"mesh", 0}, {"scale", {scale, scale, scale}}});
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    return file;
}

TEST_F(GltfGeometry, IntegersArePositions) {
    const auto check = [&](const GlbFile& file) {
        expect_box(solid_of(import_scene(write("q.glb", file.bytes()))), {0, 0, 0}, {2, 2, 2});
    };
    check(quantised_cube<std::int8_t>(127, kUnits, 2));
    check(quantised_cube<std::uint8_t>(255, kUnits, 2));
    check(quantised_cube<std::int16_t>(32767, kUnits, 2));
    check(quantised_cube<std::uint16_t>(65535, kUnits, 2));
    check(quantised_cube<std::int8_t>(100, Json::object(), 0.02));
    check(quantised_cube<std::uint16_t>(50000, Json::object(), 0.00004));
}

TEST_F(GltfGeometry, RowsMayLieApart) {
    GlbFile file = quantised_cube<std::int8_t>(127, kUnits, 1);
    std::string rows;
    for (int v = 0; v < 8; ++v)
        rows += std::string(file.data.begin() + 3 * v, file.data.begin() + 3 * v + 3) + '?';
    const std::size_t view = file.view(rows.substr(0, rows.size() - 1));
    file.json["bufferViews"][view]["byteStride"] = 4;
    file.json["accessors"][0]["bufferView"] = view;
    expect_box(solid_of(import_scene(write("q.glb", file.bytes()))), {0, 0, 0}, {1, 1, 1});
}

TEST_F(GltfGeometry, SparseValuesReplaceTheBaseOrZeros) {
    for (const bool has_base : {true, false}) {
        GlbFile file = cube_file();
        const std::size_t places = file.accessor<std::uint8_t>({1, 7}, "SCALAR");
        const std::size_t values = file.accessor<float>({5, 0, 0, 1, 6, 1}, "VEC3");
        Json& accessor = file.json["accessors"][0];
        accessor["sparse"] = {
            {"count", 2},
            {"indices",
             {{"bufferView", file.json["accessors"][places]["bufferView"]},
              {"componentType", 5121}}},
            {"values", {{"bufferView", file.json["accessors"][values]["bufferView"]}}}};
        if (!has_base) accessor.erase("bufferView");
        file.put("nodes", {{"mesh", 0}});
        const scene::Scene scene = import_scene(write("sparse.glb", file.bytes()));
        EXPECT_EQ(scene.meshes.at(0).positions.at(1), glm::vec3(5, 0, 0));
        EXPECT_EQ(scene.meshes[0].positions.at(7), glm::vec3(1, 6, 1));
        EXPECT_EQ(scene.meshes[0].positions.at(6), has_base ? glm::vec3(0, 1, 1) : glm::vec3(0));
    }
}

TEST_F(GltfGeometry, StripsAndFansKeepTheirFronts) {
    GlbFile file = cube_file();
    file.put("nodes", {{"mesh", 0}});
    Json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive.erase("indices");
    primitive["mode"] = 5;
    scene::Scene scene = import_scene(write("strip.glb", file.bytes()));
    EXPECT_THAT(scene.meshes.at(0).triangles,
                ElementsAre(scene::Triangle{0, 1, 2},
                            scene::Triangle{1, 3, 2},
                            scene::Triangle{2, 3, 4},
                            scene::Triangle{3, 5, 4},
                            scene::Triangle{4, 5, 6},
                            scene::Triangle{5, 7, 6}));
    primitive["mode"] = 6;
    scene = import_scene(write("fan.glb", file.bytes()));
    EXPECT_EQ(scene.meshes.at(0).triangles.front(), (scene::Triangle{1, 2, 0}));
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 6U);
    primitive["mode"] = 4;
    scene = import_scene(write("list.glb", file.bytes()));
    EXPECT_THAT(scene.meshes.at(0).triangles,
                ElementsAre(scene::Triangle{0, 1, 2}, scene::Triangle{3, 4, 5}))
        << "two corners are left over";
}

TEST_F(GltfGeometry, PartsWithoutATriangleAreLeftOutWithANote) {
    GlbFile file = cube_file();
    file.put("nodes", {{"mesh", 0}});
    Json& primitives = file.json["meshes"][0]["primitives"];
    const std::size_t two = file.accessor<float>({0, 0, 0, 9, 9, 9}, "VEC3");
    primitives.push_back({{"attributes", {{"POSITION", two}}}});
    primitives.push_back({{"attributes", Json::object()}});
    primitives.push_back({{"attributes", {{"POSITION", two}}}, {"mode", 1}});
    const scene::Scene scene = import_scene(write("parts.glb", file.bytes()));
    EXPECT_EQ(scene::triangle_count(scene), 12U);
    EXPECT_THAT(scene.file.notes,
                ElementsAre("1 part of points or lines left out", "2 parts without a triangle"));
}

TEST_F(GltfGeometry, PrimitivesOfOneNodeAreOneObject) {
    GlbFile file = cube_file();
    file.json["materials"] = {{{"alphaMode", "BLEND"}}, {{"name", "plain"}}};
    Json& primitives = file.json["meshes"][0]["primitives"];
    primitives[0]["material"] = 1;
    const std::size_t more = file.accessor(cube_corners<float>(3), "VEC3");
    primitives.push_back(cube_primitive(file, more));
    primitives.push_back(cube_primitive(file, more));
    primitives[1]["material"] = 0;
    file.put("nodes", {{"mesh", 0}});
    const scene::Scene scene = import_scene(write("two.glb", file.bytes()));
    ASSERT_EQ(scene.instances.size(), 1U);
    const scene::Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 16U) << "two parts share their vertices";
    ASSERT_EQ(mesh.materials.size(), 36U);
    EXPECT_EQ(mesh.materials[11], 1U);
    EXPECT_EQ(mesh.materials[12], 0U);
    EXPECT_EQ(mesh.materials[35], 2U) << "of no material";
    EXPECT_THAT(scene.file.notes, ElementsAre("1 material of BLEND drawn opaque"));
}

TEST_F(GltfGeometry, ASphereInTwoPrimitivesHasNoSeam) {
    GlbFile file = cube_file();
    Json& primitives = file.json["meshes"][0]["primitives"];
    const std::vector<std::uint16_t> half(kCubeIndices.begin(), kCubeIndices.begin() + 18);
    const std::vector<std::uint16_t> rest(kCubeIndices.begin() + 18, kCubeIndices.end());
    primitives[0]["indices"] = file.accessor(half, "SCALAR");
    primitives.push_back(
        {{"attributes", {{"POSITION", file.accessor(cube_corners<float>(), "VEC3")}}},
         {"indices", file.accessor(rest, "SCALAR")}});
    file.put("nodes", {{"mesh", 0}});
    const scene::Scene scene = import_scene(write("halves.glb", file.bytes()));
    const scene::Topology topology = scene::weld(scene);
    EXPECT_EQ(topology.p_world.size(), 8U);
    EXPECT_EQ(topology.edges.size(), 18U);
    EXPECT_EQ(scene::edge_counts(topology).boundary, 0U);
    for (const scene::Face& face : topology.faces)
        EXPECT_EQ(face.object, 0U);
}

TEST_F(GltfGeometry, NodesUseOneMeshAndAreThemselvesByNumber) {
    GlbFile file = cube_file();
    file.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
    file.put("nodes", {{"mesh", 0}, {"name", "same"}});
    file.put("nodes", {{"mesh", 0}, {"name", "same"}, {"translation", {5, 4, 0}}});
    file.put("nodes", {{"mesh", 0}, {"translation", {0.1, 0, 0}}});
    const scene::Scene scene = import_scene(write("same.glb", file.bytes()));
    EXPECT_EQ(scene.meshes.size(), 1U);
    ASSERT_EQ(scene.instances.size(), 3U);
    EXPECT_EQ(scene.instances[1].world_from_object[3], glm::dvec4(5, 4, 0, 1));
    EXPECT_EQ(scene.instances[2].name, "node 2");
    EXPECT_EQ(scene.instances[2].world_from_object[3].x, 0.1) << "as a double";
}

TEST_F(GltfGeometry, NamesAreUtf8) {
    GlbFile file = cube_file();
    file.json["scenes"] = {{{"nodes", {0, 1}}}};
    file.put("nodes", {{"mesh", 0}, {"name", "Gr\u00f6\u00dfe"}});
    file.put("nodes", {{"mesh", 0}, {"name", "\u5e73\u9762"}, {"translation", {3, 0, 0}}});
    const scene::Scene scene = import_scene(write("uni.glb", file.bytes()));
    expect_box(solid_of(scene, "Gr\u00f6\u00dfe"), {0, 0, 0}, {1, 1, 1});
    expect_box(solid_of(scene, "\u5e73\u9762"), {3, 0, 0}, {4, 1, 1});
}

TEST_F(GltfGeometry, NodesThatStandFarOutKeepTheirDistance) {
    GlbFile file = cube_file();
    file.json["scenes"] = {{{"nodes", {0, 1}}}};
    file.put("nodes", {{"mesh", 0}, {"name", "a"}, {"translation", {4e6, 0, 5e6}}});
    file.put("nodes", {{"mesh", 0}, {"name", "b"}, {"translation", {4e6 + 1.3125, 0, 5e6}}});
    const scene::Scene scene = import_scene(write("utm.glb", file.bytes()));
    EXPECT_EQ(solid_of(scene, "b").low.x - solid_of(scene, "a").low.x, 1.3125);
}

TEST_F(GltfGeometry, InstancingPlacesCopies) {
    GlbFile file = cube_file();
    const std::size_t places = file.accessor<float>({0, 0, 0, 3, 0, 0, 6, 0, 0, 9, 0, 0}, "VEC3");
    file.put("nodes",
             {{"mesh", 0},
              {"name", "row"},
              {"translation", {0, 1, 0}},
              {"extensions",
               {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}}}}});
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const scene::Scene scene = import_scene(write("row.glb", file.bytes()));
    ASSERT_EQ(scene.instances.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(scene.instances[i].name, "row");
        EXPECT_EQ(scene.instances[i].world_from_object[3],
                  glm::dvec4(3 * static_cast<double>(i), 1, 0, 1));
    }
}

TEST_F(GltfGeometry, HiddenNodesHideWhatHangsOnThem) {
    GlbFile file = cube_file();
    file.json["scenes"] = {{{"nodes", {0, 2}}}};
    file.put("nodes",
             {{"children", {1}},
              {"mesh", 0},
              {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
    file.put("nodes", {{"mesh", 0}});
    file.put("nodes", {{"mesh", 0}, {"name", "shown"}});
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_node_visibility"};
    const scene::Scene scene = import_scene(write("hidden.glb", file.bytes()));
    ASSERT_EQ(scene.instances.size(), 1U);
    EXPECT_EQ(scene.instances[0].name, "shown");
}

TEST_F(GltfGeometry, OnlyTheSceneIsShown) {
    GlbFile file = cube_file();
    file.json["scenes"] = {{{"nodes", {0}}}, {{"name", "other"}, {"nodes", {1}}}};
    file.put("nodes", {{"mesh", 0}});
    file.put("nodes", {{"mesh", 0}, {"name", "b"}});
    const auto names = [&] {
        const scene::Scene scene = import_scene(write("scenes.glb", file.bytes()));
        std::vector<std::string> all;
        for (const scene::Instance& instance : scene.instances)
            all.push_back(instance.name);
        return all;
    };
    EXPECT_THAT(names(), ElementsAre("node 0"));
    file.json["scene"] = 1;
    EXPECT_THAT(names(), ElementsAre("b"));
    file.json.erase("scene");
    file.json.erase("scenes");
    EXPECT_THAT(names(), ElementsAre("node 0", "b")) << "without a scene all that is there";
}

TEST_F(GltfGeometry, CamerasAreNodes) {
    GlbFile file = cube_file();
    file.json["scenes"] = {{{"nodes", {0, 1, 2, 3, 4}}}};
    file.put("nodes", {{"mesh", 0}});
    for (const char* name : {"A", "B"})
        file.put("nodes",
                 {{"camera", 0}, {"name", name}, {"translation", {0, 0, name[0] == 'A' ? 5 : 9}}});
    file.put("nodes", {{"camera", 1}, {"name", "flat"}, {"translation", {0, 0, 5}}});
    file.put("nodes", {{"camera", 0}, {"translation", {0, 2, 5}}});
    file.json["cameras"] = {
        {{"type", "perspective"},
         {"name", "lens"},
         {"perspective", {{"yfov", 0.7}, {"aspectRatio", 2}, {"znear", 0.1}}}},
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 2}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}}};
    const scene::Scene scene = import_scene(write("cameras.glb", file.bytes()));
    ASSERT_EQ(scene.cameras.size(), 4U);
    EXPECT_EQ(scene.cameras[0].name, "A");
    EXPECT_EQ(scene.cameras[1].name, "B");
    EXPECT_EQ(scene.cameras[2].name, "flat");
    EXPECT_EQ(scene.cameras[3].name, "lens");
    EXPECT_EQ(scene.cameras[1].eye_world, glm::dvec3(0, 0, 9));
    EXPECT_EQ(scene.cameras[1].fov_y_rad, 0.7);
    EXPECT_FALSE(scene.cameras[1].is_parallel());
    EXPECT_EQ(scene.cameras[2].height_world, 2) << "ymag is half of it";
}

TEST_F(GltfGeometry, BuffersBesideTheFileAreFoundByTheirDecodedName) {
    GlbFile file = cube_file();
    file.put("nodes", {{"mesh", 0}});
    const auto gltf = [&](const std::string& uri) {
        Json json = file.json;
        json["buffers"] = {{{"byteLength", file.data.size()}, {"uri", uri}}};
        return write("model.gltf", json.dump());
    };
    (void)write("a b.bin", file.data);
    (void)write("Gr\u00f6\u00dfe.bin", file.data);
    for (const char* uri :
         {"a%20b.bin", "a b.bin", "./a%20b.bin", "Gr%C3%B6%c3%9fe.bin", "Gr\u00f6\u00dfe.bin"})
        expect_box(solid_of(import_scene(gltf(uri))), {0, 0, 0}, {1, 1, 1});
    EXPECT_EQ(
        complaint(gltf("../a%20b.bin")),
        "buffer 0: the URI ../a%20b.bin leaves the model's folder (accepted: a path below the "
        "model's folder)");
    EXPECT_THAT(complaint(gltf("%2e%2e/a%20b.bin")), HasSubstr("leaves the model's folder"));
    EXPECT_THAT(complaint(gltf("/etc/passwd")), HasSubstr("leaves the model's folder"));
    EXPECT_THAT(complaint(gltf("https://example.com/a.bin")), HasSubstr("is not opened"));
    EXPECT_THAT(complaint(gltf("a%00b.bin")), HasSubstr("an escape that is none"));
    EXPECT_THAT(complaint(gltf("absent.bin")), HasSubstr("the file absent.bin cannot be read"));
}

/// The cube's twelve triangles with these numbers, two bits each, for their sides.
GlbFile cube_with_edges(const std::vector<std::uint8_t>& visibility) {
    GlbFile file = cube_file();
    const std::size_t accessor = file.accessor(visibility, "SCALAR");
    file.put("nodes", {{"mesh", 0}});
    file.json["extensionsUsed"] = {"EXT_mesh_primitive_edge_visibility"};
    file.json["meshes"][0]["primitives"][0]["extensions"] = {
        {"EXT_mesh_primitive_edge_visibility", {{"visibility", accessor}}}};
    return file;
}

TEST_F(GltfGeometry, HardEdgesAreMarkedSides) {
    // Sides 0, 1 and 2 of triangle 0 are hidden, a silhouette and hard, side 0 of triangle 1 is
    // hard and named before.
    const GlbFile file = cube_with_edges({0b11'10'01'00, 0, 0, 0, 0, 0, 0, 0, 0b10'00'00'00});
    const scene::Scene scene = import_scene(write("edges.glb", file.bytes()));
    EXPECT_THAT(scene.meshes[0].marked_sides,
                ElementsAre(0b100, 0b001, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0b100));
    EXPECT_TRUE(scene.file.notes.empty());
}

TEST_F(GltfGeometry, PrimitivesWithoutEdgesMarkNone) {
    GlbFile file = cube_with_edges(std::vector<std::uint8_t>(9, 0xff));
    Json& primitives = file.json["meshes"][0]["primitives"];
    Json plain = primitives[0];
    plain.erase("extensions");
    primitives = {plain, primitives[0], plain};
    const scene::Scene scene = import_scene(write("edges.glb", file.bytes()));
    std::vector<std::uint8_t> expected(36, 0);
    std::fill(expected.begin() + 12, expected.begin() + 24, 0b111);
    EXPECT_EQ(scene.meshes[0].marked_sides, expected);
}

TEST_F(GltfGeometry, EdgesForAnotherNumberOfTrianglesAreRefused) {
    const GlbFile file = cube_with_edges(std::vector<std::uint8_t>(8, 0));
    EXPECT_THAT(complaint(write("edges.glb", file.bytes())),
                HasSubstr("visibility has 8 elements (accepted: 9, for 36 sides"));
}

}  // namespace
}  // namespace ink::import
