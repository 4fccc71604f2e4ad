#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/program/run_program.h"

// `inkbench bake`, as a user runs it.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using Json = nlohmann::json;

/// A .gltf that is a tetrahedron, its numbers in itself.
std::string tetrahedron() {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3",)"
           R"("min":[0,0,0],"max":[1,1,1]},)"
           R"({"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":48},)"
           R"({"buffer":0,"byteOffset":48,"byteLength":12}],)"
           R"("buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,)"
           "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"
           R"(AAIBAAEDAAMCAQID"}]})";
}

TEST(BakeProgram, WritesAFileAndSaysWhatWasDone) {
    const Desk desk;
    desk.write("a.gltf", tetrahedron());
    const std::string said = expect_done(desk, "bake a.gltf -o b.gltf --edges --codes surface8");
    EXPECT_THAT(said, HasSubstr("codes of surface8 on 4 triangles: "));
    EXPECT_THAT(said, HasSubstr("edges: 6 hard ones and 0 that may be silhouettes\n"));
    EXPECT_THAT(said, HasSubstr("b.gltf: "));
    const Json baked = Json::parse(desk.read("b.gltf"));
    EXPECT_EQ(baked["extensionsUsed"], Json({"EXT_mesh_primitive_edge_visibility"}));
    EXPECT_TRUE(baked["meshes"][0]["primitives"][0]["attributes"].contains("_INK"));

    EXPECT_THAT(expect_done(desk, "bake b.gltf -o c.gltf --edges --codes surface8"),
                HasSubstr("nothing is changed"));
    EXPECT_EQ(desk.read("c.gltf"), desk.read("b.gltf"));
    // In place, too.
    expect_done(desk, "bake a.gltf -o a.gltf --edges --codes surface8");
    EXPECT_EQ(desk.read("a.gltf"), desk.read("b.gltf"));
}

/// The same, which flies off in two seconds.
Json flying() {
    Json moving = Json::parse(tetrahedron());
    const std::string data = "data:application/octet-stream;base64,";
    moving.merge_patch(Json::parse(R"({"animations":[{"name":"fly",
        "samplers":[{"input":2,"output":3}],
        "channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]}]})"));
    moving["buffers"].push_back({{"byteLength", 8}, {"uri", data + "AAAAAAAAAEA="}});
    moving["buffers"].push_back(
        {{"byteLength", 24}, {"uri", data + "AAAAAAAAAAAAAAAAAAAAQAAAAEAAAABA"}});
    moving["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 8}});
    moving["bufferViews"].push_back({{"buffer", 2}, {"byteLength", 24}});
    Json accessor = {{"bufferView", 3}, {"componentType", 5126}, {"count", 2}, {"type", "VEC3"}};
    Json times = accessor;
    times.update({{"bufferView", 2}, {"type", "SCALAR"}, {"min", {0}}, {"max", {2}}});
    moving["accessors"].push_back(times);
    moving["accessors"].push_back(accessor);
    return moving;
}

TEST(BakeProgram, SaysOfWhichPoseItIs) {
    const Desk desk;
    desk.write("a.gltf", flying().dump());
    const auto pose = [&](const std::string& options) {
        const std::string said = expect_done(desk, "bake a.gltf -o b.gltf" + options);
        const Json mark = Json::parse(desk.read("b.gltf"))["asset"]["extras"]["inkbench"];
        EXPECT_THAT(said, HasSubstr("is of its pose " + mark["pose"].get<std::string>() + "\n"));
        return mark["pose"].get<std::string>();
    };
    EXPECT_EQ(pose(""), "at rest");
    EXPECT_EQ(pose(" --time 1.5 --animation fly"), "at 1.5 s");
    expect_refused(desk, "bake a.gltf -o b.gltf --time 3", {"--time", "at 3 s", "0..2"});
    desk.write("still.gltf", tetrahedron());
    expect_refused(desk, "bake still.gltf -o b.gltf --time 1", {"--time", "does not move"});
}

TEST(BakeProgram, CodesOfAnAnimationSaySo) {
    const Desk desk;
    desk.write("a.gltf", flying().dump());
    const auto baked = [&](const std::string& from, const std::string& options) {
        expect_done(desk, "bake " + from + " -o b.gltf" + options);
        return desk.read("b.gltf");
    };
    const auto animation = [](const std::string& bytes) {
        const Json codes = Json::parse(bytes)["asset"]["extras"]["inkbench"]["codes"];
        return codes.value("animation", "");
    };
    const std::string fly = baked("a.gltf", " --animation fly");
    EXPECT_EQ(animation(fly), "fly");
    EXPECT_EQ(baked("a.gltf", " --animation fly"), fly);
    EXPECT_EQ(animation(baked("a.gltf", " --animation all")), "all");
    EXPECT_EQ(animation(baked("a.gltf", "")), "");
    EXPECT_EQ(baked("a.gltf", " --time 1 --animation fly"), baked("a.gltf", " --time 1"));
    EXPECT_EQ(baked("a.gltf", " --codes label8 --animation fly"),
              baked("a.gltf", " --codes label8"));

    const std::string repaired = baked("a.gltf", " --repair");
    EXPECT_EQ(baked("a.gltf", " --repair"), repaired);
    EXPECT_EQ(Json::parse(repaired)["asset"]["extras"]["inkbench"]["codes"]["repaired"], true);
    EXPECT_EQ(animation(repaired), "");
    expect_refused(desk, "bake a.gltf -o b.gltf --repair --edges", {"--repair", "surface8"});

    // Edges are added, but codes of an animation are not made anew without it.
    desk.write("fly.gltf", fly);
    EXPECT_EQ(animation(baked("fly.gltf", " --edges")), "fly");
    Json older = Json::parse(fly);
    older["asset"]["extras"]["inkbench"]["version"] = "0";
    desk.write("older.gltf", older.dump());
    expect_refused(desk,
                   "bake older.gltf -o b.gltf --edges",
                   {"of an animation", "--codes surface8 --animation NAME"});
    expect_refused(desk, "bake a.gltf -o b.gltf --animation run", {"run", "fly"});
    desk.write("still.gltf", tetrahedron());
    expect_refused(desk, "bake still.gltf -o b.gltf --animation all", {"--animation", "moves"});
}

TEST(BakeProgram, OtherFormatsBecomeGltfWithNamesAndBaseColours) {
    const Desk desk;
    desk.write("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl glass\nKd 0 0.5 1\nd 0.5\n");
    desk.write("a.obj",
               "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no lid\nusemtl red\nf 1 3 2\n"
               "f 1 2 4\nusemtl glass\nf 2 3 4\no base\nf 1 4 3\n");
    EXPECT_THAT(expect_done(desk, "bake a.obj -o b.gltf"),
                HasSubstr("geometry, normals, names and base colours\n"));
    const Json baked = Json::parse(desk.read("b.gltf"));
    EXPECT_EQ(baked["nodes"][0]["name"], "lid");
    EXPECT_EQ(baked["nodes"][1]["name"], "base");
    const auto color = [&](int i) { return baked["materials"][i]["pbrMetallicRoughness"]; };
    EXPECT_EQ(color(0)["baseColorFactor"], Json({1.0, 0.0, 0.0, 1.0}));
    EXPECT_EQ(color(1)["baseColorFactor"], Json({0.0, 0.5, 1.0, 0.5}));
    EXPECT_EQ(baked["materials"][1]["alphaMode"], "BLEND");
    for (const Json& mesh : baked["meshes"])
        EXPECT_TRUE(mesh["primitives"][0]["attributes"].contains("NORMAL"));
}

TEST(BakeProgram, CodesAreTheDefaultUnlessEdgesAreAskedFor) {
    const Desk desk;
    desk.write("a.gltf", tetrahedron());
    const auto attributes = [&](const std::string& options) {
        expect_done(desk, "bake a.gltf -o b.gltf" + options);
        return Json::parse(desk.read("b.gltf"))["meshes"][0]["primitives"][0]["attributes"];
    };
    EXPECT_TRUE(attributes("").contains("_INK"));
    EXPECT_FALSE(attributes(" --edges").contains("_INK"));
    EXPECT_TRUE(attributes(" --edges --channel texcoord1").contains("TEXCOORD_1"));
}

TEST(BakeProgram, WritesTablesOfTheLookupBesideAModel) {
    const Desk desk;
    desk.write("a.gltf", tetrahedron());
    desk.write("cube.obj", kCubeObj);
    EXPECT_THAT(expect_done(desk, "bake a.gltf --codes surface_lookup -o a.lookup"),
                StartsWith("a.lookup: tables of 4 triangles, "));
    EXPECT_EQ(desk.read("a.lookup").size(), 4 * (3 + 8 * 4 + 2 + 2 * 4));
    EXPECT_EQ(desk.read("a.gltf"), tetrahedron());
    const std::string end = " --codes surface_lookup -o b.lookup";
    expect_refused(desk, "bake a.gltf --edges" + end, {"--codes", "--edges"});
    expect_refused(desk, "bake a.gltf --repair" + end, {"--codes", "--repair"});
    expect_refused(desk, "bake cube.obj" + end, {"cube.obj", "is no glTF file", ".glb"});
    expect_refused(desk, "bake a.gltf --codes surface_lookup -o b.glb", {"b.glb", ".lookup"});
}

TEST(BakeProgram, MakesGltfOfOtherFormats) {
    const Desk desk;
    desk.write("cube.obj", kCubeObj);
    const std::string said = expect_done(desk, "bake cube.obj -o cube.glb");
    EXPECT_THAT(said, StartsWith("it became glTF: "));
    EXPECT_THAT(said, HasSubstr("codes of surface8 on 12 triangles"));
    EXPECT_THAT(expect_done(desk, "bake cube.glb -o again.glb"), HasSubstr("nothing is changed"));
    EXPECT_EQ(desk.inventory().size(), 3U);
}

TEST(BakeProgram, AModelOfAnotherFormatKeepsItsTextureCoordinates) {
    const Desk desk;
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.125 0.25\nvt 0.5 0.625\nvt 0.75 0\nf 1/1 2/2 3/3\n";
    desk.write("a.obj", text);
    const std::string numbers = [] {  // v runs down in glTF
        const float uv[] = {0.125F, 0.75F, 0.5F, 0.375F, 0.75F, 1};
        return std::string(reinterpret_cast<const char*>(uv), sizeof uv);
    }();
    for (const std::string options : {"", " --channel texcoord1"}) {
        EXPECT_THAT(expect_done(desk, "bake a.obj -o a.glb" + options),
                    StartsWith("it became glTF: geometry, normals, texture coordinates, names"));
        EXPECT_THAT(desk.read("a.glb"), AllOf(HasSubstr("TEXCOORD_0"), HasSubstr(numbers)));
    }
    desk.write("b.obj", text + "f 1/5 2/1 3/1\n");
    expect_refused(desk,
                   "bake b.obj -o b.glb",
                   {"b.obj", "line 8: a corner has the texture coordinate 5", "1..3"});
    desk.write("c.obj", text + "vt 0 up\n");
    expect_refused(desk, "bake c.obj -o c.glb", {"c.obj", "line 8: a texture coordinate is"});
}

TEST(BakeProgram, ATextureCoordinateThatIsNoNumberIsZero) {
    const Desk desk;
    const auto baked = [&](const std::string& vt) {
        desk.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1 0\nvt " + vt + "\nf 1/1 2/1 3/2\n");
        expect_done(desk, "bake a.obj -o a.glb");
        return desk.read("a.glb");
    };
    EXPECT_EQ(baked("nan 0.5"), baked("0 1"));
    EXPECT_EQ(baked("1 1e999"), baked("0 1"));
    EXPECT_NE(baked("1 1"), baked("0 1"));
}

TEST(BakeProgram, RefusesWithOneLineAndLeavesNothing) {
    const Desk desk;
    Json whole = Json::parse(tetrahedron());
    desk.write("a.gltf", whole.dump());
    desk.write("empty.glb", "");
    desk.write("none.gltf", R"({"asset":{"version":"2.0"}})");
    whole["accessors"][1]["count"] = 99;
    desk.write("damaged.gltf", whole.dump());
    whole["accessors"][1]["count"] = 12;
    whole["accessors"][0]["count"] = 4000000000;
    desk.write("huge.gltf", whole.dump());
    expect_all_refused(desk,
                       {"bake"},
                       {{"empty.glb -o b.glb", {"empty.glb", "the file is empty"}},
                        {"none.gltf -o b.glb", {"none.gltf", "no triangle"}},
                        {"damaged.gltf -o b.glb", {"damaged.gltf", "accessor 1", "0..12"}},
                        {"huge.gltf -o b.glb", {"huge.gltf", "accessor 0", "4000000000"}},
                        {"missing.glb -o b.glb", {"missing.glb", "no such file"}},
                        {"a.gltf -o b.obj", {"b.obj", ".glb", ".gltf"}},
                        {"a.gltf -o no/b.glb", {"no/b.glb"}},
                        {"a.gltf", {"--out"}},
                        {"a.gltf -o b.glb --codes ids", {"--codes", "ids", "surface8 | label8"}},
                        {"a.gltf -o b.glb --channel uv2", {"--channel", "texcoord1"}},
                        {"a.gltf -o b.glb --crease-deg 200", {"--crease-deg", "200", "0..180"}}});
}

}  // namespace
}  // namespace ink::program
