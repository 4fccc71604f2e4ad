#include "bake/bake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "import/model_bytes.h"
#include "scene/animation.h"
#include "tests/bake/baked_files.h"
#include "tests/import/packed_files.h"

namespace ink::bake {
namespace {

using import::cube_file;
using import::GlbFile;
using import::Json;
using methods::BakedMethod;
using testing::Contains;
using testing::HasSubstr;

constexpr BakeOptions kSurface{.codes = BakedMethod::surface8};
constexpr BakeOptions kAll{.codes = BakedMethod::surface8, .texcoord = 2, .edges = true};

/// The codes that the method has of the file's scene at its default settings.
std::vector<std::uint32_t> codes_of(const std::filesystem::path& path, BakedMethod method) {
    const scene::Scene scene = import::import_scene(path);
    return methods::baked_codes(scene, method, 40);
}

GlbFile one_cube() {
    GlbFile file = cube_file();
    file.put("nodes", {{"mesh", 0}});
    return file;
}

/// A cube with all that a vertex may have, in a file with all that must not be lost.
GlbFile rich_cube() {
    GlbFile file;
    const auto many = [](std::size_t count) {
        std::vector<std::uint8_t> numbers(count);
        std::iota(numbers.begin(), numbers.end(), std::uint8_t{3});
        return numbers;
    };
    const std::size_t positions = file.accessor(import::cube_corners<float>(), "VEC3");
    const std::size_t moved = file.accessor(import::cube_corners<float>(3), "VEC3");
    const std::vector<std::uint8_t> u8 = many(32);
    const std::vector<std::uint16_t> u16(u8.begin(), u8.begin() + 8);
    std::vector<float> weights;
    std::vector<std::uint8_t> joints;
    for (int v = 0; v < 8; ++v) {
        weights.insert(weights.end(), {0.25F, 0.75F, 0, 0});
        joints.insert(joints.end(), {0, 1, 0, 0});
    }
    // Sparse, without a base.
    const std::size_t places = file.view({1, 6});
    const std::size_t values = file.view(std::string(8, 'x'));
    const std::size_t sparse =
        file.put("accessors",
                 {{"componentType", 5126},
                  {"count", 8},
                  {"type", "SCALAR"},
                  {"sparse",
                   {{"count", 2},
                    {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                    {"values", {{"bufferView", values}}}}}});
    const Json attributes = {{"POSITION", positions},
                             {"COLOR_0", file.accessor(u8, "VEC4", import::kUnits)},
                             {"_FEATURE", file.accessor(u16, "SCALAR")},
                             {"_SPARSE", sparse},
                             {"JOINTS_0", file.accessor(joints, "VEC4")},
                             {"WEIGHTS_0", file.accessor(weights, "VEC4")}};
    file.put("meshes",
             {{"name", "cube"},
              {"extras", {{"null", nullptr}, {"empty", Json::object()}}},
              {"primitives",
               {{{"attributes", attributes},
                 {"targets", {{{"POSITION", moved}}}},
                 {"indices", file.accessor(import::kCubeIndices, "SCALAR")},
                 {"extensions", {{"VENDOR_unknown", {{"big", 9007199254740993}}}}}}}},
              {"weights", {0.0}}});
    file.put("nodes", {{"mesh", 0}, {"skin", 0}});
    file.put("nodes", {{"name", "bone"}});
    file.put("nodes", {{"name", "bone"}});
    file.json["scenes"][0]["nodes"] = {0, 1, 2};
    file.put("skins", {{"joints", {1, 2}}, {"extras", 7}});
    import::animate(
        file, 1, "translation", file.accessor(std::vector<float>(6, 0.5F), "VEC3"), {0, 1});
    file.json["extensionsUsed"] = {"VENDOR_unknown"};
    file.json["extras"] = {{"large", 18446744073709551615U}, {"list", {1, nullptr, 0.1, "\u00e9"}}};
    file.json["asset"]["extras"] = {{"mine", true}};
    return file;
}

class Bake : public BakedFiles {
  protected:
    /// Bakes a file, and checks that it is the same model with the method's codes.
    BakedFile expect_baked(const GlbFile& file, const BakeOptions& options = kSurface) {
        const auto from = write("from.glb", file.bytes());
        BakedFile baked = bake_to(from, "to.glb", options);
        OpenFile before(from), after(in_folder("to.glb"));
        expect_same_corners(before, after, 0, 0);
        if (options.codes) expect_codes(after, 0, 0, codes_of(from, *options.codes));
        // Once more, and nothing is done.
        const BakedFile again = bake_to(in_folder("to.glb"), "again.glb", options);
        EXPECT_EQ(again.bytes, baked.bytes);
        EXPECT_TRUE(again.is_unchanged);
        return baked;
    }
    [[nodiscard]] Json json_of(const std::string& name) const {
        return *import::open_gltf(in_folder(name))->json;
    }
};

TEST_F(Bake, ACubeGetsSixVerticesMore) {
    const BakedFile baked = expect_baked(one_cube());
    EXPECT_EQ(baked.vertices, 8U);
    EXPECT_EQ(baked.added_vertices, 6U);
    EXPECT_THAT(baked.lines,
                Contains("codes of surface8 on 12 triangles: 6 vertices are added to 8 that there "
                         "were"));
}

TEST_F(Bake, LabelsAreThoseOfTheirMethod) {
    (void)expect_baked(one_cube(), {.codes = BakedMethod::label8});
}

TEST_F(Bake, AllThatWasInTheFileIsThereStill) {
    for (const BakeOptions& options : {kSurface, kAll, BakeOptions{.edges = true}}) {
        (void)expect_baked(rich_cube(), options);
        const Json before = json_of("from.glb"), after = json_of("to.glb");
        expect_additions_only(before, after);
        EXPECT_FALSE(after.contains("extensionsRequired"));
        EXPECT_EQ(after["asset"]["extras"]["inkbench"].contains("codes"),
                  options.codes.has_value());
        // The bytes are the old ones, and then more.
        const auto old_file = *import::open_gltf(in_folder("from.glb"));
        const auto new_file = *import::open_gltf(in_folder("to.glb"));
        ASSERT_GT(new_file.binary.size(), old_file.binary.size());
        EXPECT_TRUE(
            std::equal(old_file.binary.begin(), old_file.binary.end(), new_file.binary.begin()));
    }
}

/// A cube whose target draws out two of its corners: not at rest, in part at the first key.
GlbFile drawn_out_cube() {
    GlbFile file = one_cube();
    std::vector<float> more(24, 0);
    more[9] = 3;
    more[10] = 2;
    more[21] = 3;
    Json& mesh = file.json["meshes"][0];
    mesh["primitives"][0]["targets"] = {{{"POSITION", file.accessor(more, "VEC3")}}};
    mesh["weights"] = {0.0};
    const std::size_t weights = file.accessor(std::vector<float>{0.5F, 1}, "SCALAR");
    import::animate(file, 0, "weights", weights, {0, 2});
    return file;
}

TEST_F(Bake, CodesAreOfThePoseInWhichTheModelStandsAndTheFileSaysWhich) {
    const auto from = write("from.glb", drawn_out_cube().bytes());
    import::ImportedModel model = import::import_model(from);
    std::vector<std::vector<std::uint32_t>> codes;
    for (const std::string pose : {"at rest", "at 0 s", "at 2 s"}) {
        if (pose != "at rest") scene::pose_scene(model.scene, pose == "at 0 s" ? 0 : 2);
        BakeOptions options = kAll;
        options.pose = pose;
        const BakedFile baked = bake(from, model, options, in_folder("to.glb"));
        (void)write("to.glb", baked.bytes);
        EXPECT_THAT(baked.lines, Contains("it moves: what is put in is of its pose " + pose));
        EXPECT_EQ(json_of("to.glb")["asset"]["extras"]["inkbench"]["pose"], pose);
        scene::Scene still = model.scene;
        still.animation = nullptr;
        codes.push_back(methods::baked_codes(still, BakedMethod::surface8, 40));
        OpenFile file(in_folder("to.glb"));
        expect_codes(file, 0, 0, codes.back());
    }
    EXPECT_NE(codes[0], codes[1]);
    EXPECT_NE(codes[0], codes[2]);
}

TEST_F(Bake, AStillModelHasNoPoseToSay) {
    (void)bake_to(write("from.glb", one_cube().bytes()), "to.glb", kSurface);
    EXPECT_FALSE(json_of("to.glb")["asset"]["extras"]["inkbench"].contains("pose"));
}

TEST_F(Bake, VerticesThatAreWrittenAnewTakeThePlaceOfTheOld) {
    // No extension that may use bytes in its own way, and an image behind the vertices.
    GlbFile file = rich_cube();
    file.json.erase("extensionsUsed");
    file.json["meshes"][0]["primitives"][0].erase("extensions");
    const std::string picture(999, 'p');
    const std::size_t view = file.view(picture);
    file.put("images", {{"bufferView", view}, {"mimeType", "image/png"}});
    const BakedFile baked = expect_baked(file);
    const Json before = json_of("from.glb"), after = json_of("to.glb");
    // Accessors have their numbers still, and nothing but these changed.
    EXPECT_EQ(before["meshes"][0]["primitives"][0]["targets"],
              after["meshes"][0]["primitives"][0]["targets"]);
    EXPECT_EQ(after["accessors"].size(), before["accessors"].size() + 1);
    Json same = after;
    for (std::size_t a = 0; a < before["accessors"].size(); ++a)
        same["accessors"][a] = before["accessors"][a];
    expect_additions_only(before, same);
    const auto open = *import::open_gltf(in_folder("to.glb"));
    EXPECT_NE(import::text_of(open.binary).find(picture), std::string::npos);
    OpenFile old_file(in_folder("from.glb")), new_file(in_folder("to.glb"));
    for (const char* list : {"input", "output"}) {
        const std::size_t keys = before["animations"][0]["samplers"][0][list];
        EXPECT_EQ(old_file.accessors.components(keys), new_file.accessors.components(keys));
    }
}

TEST_F(Bake, NumbersOfJsonKeepTheirDigitsAndKeysTheirOrder) {
    GlbFile file = one_cube();
    const auto from = write("from.glb", file.bytes());
    std::string text = R"({"zebra":18446744073709551615,"asset":{"version":"2.0"},"b":-0.0,)" +
                       json_of("from.glb").dump().substr(1);
    text = text.substr(0, text.rfind("\"asset\"")) + "\"a2\"" +
           text.substr(text.rfind("\"asset\"") + 7);
    OpenFile open(from);
    const std::string binary(import::text_of(open.document.binary));
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto ordered =
        write("ordered.glb",
              GlbFile::word(0x46546c67) + GlbFile::word(2) +
                  GlbFile::word(28 + text.size() + binary.size()) + GlbFile::word(text.size()) +
                  "JSON" + text + GlbFile::word(binary.size()) + std::string("BIN\0", 4) + binary);
    (void)bake_to(ordered, "to.glb", kSurface);
    const std::string baked(import::text_of(import::open_gltf(in_folder("to.glb"))->text));
    EXPECT_THAT(baked,
                testing::StartsWith(R"({"zebra":18446744073709551615,"asset":{"version":"2.0")"));
    EXPECT_THAT(baked, HasSubstr(R"("b":-0.0)"));
}

TEST_F(Bake, AChannelHoldsCodesToTheBit) {
    (void)expect_baked(one_cube(), {.codes = BakedMethod::surface8, .texcoord = 2});
    OpenFile file(in_folder("to.glb"));
    import::GltfPrimitive primitive = file.primitive(0, 0);
    const std::vector<double> ink = primitive.components("_INK");
    for (const char* name : {"TEXCOORD_0", "TEXCOORD_1", "TEXCOORD_2"}) {
        const auto uv = primitive.numbers(name, {name, "VEC2", import::kUnsignedByte, true}, 2);
        for (std::size_t v = 0; v < ink.size(); ++v)
            EXPECT_EQ(std::lround(255 * static_cast<float>(uv[2 * v])), std::lround(ink[v]));
    }
}

TEST_F(Bake, AChannelThatIsTakenIsRefused) {
    GlbFile file = one_cube();
    const std::size_t uv = file.accessor(std::vector<float>(32, 0), "VEC4");
    file.json["accessors"][uv]["type"] = "VEC2";
    Json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_0"] = uv;
    attributes["TEXCOORD_1"] = uv;
    const auto from = write("from.glb", file.bytes());
    EXPECT_THAT(complaint_of(from, {.codes = BakedMethod::surface8, .texcoord = 1}),
                HasSubstr("from.glb: mesh 0, primitive 0: TEXCOORD_1 is taken (accepted: --channel "
                          "texcoord2"));
}

TEST_F(Bake, CodesOfAnotherProgramAreNotOverwritten) {
    GlbFile file = one_cube();
    file.json["meshes"][0]["primitives"][0]["attributes"]["_INK"] =
        file.accessor(std::vector<std::uint16_t>(8, 1), "SCALAR");
    EXPECT_THAT(complaint_of(write("from.glb", file.bytes()), kSurface),
                HasSubstr("mesh 0, primitive 0: it has an attribute _INK of its own"));
}

TEST_F(Bake, OtherCodesReplaceThoseOfBefore) {
    const auto from = write("from.glb", one_cube().bytes());
    (void)bake_to(from, "one.glb", kAll);
    (void)bake_to(in_folder("one.glb"), "two.glb", {.codes = BakedMethod::label8});
    OpenFile before(from), after(in_folder("two.glb"));
    expect_same_corners(before, after, 0, 0);
    expect_codes(after, 0, 0, codes_of(in_folder("one.glb"), BakedMethod::label8));
    EXPECT_FALSE(after.primitive(0, 0).has("TEXCOORD_0"));
    const Json mark = json_of("two.glb")["asset"]["extras"]["inkbench"];
    EXPECT_EQ(mark["codes"]["method"], "label8");
    EXPECT_TRUE(mark["edges"].is_object());  // which stay
}

TEST_F(Bake, StripsAndFansBecomeTriangles) {
    for (const int mode : {5, 6}) {
        GlbFile file = one_cube();
        Json& primitive = file.json["meshes"][0]["primitives"][0];
        primitive["mode"] = mode;
        primitive["indices"] =
            file.accessor(std::vector<std::uint16_t>{0, 1, 3, 2, 6, 7, 5}, "SCALAR");
        const BakedFile baked = expect_baked(file);
        EXPECT_THAT(baked.lines, Contains("1 strip or fan became plain triangles"));
        EXPECT_EQ(json_of("to.glb")["meshes"][0]["primitives"][0]["mode"], 4);
    }
}

TEST_F(Bake, PrimitivesThatShareVerticesGoOnSharingThem) {
    GlbFile file = one_cube();
    const std::vector<std::uint16_t> all = import::kCubeIndices;
    Json first = file.json["meshes"][0]["primitives"][0], second = first;
    first["indices"] =
        file.accessor(std::vector<std::uint16_t>(all.begin(), all.begin() + 12), "SCALAR");
    second["indices"] =
        file.accessor(std::vector<std::uint16_t>(all.begin() + 12, all.end()), "SCALAR");
    file.json["meshes"][0]["primitives"] = {first, second};
    const BakedFile baked = expect_baked({.json = file.json, .data = file.data}, {.edges = true});
    const auto from = in_folder("from.glb");
    const BakedFile coded = bake_to(from, "to.glb", kSurface);
    EXPECT_EQ(coded.added_vertices, 6U);
    const Json primitives = json_of("to.glb")["meshes"][0]["primitives"];
    EXPECT_EQ(primitives[0]["attributes"], primitives[1]["attributes"]);
    OpenFile before(from), after(in_folder("to.glb"));
    for (const std::size_t p : {0U, 1U})
        expect_same_corners(before, after, 0, p);
}

TEST_F(Bake, AMeshOfSeveralNodesTakesTheFirstAndSaysSo) {
    GlbFile file = one_cube();
    file.put("nodes", {{"mesh", 0}, {"translation", {5, 0, 0}}});
    file.put("meshes", file.json["meshes"][0]);
    file.json["scenes"][0]["nodes"] = {0, 1};
    const auto from = write("from.glb", file.bytes());
    const BakedFile baked = bake_to(from, "to.glb", kSurface);
    EXPECT_THAT(baked.lines, Contains(HasSubstr("1 mesh is used by several nodes")));
    EXPECT_THAT(baked.lines, Contains(HasSubstr("1 mesh is in no scene")));
    std::vector<std::uint32_t> codes = codes_of(from, BakedMethod::surface8);
    codes.resize(12);
    OpenFile after(in_folder("to.glb"));
    expect_codes(after, 0, 0, codes);
    EXPECT_FALSE(after.primitive(1, 0).has("_INK"));
}

TEST_F(Bake, PackedFilesComeOutUnpacked) {
    for (const int speed : {0, 10}) {
        const BakedFile baked = expect_baked(import::draco_cube(speed), kAll);
        EXPECT_THAT(baked.lines, Contains("1 of Draco is unpacked"));
        EXPECT_FALSE(json_of("to.glb").contains("extensionsRequired"));
        EXPECT_EQ(json_of("to.glb").dump().find("draco"), std::string::npos);
    }
    const auto rows = import::packed_rows(import::cube_corners<float>(), 8);
    for (const bool is_sequence : {false, true}) {
        const BakedFile baked =
            expect_baked(import::meshopt_cube(rows, {{"mode", "ATTRIBUTES"}}, is_sequence), kAll);
        EXPECT_THAT(baked.lines, Contains("2 of meshopt are unpacked"));
        EXPECT_EQ(json_of("to.glb").dump().find("meshopt"), std::string::npos);
        EXPECT_EQ(json_of("to.glb")["buffers"].size(), 1U);
    }
}

TEST_F(Bake, EdgesFollowTheTurnedTriangles) {
    (void)expect_baked(one_cube(), {.codes = BakedMethod::surface8, .edges = true});
    OpenFile file(in_folder("to.glb"));
    const Json extension = json_of(
        "to.glb")["meshes"][0]["primitives"][0]["extensions"]["EXT_mesh_primitive_edge_visibility"];
    EXPECT_FALSE(extension.contains("silhouetteNormals"));
    const auto bits = file.accessors.components(extension["visibility"]);
    ASSERT_EQ(bits.size(), 9U);
    import::GltfPrimitive primitive = file.primitive(0, 0);
    const auto p = primitive.components("POSITION");
    const auto triangles = primitive.triangles();
    int once = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            double square = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                square += std::pow(
                    p[3 * triangles[t][i] + axis] - p[3 * triangles[t][(i + 1) % 3] + axis], 2);
            const std::size_t at = 3 * t + i;
            const int value = static_cast<int>(bits[at / 4]) >> (2 * (at % 4)) & 3;
            EXPECT_EQ(value >= 2, square == 1) << "a diagonal is hidden";
            once += value == 2;
        }
    }
    EXPECT_EQ(once, 12);
}

TEST_F(Bake, SilhouettesHaveTheNormalsOfTheirTwoFaces) {
    // Two triangles on an edge along z, bent by atan(1/2).
    GlbFile file;
    const std::size_t positions =
        file.accessor(std::vector<float>{0, 0, 0, 0, 0, 1, 2, 0, 0, -2, 1, 0}, "VEC3");
    file.put(
        "meshes",
        {{"primitives",
          {{{"attributes", {{"POSITION", positions}}},
            {"indices", file.accessor(std::vector<std::uint16_t>{0, 1, 2, 1, 0, 3}, "SCALAR")}}}}});
    file.put("nodes", {{"mesh", 0}, {"scale", {-3, 1, 1}}});
    const BakedFile baked = bake_to(write("from.glb", file.bytes()), "to.glb", {.edges = true});
    EXPECT_THAT(baked.lines, Contains("edges: 4 hard ones and 1 that may be a silhouette"));
    const Json extension = json_of(
        "to.glb")["meshes"][0]["primitives"][0]["extensions"]["EXT_mesh_primitive_edge_visibility"];
    OpenFile open(in_folder("to.glb"));
    const auto n = open.accessors.components(extension["silhouetteNormals"]);
    ASSERT_EQ(n.size(), 6U);
    const float s = std::sqrt(0.2F);
    const std::vector<double> expected{0, 1, 0, s, 2 * s, 0};
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(n[i], expected[i], 1e-6) << i;
}

TEST_F(Bake, EdgesOfAnotherProgramStayOrAreRefused) {
    GlbFile file = one_cube();
    file.json["meshes"][0]["primitives"][0]["extensions"] = {
        {"EXT_mesh_primitive_edge_visibility",
         {{"visibility", file.accessor(std::vector<std::uint8_t>(9, 0xaa), "SCALAR")}}}};
    const auto from = write("from.glb", file.bytes());
    EXPECT_THAT(complaint_of(from, {.edges = true}), HasSubstr("has edges of its own"));
    EXPECT_THAT(complaint_of(from, kSurface), HasSubstr("would change the order of its edges"));
}

TEST_F(Bake, FilesBesideAreHeldByAGlb) {
    const GlbFile file = one_cube();
    Json json = file.json;
    json["buffers"] = {{{"byteLength", file.data.size()}, {"uri", "a%20cube.bin"}}};
    json["images"] = {{{"uri", "red.png"}}, {{"uri", "missing.png"}}};
    (void)write("a cube.bin", file.data);
    (void)write("red.png", "\x89PNG and so on");
    const auto from = write("from.gltf", json.dump());
    const BakedFile baked = bake_to(from, "to.glb", kSurface);
    EXPECT_THAT(baked.lines, Contains("image 1 stays where it is: missing.png"));
    const Json held = json_of("to.glb");
    EXPECT_FALSE(held["buffers"][0].contains("uri"));
    EXPECT_EQ(held["images"][0]["mimeType"], "image/png");

    (void)bake_to(from, "to.gltf", kSurface);
    const Json beside = json_of("to.gltf");
    EXPECT_EQ(beside["buffers"][0], json["buffers"][0]);
    EXPECT_EQ(beside["images"], json["images"]);
    OpenFile before(from), after(in_folder("to.gltf"));
    expect_same_corners(before, after, 0, 0);
    const BakedFile again = bake_to(in_folder("to.gltf"), "again.gltf", kSurface);
    EXPECT_TRUE(again.is_unchanged);

    std::filesystem::create_directory(in_folder("other"));
    EXPECT_THAT(complaint_of(from, kSurface, "other/to.gltf"),
                HasSubstr("the model names files beside it"));
    (void)bake_to(write("cube.glb", file.bytes()), "other/cube.gltf", kSurface);
    OpenFile cube(in_folder("cube.glb")), moved(in_folder("other/cube.gltf"));
    expect_same_corners(cube, moved, 0, 0);
}

TEST_F(Bake, ExtrasThatAreNoObjectStay) {
    GlbFile file = one_cube();
    file.json["asset"]["extras"] = "mine";
    (void)expect_baked(file);
    EXPECT_EQ(json_of("to.glb")["asset"]["extras"], "mine");
    EXPECT_TRUE(json_of("to.glb")["extras"]["inkbench"].is_object());
    file.json["extras"] = 7;
    EXPECT_THAT(complaint_of(write("from.glb", file.bytes()), kSurface),
                HasSubstr("asset.extras and extras are no objects"));
}

TEST_F(Bake, AHashDoesNotDependOnWhichCornerIsFirst) {
    scene::Scene scene;
    scene.meshes.push_back({.name = "",
                            .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                            .normals = {},
                            .triangles = {{0, 1, 2}, {0, 0, 1}},
                            .materials = {}});
    scene.instances.push_back({});
    scene::Scene turned = scene;
    turned.meshes[0].triangles = {{1, 2, 0}, {1, 0, 0}};
    EXPECT_EQ(mesh_hash(turned), mesh_hash(scene));
    turned.meshes[0].triangles = {{2, 1, 0}, {1, 0, 0}};
    EXPECT_NE(mesh_hash(turned), mesh_hash(scene));
}

}  // namespace
}  // namespace ink::bake
