// COLLADA from a file to a scene: each construct that changes geometry is read right, or refused by
// name.

#include <gmock/gmock.h>

#include "import/assimp/dae_file.h"
#include "scene/animation.h"
#include "tests/core/error_text.h"
#include "tests/import/dae_files.h"
#include "tests/import/model_files.h"
#include "tests/import/read_meshes.h"
#include "tests/import/solids.h"
#include "tests/import/zip_files.h"

namespace ink::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Dae : public ModelFiles {
  protected:
    void expect(const std::string& text,
                const glm::dvec3& low,
                const glm::dvec3& high,
                double volume) const {
        expect_solid(import_scene(write("a.dae", text)), low, high, volume);
    }
    void expect_box(const std::string& text) const { expect(text, {0, 0, 0}, {1, 2, 3}, 6); }
    void expect_fault(const std::string& text, const std::string& message) const {
        EXPECT_THAT(complaint(write("a.dae", text)), HasSubstr(message));
    }
};

const std::string kHighBox = "0 0 0 0 0 3 0 4 0 0 4 3 1 0 0 1 0 3 1 4 0 1 4 3";

/// The controller "mc" that makes the box "g" as high as "t" by a weight.
std::string morph(const std::string& method,
                  const std::string& weights,
                  const std::string& targets) {
    return "<controller id=\"mc\"><morph source=\"#g\"" + method +
           "><source id=\"mt\"><IDREF_array id=\"mta\" count=\"1\">" + targets +
           "</IDREF_array></source><source id=\"mw\"><float_array id=\"mwa\" count=\"1\">" +
           weights +
           "</float_array></source><targets><input semantic=\"MORPH_TARGET\" source=\"#mt\"/>"
           "<input semantic=\"MORPH_WEIGHT\" source=\"#mw\"/></targets></morph></controller>";
}

std::string morphed(const std::string& method,
                    const std::string& weights,
                    const std::string& targets = "t",
                    const std::string& target = kHighBox) {
    return dae_document(
        dae_geometry("g") + dae_geometry("t", target),
        "<node id=\"n\"><instance_controller url=\"#mc\"/></node>",
        "<library_controllers>" + morph(method, weights, targets) + "</library_controllers>");
}

TEST_F(Dae, MorphsStandAtTheirWeights) {
    expect(morphed("", "0.5"), {0, 0, 0}, {1, 3, 3}, 9);
    expect(morphed(" method=\"NORMALIZED\"", "0.25"), {0, 0, 0}, {1, 2.5, 3}, 7.5);
    expect(morphed("", "0"), {0, 0, 0}, {1, 2, 3}, 6);
    const std::string up = "0 0 0 0 0 0 0 2 0 0 2 0 0 0 0 0 0 0 0 2 0 0 2 0";
    expect(morphed(" method=\"RELATIVE\"", "0.5", "t", up), {0, 0, 0}, {1, 3, 3}, 9);
    expect(morphed("", ".25 .25", "t t"), {0, 0, 0}, {1, 3, 3}, 9);
}

TEST_F(Dae, AMorphBesideAPlainMeshLeavesThatAlone) {
    std::string text = morphed("", "0.5");
    text.replace(
        text.find("</visual_scene>"), 0, dae_node("<translate>5 0 0</translate>", "plain"));
    expect(text, {0, 0, 0}, {6, 3, 3}, 15);
}

TEST_F(Dae, FaultyMorphsAreNamed) {
    const std::string unused = "<instance_geometry url=\"#g\"/>";
    expect_box(replaced(morphed("", "0.5", "none"), "<instance_controller url=\"#mc\"/>", unused));
    expect_fault(morphed(" method=\"CUBIC\"", "0.5"), "method \"CUBIC\" (accepted: NORMALIZED");
    expect_fault(morphed("", "0.5 1"), "has 1 targets and 2 weights");
    expect_fault(morphed("", "0.5", "none"), "no geometry has the id \"none\"");
    std::string poor = morphed("", "0.5");
    const std::string count = "count=\"8\" stride=\"3\"";
    poor.replace(poor.rfind(count), count.size(), "count=\"7\" stride=\"3\"");
    expect_fault(poor, "its targets do not have the vertices of its base");
}

TEST_F(Dae, NormalsOfMorphsAreBlendedOrLeftOut) {
    const auto with_normals = [](std::string geometry, const std::string& normal, int count) {
        std::string numbers;
        for (int i = 0; i < count; ++i)
            numbers += normal + ' ';
        const std::string id = geometry.find("\"tv\"") == geometry.npos ? "g" : "t";
        geometry.insert(geometry.find("<vertices"), dae_source(id + "n", numbers, count));
        return replaced(geometry,
                        "</vertices>",
                        "<input semantic=\"NORMAL\" source=\"#" + id + "n\"/></vertices>");
    };
    for (const int count : {8, 9}) {
        const std::string geometries = with_normals(dae_geometry("g"), "1 0 0", 8) +
                                       with_normals(dae_geometry("t", kHighBox), "0 0 1", count);
        const std::string text = morphed("", "0.5");
        const std::size_t from = text.find("<geometry "), to = text.find("</library_geometries>");
        const scene::Scene scene =
            import_scene(write("a.dae", text.substr(0, from) + geometries + text.substr(to)));
        const std::vector<glm::vec3>& normals = scene.meshes.at(0).normals;
        EXPECT_EQ(normals.empty(), count != 8);
        for (const glm::vec3& normal : normals)
            EXPECT_LT(glm::length(normal - glm::normalize(glm::vec3(1, 0, 1))), 1e-6F);
    }
}

/// The controller "sc": all vertices of `source` follow one joint.
std::string skin(const std::string& source,
                 const std::string& joint,
                 const std::string& shape = "") {
    return "<controller id=\"sc\"><skin source=\"#" + source + "\">" + shape +
           "<source id=\"sj\"><Name_array id=\"sja\" count=\"1\">" + joint +
           "</Name_array><technique_common><accessor source=\"#sja\" count=\"1\" stride=\"1\">"
           "<param name=\"JOINT\" type=\"name\"/></accessor></technique_common></source>"
           "<source id=\"sb\"><float_array id=\"sba\" count=\"16\">1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"
           "</float_array><technique_common><accessor source=\"#sba\" count=\"1\" stride=\"16\">"
           "<param name=\"TRANSFORM\" type=\"float4x4\"/></accessor></technique_common></source>"
           "<source id=\"sw\"><float_array id=\"swa\" count=\"1\">1</float_array><technique_common>"
           "<accessor source=\"#swa\" count=\"1\" stride=\"1\"><param name=\"WEIGHT\" "
           "type=\"float\"/></accessor></technique_common></source>"
           "<joints><input semantic=\"JOINT\" source=\"#sj\"/><input "
           "semantic=\"INV_BIND_MATRIX\" source=\"#sb\"/></joints>"
           "<vertex_weights count=\"8\"><input semantic=\"JOINT\" source=\"#sj\" offset=\"0\"/>"
           "<input semantic=\"WEIGHT\" source=\"#sw\" offset=\"1\"/>"
           "<vcount>1 1 1 1 1 1 1 1</vcount><v>0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0</v>"
           "</vertex_weights></skin></controller>";
}

/// A joint 10 along x, or elsewhere.
std::string joint(const std::string& id, const std::string& sid, int x = 10) {
    return "<node id=\"" + id + "\" sid=\"" + sid + "\" type=\"JOINT\"><translate>" +
           std::to_string(x) + " 0 0</translate></node>";
}

std::string skinned(const std::string& controllers,
                    const std::string& joints,
                    const std::string& skeleton = "") {
    return dae_document(dae_geometry("g") + dae_geometry("t", kHighBox),
                        joints + "<node id=\"n\"><instance_controller url=\"#sc\">" + skeleton +
                            "</instance_controller></node>",
                        "<library_controllers>" + controllers + "</library_controllers>");
}

TEST_F(Dae, SkinsStandInThePoseOfTheirJoints) {
    expect(skinned(skin("g", "hip"), joint("j", "hip")), {10, 0, 0}, {11, 2, 3}, 6);
    const std::string shape =
        "<bind_shape_matrix>1 0 0 0 0 1 0 5 0 0 1 0 0 0 0 1</bind_shape_matrix>";
    expect(skinned(skin("g", "hip", shape), joint("j", "hip")), {10, 5, 0}, {11, 7, 3}, 6);
}

TEST_F(Dae, ASkinOverAMorphHasItsShape) {
    expect(skinned(morph("", "0.5", "t") + skin("mc", "hip"), joint("j", "hip")),
           {10, 0, 0},
           {11, 3, 3},
           9);
}

TEST_F(Dae, JointsAreThoseOfTheSkeleton) {
    const std::string two = joint("first", "hip") + joint("second", "hip", 20);
    expect(
        skinned(skin("g", "hip"), two, "<skeleton>#first</skeleton>"), {10, 0, 0}, {11, 2, 3}, 6);
    expect_fault(skinned(skin("g", "hip"), two, "<skeleton>#second</skeleton>"),
                 "several nodes are called \"hip\"");
    expect_fault(skinned(skin("g", "knee"), two), "joint \"knee\" is no node of the scene");
    std::string loose = skinned(skin("g", "hip"), two);
    loose.replace(loose.find("<v>0"), 4, "<v>-1");
    expect_fault(loose, "vertices that follow no joint (-1)");
}

TEST_F(Dae, TransformsCountInTheirOrder) {
    const std::string turn = "<rotate>0 0 1 90</rotate>", shift = "<translate>10 0 0</translate>";
    const auto one = [](const std::string& transforms) {
        return dae_document(dae_geometry("g"), dae_node(transforms));
    };
    expect(one(turn + shift), {-2, 10, 0}, {0, 11, 3}, 6);
    expect(one(shift + turn), {8, 0, 0}, {10, 1, 3}, 6);
    expect(one("<scale>2 1 1</scale>" + shift + turn), {16, 0, 0}, {20, 1, 3}, 12);
    expect(one("<matrix>1 1 0 0 0 1 0 7 0 0 1 0 0 0 0 1</matrix>"), {0, 7, 0}, {3, 9, 3}, 6);
    expect_fault(one("<skew>45 0 1 0 1 0 0</skew>"), "<node id=\"n\"> has a <skew>");
    expect_fault(one("<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1</matrix>"),
                 "its last row is not 0 0 0 1");
    expect_fault(one("<translate>1 2</translate>"), "<translate> has 2 numbers (accepted: 3)");
    expect_fault(one("<scale>1 2 x</scale>"), "\"x\" is no number");
}

TEST_F(Dae, AViewStandsSquare) {
    // From (10, 0, 0) along -x: z is x, x is -z. The up direction leans.
    const std::string view = "<lookat>10 0 0 0 0 0 1 1 0</lookat>";
    expect(dae_document(dae_geometry("g"), dae_node(view)), {10, 0, -1}, {13, 2, 0}, 6);
    expect(dae_document(dae_geometry("g"), dae_node("<translate>0 0 5</translate>" + view)),
           {10, 0, 4},
           {13, 2, 5},
           6);
    expect_fault(dae_document(dae_geometry("g"), dae_node("<lookat>0 0 0 0 1 0 0 1 0</lookat>")),
                 "looks nowhere");
}

TEST_F(Dae, NodesOfALibraryStandWhereTheyAreUsed) {
    const std::string library =
        "<library_nodes>" + dae_node("<scale>1 1 2</scale>", "l") + "</library_nodes>";
    const auto used = [&](const std::string& url) {
        return dae_document(dae_geometry("g"),
                            "<node id=\"a\"><translate>0 0 10</translate><instance_node url=\"" +
                                url +
                                "\"/></node><node id=\"b\"><instance_node url=\"#l\"/></node>",
                            library);
    };
    expect(used("#l"), {0, 0, 0}, {1, 2, 16}, 24);
    expect_fault(used("other.dae#l"), "<instance_node url=\"other.dae#l\"> is in another file");
    expect_fault(used("#none"), "names what the file does not hold (accepted: the id of a <node>)");
    expect_fault(replaced(used("#l"), "id=\"l\">", "id=\"l\"><instance_node url=\"#l\"/>"),
                 "<instance_node url=\"#l\"> places itself");
    std::string far = used("#l");
    far.replace(far.find("url=\"#g\""), 8, "url=\"http://a.b/c#g\"");
    expect_fault(far, "is in another file");
}

TEST_F(Dae, AccessorsAreHeeded) {
    std::string rows = "99 ";
    for (int i = 0; i < 8; ++i)
        rows += std::to_string(i / 4) + ' ' + std::to_string(i / 2 % 2 * 2) + " 77 " +
                std::to_string(i % 2 * 3) + " 88 ";
    std::string wide = dae_document(dae_geometry("g", rows), dae_node(""));
    wide = replaced(wide, "count=\"24\"", "count=\"41\"");
    wide = replaced(wide, "stride=\"3\"", "stride=\"5\" offset=\"1\"");
    expect_box(replaced(wide, "<param name=\"Z\"", "<param type=\"float\"/><param name=\"Z\""));
}

TEST_F(Dae, AxesHaveTheirPlacesWhateverTheyAreCalled) {
    const std::string text = dae_document(dae_geometry("g"), dae_node(""));
    const std::string named =
        "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" "
        "type=\"float\"/>";
    const auto with = [&](const std::string& parameters) {
        return replaced(text, named, parameters);
    };
    expect_box(with(""));
    expect_box(with("<param name=\"A\"/><param name=\"B\"/><param name=\"C\"/>"));
    expect_fault(with("<param name=\"Z\"/><param name=\"Y\"/><param name=\"X\"/>"),
                 "<source id=\"gp\"> has other parameters than three (accepted: X, Y and Z)");
    expect_fault(with("<param name=\"X\"/><param name=\"Y\"/>"), "other parameters than three");
    expect_fault(with("<param/><param/><param/>"), "other parameters than three");
}

TEST_F(Dae, NormalsMayComeBeforePositions) {
    const std::string text = dae_document(dae_geometry("g"), dae_node(""));
    expect_box(replaced(text,
                        "<vertices id=\"v\">",
                        "<vertices id=\"v\"><input semantic=\"NORMAL\" source=\"#gp\"/>"));
}

TEST_F(Dae, IdsAndUnitsAreThoseOfTheDocument) {
    expect_fault(dae_document(dae_geometry("g") + dae_geometry("g", kHighBox), dae_node("")),
                 "names several elements");
    const std::string high =
        replaced(dae_geometry("g", kHighBox), "geometry id=\"g\"", "geometry id=\"h\"");
    const std::string both = dae_node("") + "<node id=\"m\"><instance_geometry url=\"#h\"/></node>";
    expect(dae_document(dae_geometry("g") + high, both), {0, 0, 0}, {1, 4, 3}, 18);
    const std::string own = "<asset><unit meter=\"0.01\"/></asset>";
    expect_fault(dae_document(dae_geometry("g"), dae_node(own)),
                 "<node id=\"n\"> has a unit or an up_axis of its own");
    expect_fault(
        dae_document(dae_geometry("g"),
                     dae_node(replaced(own, "unit meter=\"0.01\"/", "up_axis>Z_UP</up_axis"))),
        "of its own");
    expect_box(dae_document(dae_geometry("g"), dae_node(replaced(own, "0.01", "1"))));
}

TEST_F(Dae, PrimitivesOfAllKindsAreFaces) {
    const std::string vertex = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";
    const auto faces = [&](const std::string& text) {
        return dae_document(dae_geometry("g", kDaeBoxCorners, text), dae_node(""));
    };
    const std::string triangles =
        "0 1 3 0 3 2 4 6 7 4 7 5 0 4 5 0 5 1 2 3 7 2 7 6 0 2 6 0 6 4 1 5 7 1 7 3";
    expect_box(faces("<triangles count=\"12\">" + vertex + "<p>" + triangles + "</p></triangles>"));
    expect_box(faces("<polygons count=\"6\">" + vertex +
                     "<p>0 1 3 2</p><p>4 6 7 5</p><p>0 4 5 1</p><p>2 3 7 6</p><p>0 2 6 4</p>"
                     "<p>1 5 7 3</p></polygons>"));
    expect_box(faces("<trifans count=\"2\">" + vertex +
                     "<p>0 1 3 2 6 4 5 1</p><p>7 3 1 5 4 6 2 3</p></trifans>"));
    expect_box(faces("<tristrips count=\"6\">" + vertex +
                     "<p>0 1 2 3</p><p>4 6 5 7</p><p>0 4 1 5</p><p>2 3 6 7</p><p>0 2 4 6</p>"
                     "<p>1 5 3 7</p></tristrips>"));
    expect_box(
        faces("<triangles count=\"12\"><input semantic=\"TEXCOORD\" source=\"#gp\" "
              "offset=\"1\" set=\"0\"/><input semantic=\"VERTEX\" source=\"#v\" "
              "offset=\"0\"/><p>0 7 1 7 3 7 0 7 3 7 2 7 4 7 6 7 7 7 4 7 7 7 5 7 0 7 4 7 5 7 "
              "0 7 5 7 1 7 2 7 3 7 7 7 2 7 7 7 6 7 0 7 2 7 6 7 0 7 6 7 4 7 1 7 5 7 7 7 1 7 "
              "7 7 3 7</p></triangles>"));
    expect_fault(
        faces("<polygons count=\"1\">" + vertex + "<ph><p>0 1 3 2</p><h>4 5 6</h></ph></polygons>"),
        "<geometry id=\"g\"> has polygons with holes");
    expect_fault(faces("<triangles count=\"1\">" + vertex + "<p>0 1 -1</p></triangles>"),
                 "<geometry id=\"g\">, <p>: \"-1\" is no index");
    expect_fault(faces("<triangles count=\"1\">" + vertex + "<p>0 1 9</p></triangles>"),
                 "Invalid data index");
    expect_fault(faces("<triangles count=\"2\">" + vertex + "<p>0 1 3</p></triangles>"),
                 "different index count");
    expect_fault(faces("<triangles count=\"1\">" + vertex + "<p>0 1 3 0 3 2</p></triangles>"),
                 "different index count");
}

TEST_F(Dae, LinesAndSplinesAreNoted) {
    for (const std::string kind : {"lines", "linestrips"}) {
        const std::string lines = "<" + kind +
                                  " count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" "
                                  "offset=\"0\"/><p>0 1</p></" +
                                  kind + ">";
        expect_box(
            dae_document(dae_geometry("g", kDaeBoxCorners, kDaeBoxFaces + lines), dae_node("")));
        EXPECT_THAT(import_scene(in_folder("a.dae")).file.notes,
                    ElementsAre("lines of 1 mesh: left out"));
    }
    expect_box(
        dae_document(dae_geometry("g") + "<geometry id=\"c\"><spline/></geometry>",
                     dae_node("") + "<node id=\"m\"><instance_geometry url=\"#c\"/></node>"));
    EXPECT_THAT(import_scene(in_folder("a.dae")).file.notes, ElementsAre("1 spline: left out"));
}

TEST_F(Dae, OtherSurfacesAreReadAsMeshesOrRefused) {
    std::string convex = dae_document(dae_geometry("g"), dae_node(""));
    for (const char* tag : {"<mesh>", "</mesh>"})
        convex.replace(convex.find(tag) + std::string(tag).find('m'), 4, "convex_mesh");
    expect_box(convex);
    const auto other = [](const std::string& surface) {
        return dae_document("<geometry id=\"g\">" + surface + "</geometry>", dae_node(""));
    };
    expect_fault(other("<convex_mesh convex_hull_of=\"#h\"/>"), "<geometry id=\"g\"> is the hull");
    expect_fault(other("<brep/>"), "is a <brep> (NURBS)");
}

TEST_F(Dae, WhatIsHiddenIsLeftOutWithANote) {
    const auto scene_with = [&](const std::string& word) {
        return dae_document(dae_geometry("g"),
                            dae_node("") + "<node id=\"h\"><translate>9 0 0</translate>" +
                                dae_node("", "deep") +
                                "<extra><technique profile=\"FCOLLADA\"><visibility>" + word +
                                "</visibility></technique></extra></node>");
    };
    for (const char* word : {"0", " 0 ", "false"}) {
        expect_box(scene_with(word));
        EXPECT_THAT(import_scene(in_folder("a.dae")).file.notes,
                    ElementsAre("1 hidden node: left out"));
    }
    expect(scene_with("1"), {0, 0, 0}, {10, 2, 3}, 12);
}

TEST_F(Dae, UnitAndUpAxisCount) {
    const auto file = [](const std::string& asset) {
        return dae_document(dae_geometry("g"), dae_node(""), "", asset);
    };
    expect(file("<unit name=\"inch\" meter=\"0.0254\"/>"),
           {0, 0, 0},
           {.0254, .0508, .0762},
           6 * .0254 * .0254 * .0254);
    expect(file("<up_axis>Z_UP</up_axis>"), {0, 0, -2}, {1, 3, 0}, 6);
    expect(file("<up_axis>X_UP</up_axis>"), {-2, 0, 0}, {0, 1, 3}, 6);
}

TEST_F(Dae, AFileWithMotionStandsAtRest) {
    const std::string keys =
        "<library_animations><animation><sampler id=\"k\"/><channel source=\"#k\" "
        "target=\"n/t.X\"/></animation></library_animations>";
    const std::string text =
        dae_document(dae_geometry("g"), dae_node("<translate sid=\"t\">1 0 0</translate>"), keys);
    expect(text, {1, 0, 0}, {2, 2, 3}, 6);
    const scene::Scene scene = import_scene(in_folder("a.dae"));
    EXPECT_THAT(scene.file.notes, ElementsAre(HasSubstr("at rest alone")));
    EXPECT_EQ(scene.animation, nullptr);
    EXPECT_THAT(scene.file.animation_names, IsEmpty());
    EXPECT_THAT(
        core::error_text([&] { return import_scene(in_folder("a.dae"), {.animation = "walk"}); }),
        testing::AllOf(HasSubstr("\"walk\""), HasSubstr("at rest alone"), HasSubstr("glTF")));
}

TEST_F(Dae, Utf16IsRead) {
    const std::string text = dae_document(dae_geometry("g"), dae_node(""));
    std::string wide = "\xff\xfe";
    for (const char c : text)
        wide += {c, '\0'};
    expect_box(wide);
}

TEST_F(Dae, ZippedDocumentsAreReadByTheirManifest) {
    const std::filesystem::path path = in_folder("a.zae");
    const std::string plain = dae_document(dae_geometry("g"), dae_node(""));
    write_zip(path,
              {{"other.dae", plain},
               {"in/main.dae", morphed("", "0.5")},
               {"manifest.xml", "<dae_root>./in/main.dae</dae_root>"}});
    EXPECT_NEAR(solid_of(import_scene(path)).volume, 9, 1e-6);
    write_zip(path, {{"first.dae", plain}});
    EXPECT_NEAR(solid_of(import_scene(path)).volume, 6, 1e-6);
    write_zip(path, {{"a.txt", "x"}});
    EXPECT_THAT(complaint(path), HasSubstr("it holds no COLLADA document"));
}

TEST(DaeCameras, AreFoundThroughNodes) {
    const DaeFile file = read_dae_text(
        "<COLLADA><!-- <camera id='c'> --><camera id='c'><optics><technique_common><perspective>"
        "<xfov>60</xfov></perspective></technique_common></optics></camera><node sid=\"only sid\">"
        "<instance_camera url=\"#c\"/><node id='in'/><instance_camera url='#c'></instance_camera>"
        "</node><node id='n'><instance_camera url='#none'/></node></COLLADA>");
    ASSERT_EQ(file.cameras.size(), 2U);
    EXPECT_EQ(file.cameras[1].node, "only sid");
    EXPECT_EQ(file.cameras[0].xfov_deg, 60);
    EXPECT_EQ(file.cameras[0].fov_y_rad(), std::nullopt) << "of no aspect";
}

}  // namespace
}  // namespace ink::import
