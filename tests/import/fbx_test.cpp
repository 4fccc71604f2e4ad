// FBX files, text and binary: every construct that changes a model at rest.

#include <gmock/gmock.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "import/fbx/axes.h"
#include "import/fbx/fbx_reader.h"
#include "import/rest_alone.h"
#include "tests/core/error_text.h"
#include "tests/import/fbx_files.h"
#include "tests/import/model_files.h"
#include "tests/import/solids.h"

namespace ink::import {
namespace {

using fbx::add_box;
using fbx::File;
using fbx::Node;
using fbx::Numbers;
using fbx::property;
using fbx::taller;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Whole = std::vector<std::int32_t>;
using FbxFiles = ModelFiles;

/// All corners of all triangles, in the world.
std::vector<glm::dvec3> corners_in(const ImportReply& reply) {
    std::vector<glm::dvec3> corners;
    for (const ImportedInstance& instance : reply.instances) {
        const ImportedMesh& mesh = reply.meshes[instance.mesh];
        for (const scene::Triangle& triangle : mesh.triangles)
            for (const std::uint32_t v : triangle)
                corners.emplace_back(instance.world_from_object * glm::dvec4(mesh.positions[v], 1));
    }
    return corners;
}

/// What a file holds, which must be the same however it is written.
ImportReply read(const File& file, const ModelChoice& choice = {}) {
    ImportReply reply = read_fbx_bytes(file.text(), choice);
    for (const fbx::Form form : {fbx::Form{}, {.is_wide = true}, {.is_packed = true}}) {
        const ImportReply other = read_fbx_bytes(file.bytes(form), choice);
        EXPECT_EQ(corners_in(other), corners_in(reply));
        EXPECT_EQ(other.notes, reply.notes);
    }
    return reply;
}

void expect_box(const std::vector<glm::dvec3>& corners,
                const glm::dvec3& low,
                const glm::dvec3& high) {
    expect_box(solid_of(corners), low, high, 1e-9);
}

std::string refusal_of(const File& file) {
    return core::error_text([&] { return read_fbx_bytes(file.text(), {}); });
}

File box_file(const std::vector<Node>& properties = {}, const std::vector<Node>& geometry = {}) {
    File file;
    add_box(file, file.model(0, "box", properties), geometry);
    return file;
}

// ---- Where models stand ---------------------------------------------------------------------

glm::dmat4 about(int axis, double degrees) {
    glm::dvec3 direction{0};
    direction[axis] = 1;
    return glm::rotate(glm::dmat4(1), degrees * std::numbers::pi / 180, direction);
}

glm::dmat4 by(double x, double y, double z) {
    return glm::translate(glm::dmat4(1), glm::dvec3(x, y, z));
}

TEST(FbxModels, StandByAllPartsOfTheirTransform) {
    // The order in which angles are applied, by RotationOrder.
    const std::vector<std::vector<int>> orders{
        {0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}};
    const double angles[] = {20, 30, 50};
    for (int order = 0; order < 6; ++order) {
        const auto& axes = orders[static_cast<std::size_t>(order)];
        const glm::dmat4 turn = about(axes[2], angles[axes[2]]) * about(axes[1], angles[axes[1]]) *
                                about(axes[0], angles[axes[0]]);
        const glm::dmat4 before = about(2, 70) * about(1, -15) * about(0, 40);
        const glm::dmat4 after = about(2, 5) * about(1, 25) * about(0, -35);
        const glm::dmat4 expected = by(1, 2, 3) * by(4, 5, 6) * by(7, 8, 9) * before * turn *
                                    glm::inverse(after) * by(-7, -8, -9) * by(.5, .25, .75) *
                                    by(3, 1, 2) * glm::scale(glm::dmat4(1), glm::dvec3(2, -3, .5)) *
                                    by(-3, -1, -2);
        const ImportReply reply = read(box_file({property("Lcl Translation", {1, 2, 3}),
                                                 property("Lcl Rotation", {20, 30, 50}),
                                                 property("Lcl Scaling", {2, -3, .5}),
                                                 property("RotationOrder", order),
                                                 property("RotationOffset", {4, 5, 6}),
                                                 property("RotationPivot", {7, 8, 9}),
                                                 property("PreRotation", {40, -15, 70}),
                                                 property("PostRotation", {-35, 25, 5}),
                                                 property("ScalingOffset", {.5, .25, .75}),
                                                 property("ScalingPivot", {3, 1, 2})}));
        ASSERT_EQ(reply.instances.size(), 1U);
        for (int column = 0; column < 4; ++column)
            EXPECT_LT(glm::length(reply.instances[0].world_from_object[column] - expected[column]),
                      1e-12)
                << order;
    }
}

TEST(FbxModels, OfSphericRotationsAreRefusedWhereItMatters) {
    expect_box(corners_in(read(
                   box_file({property("RotationOrder", 6), property("Lcl Rotation", {90, 0, 0})}))),
               {0, -3, 0},
               {1, 0, 2});
    EXPECT_THAT(
        refusal_of(box_file({property("RotationOrder", 6), property("Lcl Rotation", {90, 20, 0})})),
        HasSubstr("model \"box\": RotationOrder 6 (SphericXYZ) is not read"));
}

TEST(FbxModels, TakeOnScalesAsInheritTypeSays) {
    const auto corners = [](int inherit) {
        File file;
        const auto above = file.model(0, "above", {property("Lcl Scaling", {10, 1, 1})}, "Null");
        add_box(file,
                file.model(above,
                           "box",
                           {property("Lcl Rotation", {0, 0, 90}),
                            property("Lcl Translation", {1, 0, 0}),
                            property("Lcl Scaling", {1, 1, 5}),
                            property("InheritType", inherit)}));
        return corners_in(read(file));
    };
    // Turned, the box is 2 wide and 1 high: from -2 to 0, and what stands in its parent at 1 is
    // at 10.
    expect_box(corners(0), {8, 0, 0}, {10, 10, 15});  // its own x, which is up, is 10 times as long
    expect_box(corners(1), {-10, 0, 0}, {10, 1, 15});  // the world's x is
    expect_box(corners(2), {8, 0, 0}, {10, 1, 15});    // neither is
}

TEST(FbxModels, ComeBelowTheirParentsWhoseGeometricTransformIsTheirOwn) {
    File file;
    const auto above = file.model(0,
                                  "above",
                                  {property("Lcl Translation", {0, 0, 100}),
                                   property("GeometricTranslation", {50, 0, 0}),
                                   property("GeometricRotation", {0, 0, 90}),
                                   property("GeometricScaling", {2, 1, 1})});
    add_box(file, above);
    expect_box(corners_in(read(file)), {48, 0, 100}, {50, 2, 103});
    File below;
    const auto parent = below.model(0, "above", {property("GeometricTranslation", {50, 0, 0})});
    add_box(below, below.model(parent, "box"));
    expect_box(corners_in(read(below)), {0, 0, 0}, {1, 2, 3});
}

TEST(FbxModels, HaveTheDefaultsOfTheirKind) {
    File file = box_file();
    file.definitions = {{"ObjectType",
                         {"Model"},
                         {{"PropertyTemplate",
                           {"FbxNode"},
                           {{"Properties70", {}, {property("Lcl Translation", {5, 0, 0})}}}}}}};
    expect_box(corners_in(read(file)), {5, 0, 0}, {6, 2, 3});
}

TEST(FbxModels, ThatGoRoundAreReadOnce) {
    File file = box_file();
    const auto box = std::get<std::int64_t>(file.objects[0].values[0]);
    const auto below = file.model(box, "below");
    file.link(box, below);
    EXPECT_EQ(read(file).instances.size(), 1U);
}

TEST(FbxModels, ThatAreHiddenAreNotDrawn) {
    const auto shown = [](const std::vector<Node>& above, const std::vector<Node>& below) {
        File file;
        const auto parent = file.model(0, "above", above);
        add_box(file, parent);
        add_box(file, file.model(parent, "below", below));
        add_box(file, file.model(0, "always"));
        const ImportReply reply = read(file);
        const std::size_t hidden = 3 - reply.instances.size();
        const std::vector<std::string> said = {hidden == 1 ? "1 hidden model: not drawn"
                                                           : "2 hidden models: not drawn"};
        EXPECT_EQ(reply.notes, hidden == 0 ? std::vector<std::string>{} : said);
        std::string names;
        for (const ImportedInstance& instance : reply.instances)
            names += instance.name + ' ';
        return names;
    };
    const Node invisible = property("Visibility", Numbers{0});
    EXPECT_EQ(shown({}, {}), "above below always ");
    EXPECT_EQ(shown({invisible}, {}), "always ") << "what is below goes with it";
    EXPECT_EQ(shown({invisible}, {property("Visibility Inheritance", 0)}), "below always ");
    EXPECT_EQ(shown({}, {invisible}), "above always ");
    EXPECT_EQ(shown({property("Show", 0)}, {}), "below always ") << "Show is of one alone";
    EXPECT_THAT(refusal_of(box_file({invisible})), HasSubstr("all of its meshes are hidden"));
}

// ---- Motion ---------------------------------------------------------------------------------

TEST_F(FbxFiles, WithKeysStandAsTheirModelsDo) {
    File file = box_file({property("PreRotation", {90, 0, 0})});
    file.add(0, "AnimationStack", "Take 001", "");
    file.add(0,
             "AnimationCurve",
             "",
             "",
             {{"KeyTime", {Numbers{0, 46186158000}}}, {"KeyValueFloat", {Numbers{0, 90}}}});
    const ImportReply reply = read(file);
    expect_box(corners_in(reply), {0, -3, 0}, {1, 0, 2});
    EXPECT_EQ(reply.animation, std::nullopt);
    EXPECT_THAT(reply.notes, ElementsAre(HasSubstr("read at rest alone (for motion: glTF")));
    const auto path = write("keys.fbx", file.text());
    EXPECT_THAT(core::error_text([&] { return import_scene(path, {.animation = "Take 001"}); }),
                HasSubstr("animation \"Take 001\": the file is read at rest alone"));
    const scene::Scene scene = import_scene(path);
    EXPECT_THAT(core::error_text([&] { return check_motion_is_read(scene, "--time"), 0; }),
                HasSubstr("--time: the file of keys is read at rest alone (accepted: glTF"));
    EXPECT_THAT(core::error_text([&] {
                    return import_scene(write("still.fbx", box_file().text()),
                                        {.animation = "Take 001"});
                }),
                HasSubstr("the file has no animation"));
}

TEST(FbxMotion, IsWhatCachesOfVerticesHave) {
    File file;
    const auto box = add_box(file, file.model(0, "box"));
    file.add(box, "Deformer", "cache", "VertexCacheDeformer");
    EXPECT_THAT(read(file).notes, ElementsAre(HasSubstr("read at rest alone")));
    EXPECT_THAT(read(box_file()).notes, IsEmpty());
}

// ---- Blend shapes ---------------------------------------------------------------------------

/// A box with a channel of shapes that move its top by 2, 4 and so on.
File blended(double percent, const Numbers& full_weights) {
    File file;
    const auto box = add_box(file, file.model(0, "box"));
    const auto blend = file.add(box, "Deformer", "b", "BlendShape");
    const auto channel =
        file.add(blend,
                 "Deformer",
                 "c",
                 "BlendShapeChannel",
                 {{"FullWeights", {full_weights}},
                  {"Properties70", {}, {property("DeformPercent", Numbers{percent})}}});
    for (std::size_t s = 0; s < full_weights.size(); ++s) {
        std::vector<Node> shape = taller();
        for (double& way : std::get<Numbers>(shape[1].values[0]))
            way *= static_cast<double>(s + 1);
        file.add(channel, "Geometry", "s", "Shape", shape);
    }
    return file;
}

TEST(FbxShapes, CountByTheirPercentage) {
    const auto height = [](double percent, const Numbers& full_weights) {
        double most = 0;
        for (const glm::dvec3& p : corners_in(read(blended(percent, full_weights))))
            most = std::max(most, p.y);
        return most;
    };
    EXPECT_NEAR(height(50, {100}), 3, 1e-12);
    EXPECT_NEAR(height(150, {100}), 5, 1e-12);
    EXPECT_NEAR(height(-25, {100}), 1.5, 1e-12);
    EXPECT_NEAR(height(50, {50}), 4, 1e-12) << "whole at 50";
    // The way goes from 2 by 4 at 40 % and by 6 at 100 %.
    EXPECT_NEAR(height(20, {40, 100}), 3, 1e-12);
    EXPECT_NEAR(height(40, {40, 100}), 4, 1e-12);
    EXPECT_NEAR(height(70, {40, 100}), 5, 1e-12);
    EXPECT_THAT(refusal_of(blended(101, {40, 100})),
                HasSubstr("Deformer \"c\": DeformPercent 101.000000 of 2 shapes is not read"));
    EXPECT_THAT(refusal_of(blended(50, {100, 40})), HasSubstr("FullWeights that rise"));
}

TEST(FbxShapes, OfPointsThatAreNotThereAreDamaged) {
    File file = blended(50, {100});
    std::get<Whole>(file.objects.back().children[0].values[0])[1] = 8;
    EXPECT_THAT(refusal_of(file), HasSubstr("Geometry \"s\": it has a point that is not there"));
    std::get<Whole>(file.objects.back().children[0].values[0]) = {2, 3};
    EXPECT_THAT(refusal_of(file), HasSubstr("its Vertices are not those of its Indexes"));
}

// ---- Skins ----------------------------------------------------------------------------------

Numbers moved_matrix(double x, double y, double z) {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}

struct Cluster {
    Whole points;
    Numbers weights;
    std::string mode{};
};

/// A box bound to a bone at (0, 10, 0) that now stands at (0, 15, 0), turned by its PreRotation
/// alone: by 90 degrees about z.
File skinned(const Cluster& cluster, const std::string& type = "Linear") {
    File file;
    const auto box = add_box(file, file.model(0, "box", {property("Lcl Translation", {7, 0, 0})}));
    const auto skin = file.add(box, "Deformer", "s", "Skin", {{"SkinningType", {type}}});
    // From the mesh, as it stood at 7 along x, to the bone.
    std::vector<Node> children{{"Indexes", {cluster.points}},
                               {"Weights", {cluster.weights}},
                               {"Transform", {moved_matrix(7, -10, 0)}},
                               {"TransformLink", {moved_matrix(0, 10, 0)}}};
    if (!cluster.mode.empty()) children.push_back({"Mode", {cluster.mode}});
    const auto bound = file.add(skin, "Deformer", "c", "Cluster", children);
    const auto bone =
        file.model(0,
                   "bone",
                   {property("PreRotation", {0, 0, 90}), property("Lcl Translation", {0, 15, 0})},
                   "LimbNode");
    file.link(bone, bound);
    return file;
}

const Whole kAll{0, 1, 2, 3, 4, 5, 6, 7};

TEST(FbxSkins, StandAsTheirBonesDo) {
    // 7..8, 0..2 of the world was -10..-8 along the bone's y, which points along -x.
    expect_box(corners_in(read(skinned({kAll, Numbers(8, 1)}))), {8, 22, 0}, {10, 23, 3});
    expect_box(corners_in(read(skinned({kAll, Numbers(8, .25)}))), {8, 22, 0}, {10, 23, 3});
    // Points without a weight stand as the mesh does.
    expect_box(corners_in(read(skinned({{0, 1, 4, 5}, Numbers(4, 1)}))), {7, 2, 0}, {10, 23, 3});
    // A half of the way, the other half with the mesh: 7..8, 0 goes to 10, 22..23.
    expect_box(
        corners_in(read(skinned({kAll, Numbers(8, .5), "Total1"}))), {7.5, 11, 0}, {9, 12.5, 3});
}

TEST(FbxSkins, TurnNormalsWithTheirBones) {
    File file = skinned({kAll, Numbers(8, 1)});
    Numbers normals;
    for (int corner = 0; corner < 24; ++corner)
        normals.insert(normals.end(), {1, 0, 0});
    file.objects[1].children.push_back({"LayerElementNormal",
                                        {std::int64_t{0}},
                                        {{"MappingInformationType", {"ByPolygonVertex"}},
                                         {"ReferenceInformationType", {"Direct"}},
                                         {"Normals", {normals}}}});
    EXPECT_LT(glm::length(read(file).meshes.at(0).normals.at(5) - glm::vec3(0, 1, 0)), 1e-6);
}

TEST(FbxSkins, BendWhatShapesHaveMade) {
    File file = skinned({kAll, Numbers(8, 1)});
    const auto box = std::get<std::int64_t>(file.objects[1].values[0]);
    const auto blend = file.add(box, "Deformer", "b", "BlendShape");
    const auto channel =
        file.add(blend, "Deformer", "c", "BlendShapeChannel", {{"DeformPercent", {50.0}}});
    file.add(channel, "Geometry", "s", "Shape", taller());
    expect_box(corners_in(read(file)), {7, 22, 0}, {10, 23, 3});
}

TEST(FbxSkins, ThatBlendOtherwiseAreRefused) {
    EXPECT_THAT(refusal_of(skinned({kAll, Numbers(8, 1), "Additive"})),
                HasSubstr("Deformer \"c\": the link mode Additive is not read"));
    // One bone alone bends nothing.
    File file = skinned({kAll, Numbers(8, 1)}, "DualQuaternion");
    expect_box(corners_in(read(file)), {8, 22, 0}, {10, 23, 3});
    const auto skin = std::get<std::int64_t>(file.objects[2].values[0]);
    const auto other = file.add(skin,
                                "Deformer",
                                "d",
                                "Cluster",
                                {{"Indexes", {Whole{0}}},
                                 {"Weights", {Numbers{1}}},
                                 {"Transform", {moved_matrix(7, 0, 0)}}});
    file.link(file.model(0, "root", {}, "LimbNode"), other);
    EXPECT_THAT(refusal_of(file), HasSubstr("SkinningType DualQuaternion in a pose is not read"));
}

// ---- Meshes ---------------------------------------------------------------------------------

TEST(FbxMeshes, ThatAreNoPolygonsAreRefused) {
    for (const char* kind : {"NurbsSurface", "Patch", "Boundary", "TrimNurbsSurface"}) {
        File file = box_file();
        file.add(file.model(0, "smooth"), "Geometry", "n", kind);
        EXPECT_THAT(refusal_of(file),
                    HasSubstr(std::string("model \"smooth\": geometry of kind \"") + kind +
                              "\" is not read"));
    }
    EXPECT_THAT(refusal_of(box_file(
                    {}, {{"LayerElementHole", {std::int64_t{0}}, {{"Hole", {Whole{0, 1}}}}}})),
                HasSubstr("polygons that are holes are not read"));
}

TEST(FbxMeshes, SayWhatIsNotDrawn) {
    File file = box_file({}, {{"Smoothness", {std::int64_t{2}}}});
    const auto lines = file.add(
        file.model(0, "lines"),
        "Geometry",
        "l",
        "Mesh",
        {{"Vertices", {Numbers{0, 0, 0, 9, 0, 0}}}, {"PolygonVertexIndex", {Whole{0, -2}}}});
    EXPECT_NE(lines, 0);
    file.add(file.model(0, "curve"), "Geometry", "c", "NurbsCurve");
    file.add(0, "Constraint", "aim", "Aim");
    file.add(file.model(0, "levels"), "NodeAttribute", "", "LodGroup");
    const ImportReply reply = read(file);
    expect_box(corners_in(reply), {0, 0, 0}, {1, 2, 3});
    EXPECT_THAT(reply.notes,
                ElementsAre("1 curve without a surface: left out",
                            "1 face of less than 3 corners: left out",
                            "1 cage to be subdivided: drawn as it stands",
                            "1 constraint: models stand as they are written",
                            "1 group of levels of detail: all levels are drawn"));
}

TEST(FbxMeshes, HaveTheMaterialsOfTheirPolygons) {
    File file;
    const auto model = file.model(0, "box");
    add_box(
        file,
        model,
        {{"LayerElementMaterial",
          {std::int64_t{0}},
          {{"MappingInformationType", {"ByPolygon"}}, {"Materials", {Whole{1, 0, 1, 0, 7, 0}}}}}});
    const auto material = [&](const char* name, const std::vector<Node>& properties) {
        file.add(model, "Material", name, "", {{"Properties70", {}, properties}});
    };
    material("red", {property("DiffuseColor", {1, 0, 0})});
    material("glass",
             {property("DiffuseColor", {0, 0, 1}),
              property("DiffuseFactor", Numbers{.5}),
              property("Opacity", Numbers{.25})});
    const ImportReply reply = read(file);
    ASSERT_EQ(reply.meshes.size(), 1U);
    const std::vector<MeshPart>& parts = reply.meshes[0].parts;
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[1].first_triangle, 4U) << "two polygons of four corners each";
    EXPECT_EQ(parts[2].first_triangle, 10U);
    ASSERT_EQ(reply.base_colors.size(), 2U);
    EXPECT_EQ(reply.base_colors[parts[0].material], glm::vec4(0, 0, .5, .25));
    EXPECT_EQ(reply.base_colors[parts[1].material], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(parts[2].material, 2U) << "of none";
    EXPECT_THAT(reply.notes, ElementsAre("1 transparent material is drawn opaque"));
}

TEST(FbxMeshes, AreSharedByTheirModels) {
    File file;
    const auto box = add_box(file, file.model(0, "one"));
    file.link(box, file.model(0, "two", {property("Lcl Translation", {5, 0, 0})}));
    const ImportReply reply = read(file);
    EXPECT_EQ(reply.meshes.size(), 1U);
    ASSERT_EQ(reply.instances.size(), 2U);
    EXPECT_EQ(reply.instances[1].name, "two");
    expect_box(corners_in(reply), {0, 0, 0}, {6, 2, 3});
}

TEST(FbxMeshes, HaveNormalsByCornerPointOrPolygon) {
    const auto normals = [](const char* mapping, const Numbers& list, const Whole& indices) {
        File file;
        std::vector<Node> layer{
            {"MappingInformationType", {mapping}},
            {"ReferenceInformationType", {indices.empty() ? "Direct" : "IndexToDirect"}},
            {"Normals", {list}}};
        if (!indices.empty()) layer.push_back({"NormalsIndex", {indices}});
        file.add(file.model(0, "t"),
                 "Geometry",
                 "t",
                 "Mesh",
                 {{"Vertices", {Numbers{0, 0, 0, 1, 0, 0, 0, 1, 0}}},
                  {"PolygonVertexIndex", {Whole{2, 0, -2}}},
                  {"LayerElementNormal", {std::int64_t{0}}, layer}});
        return read(file).meshes.at(0).normals;
    };
    const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const Numbers all{1, 0, 0, 0, 1, 0, 0, 0, 1};
    EXPECT_THAT(normals("ByPolygonVertex", all, {}), ElementsAre(x, y, z));
    EXPECT_THAT(normals("ByPolygonVertex", all, {2, 2, 1}), ElementsAre(z, z, y));
    EXPECT_THAT(normals("ByVertice", all, {}), ElementsAre(z, x, y));
    EXPECT_THAT(normals("ByPolygon", all, {1}), ElementsAre(y, y, y));
    EXPECT_THAT(normals("AllSame", all, {}), ElementsAre(x, x, x));
    EXPECT_THAT(normals("ByPolygonVertex", {1, 0, 0}, {}), IsEmpty()) << "too few";
}

// ---- Files ----------------------------------------------------------------------------------

TEST(FbxTree, OfOldVersionsIsRefused) {
    File file = box_file();
    file.version = 6100;
    EXPECT_THAT(refusal_of(file), HasSubstr("is an FBX file of version 6100, which is not read"));
}

TEST(FbxTree, ThatIsCutIsDamaged) {
    const File file = box_file();
    for (const fbx::Form form : {fbx::Form{}, {.is_wide = true}, {.is_packed = true}}) {
        const std::string bytes = file.bytes(form);
        for (std::size_t size = 27; size < bytes.size(); ++size)
            EXPECT_NE(core::error_text([&] { return read_fbx_bytes(bytes.substr(0, size), {}); }),
                      "")
                << size;
    }
    const std::string text = file.text();
    for (std::size_t size = 27; size + 2 < text.size(); ++size)
        EXPECT_NE(core::error_text([&] { return read_fbx_bytes(text.substr(0, size), {}); }), "")
            << size;
}

TEST(FbxTree, SaysWhereItIsDamaged) {
    const auto error = [](const std::string& text) {
        return core::error_text([&] { return read_fbx_bytes(text, {}); });
    };
    EXPECT_THAT(error("; FBX 7.4\nA: 1\n!\n"), HasSubstr("line 4: no \"NAME:\" stands here"));
    std::string deep;
    for (int i = 0; i < 1000; ++i)
        deep += "A: {";
    EXPECT_THAT(error(deep), HasSubstr("line 1: it is nested too deeply"));
    EXPECT_THAT(error("A: \"open"), HasSubstr("line 1: a text has no end"));
}

TEST(FbxTree, TakesNumbersAsTheyAreWritten) {
    std::string text = box_file().text();
    const std::string before = "Vertices: *24 {\n a: 0,0,0,";
    const std::size_t at = text.find(before);
    ASSERT_NE(at, text.npos);
    text.replace(at,
                 before.size(),
                 "Vertices: *24 { ; a comment\n\ta: 1e-999,-0.5000000000000000000000000001,\n0\n,");
    EXPECT_EQ(corners_in(read_fbx_bytes(text, {}))[0], glm::dvec3(0, -0.5, 0));
}

// ---- Axes, units and cameras ----------------------------------------------------------------

TEST(FbxAxes, AreHeeded) {
    const auto expect_axes =
        [&](const std::vector<Node>& settings, const glm::dvec3& low, const glm::dvec3& high) {
            File file = box_file();
            file.settings = settings;
            expect_box(corners_in(read(file)), low, high);
        };
    const auto axes = [](int up, int front, int front_sign, int right) {
        return std::vector{property("UpAxis", up),
                           property("UpAxisSign", 1),
                           property("FrontAxis", front),
                           property("FrontAxisSign", front_sign),
                           property("CoordAxis", right),
                           property("CoordAxisSign", 1)};
    };
    expect_axes(axes(1, 2, 1, 0), {0, 0, 0}, {1, 2, 3});
    expect_axes(axes(2, 1, -1, 0), {0, 0, -2}, {1, 3, 0});
    expect_axes(axes(0, 2, -1, 1), {-2, 0, 0}, {0, 1, 3});
    expect_axes({property("UnitScaleFactor", Numbers{2.54})}, {0, 0, 0}, {2.54, 5.08, 7.62});
}

TEST(FbxAxes, TurnUpToYAndKeepTheHand) {
    for (int up = 0; up < 3; ++up)
        for (const int up_sign : {-1, 1})
            for (const int front_sign : {-1, 1})
                for (const int right_sign : {-1, 1}) {
                    const FbxAxes axes{.up = {up, up_sign},
                                       .front = {(up + 1) % 3, front_sign},
                                       .right = {(up + 2) % 3, right_sign}};
                    const glm::dmat3 turn(y_up_from_fbx(axes));
                    glm::dvec3 up_in_file{0};
                    up_in_file[up] = up_sign;
                    EXPECT_EQ(turn * up_in_file, glm::dvec3(0, 1, 0));
                    // Right, up and front are x, y and z turned, or mirrored.
                    const bool is_left_handed = up_sign * front_sign * right_sign < 0;
                    EXPECT_EQ(glm::determinant(turn), is_left_handed ? -1 : 1);
                }
}

TEST(FbxAxes, ThoseThatAreNoneChangeNothing) {
    EXPECT_EQ(y_up_from_fbx({.up = {7, 1}, .cm_per_unit = -3}), glm::dmat4(1));
    EXPECT_EQ(y_up_from_fbx({.right = {1, 1}}), glm::dmat4(1)) << "two are the same";
}

TEST_F(FbxFiles, OrthographicCamerasAreAsHighAsTheirZoom) {
    const auto height = [&](int projection, double zoom, double unit) {
        File file = box_file();
        file.settings = {property("UnitScaleFactor", Numbers{unit})};
        const auto eye = file.model(0, "Eye", {property("Lcl Translation", {0, 1, 10})}, "Camera");
        file.attribute(eye,
                       "Camera",
                       {property("FieldOfView", Numbers{40}),
                        property("CameraProjectionType", projection),
                        property("OrthoZoom", Numbers{zoom})});
        const scene::Scene scene = import_scene(write("cam.fbx", file.text()));
        EXPECT_EQ(scene.cameras.size(), 1U);
        return scene.cameras.at(0).height_world;
    };
    EXPECT_EQ(height(0, 1, 1), 0) << "a pinhole";
    EXPECT_NEAR(height(1, 1, 1), 30, 1e-9);
    EXPECT_NEAR(height(1, 0.25, 1), 7.5, 1e-9);
    EXPECT_NEAR(height(1, 0.25, 2.54), 19.05, 1e-6) << "in cm";
}

}  // namespace
}  // namespace ink::import
