// 3MF from a file to a scene.

#include "import/three_mf.h"

#include <gmock/gmock.h>

#include "import/model_bytes.h"
#include "import/zip_archive.h"
#include "tests/core/error_text.h"
#include "tests/import/model_files.h"
#include "tests/import/read_meshes.h"
#include "tests/import/solids.h"
#include "tests/import/zip_files.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kRelations =
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Id=\"r\" Target=\"/3D/3dmodel.model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";

std::string model(const std::string& resources,
                  const std::string& build,
                  const std::string& attributes = "") {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model "
           "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
           "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" " +
           attributes + "><resources>" + resources + "</resources><build>" + build +
           "</build></model>";
}

/// The box 0..1, 0..2, 0..3.
std::string box_mesh(const std::string& first_triangle = "", const std::string& more = "") {
    std::string text = "<mesh><vertices>";
    for (int i = 0; i < 8; ++i) {
        const auto p = cube_corner(i);
        text += "<vertex x=\"" + std::to_string(p[0]) + "\" y=\"" + std::to_string(2 * p[1]) +
                "\" z=\"" + std::to_string(3 * p[2]) + "\"/>";
    }
    text += "</vertices><triangles>";
    for (const auto& face : kCubeFaces)
        for (int c = 1; c < 3; ++c)
            text += "<triangle v1=\"" + std::to_string(face[0]) + "\" v2=\"" +
                    std::to_string(face[c]) + "\" v3=\"" + std::to_string(face[c + 1]) + '"' +
                    (c == 1 && face[1] == 1 ? first_triangle : "") + "/>";
    return text + "</triangles>" + more + "</mesh>";
}

std::string object(const std::string& id,
                   const std::string& content,
                   const std::string& more = "") {
    return "<object id=\"" + id + "\" " + more + ">" + content + "</object>";
}

const std::string kBox = object("1", box_mesh());
const std::string kItem = "<item objectid=\"1\"/>";

class ThreeMf : public ModelFiles {
  protected:
    using Files = std::vector<std::pair<std::string, std::string>>;

    std::filesystem::path write_3mf(const std::string& model, Files more = {}) const {
        more.emplace_back("_rels/.rels", kRelations);
        more.emplace_back("3D/3dmodel.model", model);
        write_zip(in_folder("a.3mf"), more);
        return in_folder("a.3mf");
    }
    scene::Scene expect(const std::string& model,
                        const glm::dvec3& low,
                        const glm::dvec3& high,
                        double volume,
                        const Files& more = {}) const {
        scene::Scene scene = import_scene(write_3mf(model, more));
        expect_solid(scene, low, high, volume);
        return scene;
    }
    scene::Scene expect_box(const std::string& model, const Files& more = {}) const {
        return expect(model, {0, 0, 0}, {1, 2, 3}, 6, more);
    }
    void expect_fault(const std::string& model, const std::string& message) const {
        EXPECT_THAT(complaint(write_3mf(model)), HasSubstr(message));
    }
};

TEST_F(ThreeMf, ABuildItemIsAnInstance) {
    const scene::Scene scene =
        expect(model(object("1", box_mesh(), "name=\"Größe\""),
                     kItem + "<item objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 10 0 0\"/>"),
               {0, 0, 0},
               {10, 2, 3},
               12);
    ASSERT_EQ(scene.instances.size(), 2U);
    EXPECT_EQ(scene.meshes.size(), 1U);
    EXPECT_EQ(scene.instances[1].name, "Größe");
    EXPECT_THAT(scene.file.notes, IsEmpty());
    EXPECT_EQ(import_scene(write_3mf(model(kBox, kItem))).instances[0].name, "Object_1");
}

TEST_F(ThreeMf, ComponentsAreNestedWithTheirTransforms) {
    const std::string inner = object("2",
                                     "<components><component objectid=\"1\" transform=\"2 0 0 0 1 "
                                     "0 0 0 1 0 0 5\"/></components>");
    const std::string outer = object("3",
                                     "<components><component objectid=\"2\" transform=\"0 1 0 -1 0 "
                                     "0 0 0 1 0 0 0\"/><component objectid=\"1\"/></components>",
                                     "name=\"both\"");
    const scene::Scene scene = expect(
        model(kBox + inner + outer, "<item objectid=\"3\" transform=\"1 0 0 0 1 0 0 0 1 0 0 7\"/>"),
        {-2, 0, 7},
        {1, 2, 15},
        18);
    ASSERT_EQ(scene.instances.size(), 2U);
    EXPECT_EQ(scene.meshes.size(), 1U);
    EXPECT_EQ(scene.instances[0].name, "both");
}

TEST_F(ThreeMf, PartsInFilesOfTheirOwnAreRead) {
    // As Bambu Studio and Orca write them.
    const std::string root =
        model(object("8",
                     "<components><component p:path=\"/3D/Objects/object_1.model\" objectid=\"1\" "
                     "transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></components>"),
              "<item objectid=\"8\"/><item p:path=\"/3d/objects/OBJECT_1.model\" objectid=\"1\"/>",
              "requiredextensions=\"p\"");
    const ThreeMf::Files part{{"3D/Objects/object_1.model", model(kBox, "")}};
    const scene::Scene scene = expect(root, {0, 0, 0}, {6, 2, 3}, 12, part);
    EXPECT_EQ(scene.meshes.size(), 1U);
    EXPECT_THAT(complaint(write_3mf(root)), HasSubstr("\"3D/Objects/object_1.model\" is missing"));
}

TEST_F(ThreeMf, UnitsOfPartsAreMadeThoseOfTheModel) {
    const std::string root = model(
        object("2",
               "<components><component p:path=\"/3D/b.model\" objectid=\"1\" transform=\"1 0 0 0 1 "
               "0 0 0 1 5 0 0\"/></components>"),
        "<item objectid=\"2\"/>",
        "unit=\"centimeter\"");
    expect(root, {5, 0, 0}, {5.1, .2, .3}, .006, {{"3D/b.model", model(kBox, "")}});
    expect(model(kBox, kItem, "unit=\"inch\""), {0, 0, 0}, {1, 2, 3}, 6);
    expect_fault(model(kBox, kItem, "unit=\"parsec\""), "has the unit \"parsec\"");
}

TEST_F(ThreeMf, Utf16AndPrefixesAreRead) {
    for (const bool is_big : {false, true}) {
        std::string wide = is_big ? "\xfe\xff" : "\xff\xfe";
        for (const char c : replaced(model(kBox, kItem), "UTF-8", "UTF-16"))
            wide += is_big ? std::string{'\0', c} : std::string{c, '\0'};
        expect_box(wide);
    }
    std::string prefixed = replaced(model(kBox, kItem), "xmlns=", "xmlns:m=");
    prefixed = replaced(replaced(prefixed, "<", "<m:"), "<m:/", "</m:");
    expect_box(replaced(prefixed, "<m:?", "<?"));
}

TEST_F(ThreeMf, DigitsAreKept) {
    const std::string far = replaced(model(kBox, kItem), "x=\"", "x=\"500000");
    const scene::Scene scene =
        import_scene(write_3mf(replaced(far, "x=\"5000001", "x=\"5000000.001")));
    EXPECT_NEAR(solid_of(scene).volume, 6 * 0.001, 1e-9);
}

TEST_F(ThreeMf, ExtensionsThatAreRequiredAreReadOrRefused) {
    const auto with = [](const std::string& language, const std::string& more = "") {
        return model(object("1", box_mesh("", more)),
                     kItem,
                     "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/" + language +
                         "\" requiredextensions=\"p b\"");
    };
    expect_box(with("material/2015/02"));
    EXPECT_THAT(expect_box(with("trianglesets/2021/07", "<b:trianglesets/>")).file.notes,
                IsEmpty());
    expect_fault(with("beamlattice/2017/02"), "it requires the extension b (http");
    expect_fault(with("slice/2015/07"), "/slice/2015/07), which is not read");
    expect_fault(model(kBox, kItem, "requiredextensions=\"q\""), "the extension q ()");
    const scene::Scene beams = expect_box(replaced(
        with("beamlattice/2017/02", "<b:beamlattice/>"), "requiredextensions=\"p b\"", ""));
    EXPECT_THAT(beams.file.notes, ElementsAre("1 <b:beamlattice>: left out"));
    expect_fault(model(object("1", "<v:levelset xmlns:v=\"v\"/>"), kItem),
                 "is <v:levelset>, which is not read");
}

TEST_F(ThreeMf, SupportsAndOtherItemsAreLeftOutWithANote) {
    for (const char* type : {"support", "solidsupport"}) {
        const scene::Scene scene = expect_box(
            model(kBox + object("2", box_mesh(), std::string("type=\"") + type + '"'),
                  kItem + "<item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 9 9 9\"/>"));
        EXPECT_THAT(scene.file.notes,
                    ElementsAre(std::string("1 object of type \"") + type + "\": left out"));
    }
    const std::string other = object("2", box_mesh(), "type=\"other\"");
    EXPECT_THAT(expect_box(model(kBox + other, kItem + "<item objectid=\"2\"/>")).file.notes,
                ElementsAre("1 build item of type \"other\": left out"));
    const std::string holder = object("3", "<components><component objectid=\"2\"/></components>");
    EXPECT_THAT(expect_box(model(other + holder, "<item objectid=\"3\"/>")).file.notes, IsEmpty());
    expect_box(model(object("1", box_mesh(), "type=\"surface\""), kItem));
}

TEST_F(ThreeMf, MaterialsArePartsOfAnObject) {
    const std::string colors =
        "<basematerials id=\"5\"><base name=\"a\" displaycolor=\"#FF0000\"/><base name=\"b\" "
        "displaycolor=\"#0000FF80\"/></basematerials>";
    const auto path = write_3mf(model(
        colors + object("1", box_mesh(" pid=\"5\" p1=\"1\""), "pid=\"5\" pindex=\"0\""), kItem));
    const ImportedModel read = import_model(path);
    ASSERT_EQ(read.places.parts_of_mesh.at(0).size(), 2U);
    ASSERT_EQ(read.base_colors.size(), 2U);
    EXPECT_EQ(read.base_colors[0], glm::vec4(0, 0, 1, 128 / 255.0F));
    EXPECT_EQ(read.base_colors[1], glm::vec4(1, 0, 0, 1));
    EXPECT_THAT(read.scene.file.notes, ElementsAre("1 transparent material is drawn opaque"));
    EXPECT_NEAR(solid_of(read.scene).volume, 6, 1e-6);
}

TEST_F(ThreeMf, FaultsAreNamed) {
    const std::string sound = model(kBox, kItem);
    const auto fault =
        [&](const std::string& what, const std::string& by, const std::string& says) {
            SCOPED_TRACE(by);
            expect_fault(replaced(sound, what, by), says);
        };
    fault("v3=\"5\"",
          "v3=\"8\"",
          "object 1 of \"3D/3dmodel.model\": v3 of a triangle is \"8\" (accepted: 0..7)");
    fault("v3=\"5\"", "v3=\"-1\"", "v3 of a triangle is \"-1\"");
    fault("v3=\"5\"", "", "v3 of a triangle is \"\"");
    fault("x=\"1\"", "x=\"1,5\"", "x of a vertex is \"1,5\"");
    fault("x=\"1\"", "x=\"nan\"", "x of a vertex is \"nan\"");
    fault("objectid=\"1\"", "objectid=\"7\"", "names the object \"7\"");
    fault("objectid=\"1\"",
          "objectid=\"1\" transform=\"1 2\"",
          "transform is \"1 2\" (accepted: 12 numbers)");
    fault("</resources>", kBox + "</resources>", "object 1 of \"3D/3dmodel.model\" is there twice");
    fault("core/2015/02", "core/2035/02", "is no 3MF model");
    fault("</build>", "", "line 2: no well-formed XML");
    expect_fault(model(object("1", "<components><component objectid=\"1\"/></components>"), kItem),
                 "is a component of itself");
    expect_fault(model(object("1", ""), kItem), "is empty, which is not read");
}

TEST_F(ThreeMf, ManyLevelsOfComponentsEnd) {
    std::string resources = object("1", box_mesh());
    for (int level = 2; level < 40; ++level) {
        const std::string one = "<component objectid=\"" + std::to_string(level - 1) + "\"/>";
        resources += object(std::to_string(level), "<components>" + one + one + "</components>");
    }
    expect_fault(model(resources, "<item objectid=\"39\"/>"), "its components are too many");
}

TEST_F(ThreeMf, DamagedPackagesAreNamed) {
    const auto path = write_3mf(model(kBox, kItem));
    const std::vector<std::byte> whole = bytes_of(path);
    const std::string bytes(text_of(whole));
    EXPECT_THAT(complaint(write("cut.3mf", bytes.substr(0, bytes.size() / 2))),
                HasSubstr("cut short or no zip file"));
    EXPECT_THAT(complaint(write("text.3mf", "no zip")), HasSubstr("cut short or no zip file"));
    std::string flipped = bytes;
    flipped[flipped.find("3D/3dmodel.model") + 60] ^= 1;
    EXPECT_THAT(complaint(write("flip.3mf", flipped)),
                HasSubstr("\"3D/3dmodel.model\" is damaged"));
    write_zip(in_folder("b.3mf"), {{"a.txt", "x"}});
    EXPECT_THAT(complaint(in_folder("b.3mf")), HasSubstr("it has no file \"_rels/.rels\""));
    write_zip(in_folder("b.3mf"),
              {{"_rels/.rels", replaced(kRelations, "2013/01/3dmodel", "2019/04/keystore")}});
    EXPECT_THAT(complaint(in_folder("b.3mf")), HasSubstr("its content is encrypted"));
}

TEST_F(ThreeMf, ABombEndsWithinTheLimits) {
    const auto path = write_3mf(model(kBox, kItem) + std::string(100U << 20U, ' '));
    ASSERT_LT(std::filesystem::file_size(path), 1U << 20U);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which set no limit
    ImportLimits limits;
    limits.memory_bytes = 128U << 20U;
    EXPECT_THAT(complaint(path, limits), HasSubstr("more memory than 128 MiB"));
#endif
    EXPECT_THAT(
        core::error_text([&] { return ZipArchive(path).read("3D/3dmodel.model", 10U << 20U); }),
        HasSubstr("too long unpacked (accepted: 10485760 bytes"));
}

}  // namespace
}  // namespace ink::import
