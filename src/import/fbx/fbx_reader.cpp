#include "import/fbx/fbx_reader.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "import/fbx/axes.h"
#include "import/fbx/deformers.h"
#include "import/fbx/document.h"
#include "import/fbx/geometry.h"
#include "import/fbx/models.h"
#include "import/meshes/polygons.h"
#include "import/model_bytes.h"
#include "import/rest_alone.h"

namespace ink::import {
namespace {

FbxAxes axes_of(const FbxProperties& settings) {
    const FbxAxes is;
    const auto axis = [&](const std::string& name, const FbxAxes::Axis& otherwise) {
        return FbxAxes::Axis{settings.whole(name, otherwise.number),
                             settings.whole(name + "Sign", otherwise.sign)};
    };
    return {.up = axis("UpAxis", is.up),
            .front = axis("FrontAxis", is.front),
            .right = axis("CoordAxis", is.right),
            .cm_per_unit = settings.real("UnitScaleFactor", is.cm_per_unit)};
}

/// A material's colour before light and textures, and its opacity. TransparencyFactor is no good:
/// Maya always writes 1.
glm::vec4 base_color(const FbxProperties& properties) {
    const auto color = [&](const char* name, const char* factor, double otherwise) {
        return properties.vector(name, glm::dvec3(otherwise)) * properties.real(factor, 1);
    };
    glm::dvec3 base = color("DiffuseColor", "DiffuseFactor", 1);
    if (properties.find("Maya|baseColor") != nullptr)
        base = color("Maya|baseColor", "Maya|base", 1);
    if (properties.find("3dsMax|Parameters|base_color") != nullptr)
        base = color("3dsMax|Parameters|base_color", "", 1);
    const glm::dvec3 through = color("TransparentColor", "TransparencyFactor", 0);
    const double opacity = properties.real("Opacity", 1 - (through.x + through.y + through.z) / 3);
    return glm::vec4(base, opacity);
}

class FbxReader {
  public:
    explicit FbxReader(const FbxDocument& document)
        : document_(document),
          world_from_file_(y_up_from_fbx(axes_of(document.settings()))),
          models_(read_fbx_models(document, world_from_file_)) {}

    ImportReply read(const ModelChoice& choice) {
        if (has_motion()) note_rest_alone(choice, reply_.notes);
        for (const FbxObject* material : document_.all("Material")) {
            number_of_[material] = static_cast<std::uint32_t>(reply_.base_colors.size());
            reply_.base_colors.push_back(base_color(material->properties));
        }
        for (const FbxModel& model : models_) {
            take_meshes(model);
            for (const FbxObject* lens : children_of(*model.object, "NodeAttribute", "Camera"))
                take_camera(model, lens->properties);
            for (const FbxObject* lamp : children_of(*model.object, "NodeAttribute", "Light"))
                take_light(model, lamp->properties);
        }
        if (reply_.meshes.empty() && hidden_ > 0)
            throw Refusal("", "all of its meshes are hidden", "a file in which some are shown");
        note_the_rest();
        return std::move(reply_);
    }

  private:
    [[nodiscard]] bool has_motion() const {
        const auto deformers = document_.all("Deformer");
        return !document_.all("AnimationCurve").empty() ||
               std::ranges::any_of(deformers, [](const FbxObject* deformer) {
                   return deformer->kind == "VertexCacheDeformer";
               });
    }

    /// The model's geometries that are meshes. Throws Refusal for surfaces of other kinds.
    std::vector<const FbxObject*> meshes_of(const FbxModel& model) {
        std::vector<const FbxObject*> meshes;
        for (const FbxObject* geometry : children_of(*model.object, "Geometry")) {
            if (geometry->kind == "Mesh") {
                meshes.push_back(geometry);
            } else if (geometry->kind == "Line" || geometry->kind == "NurbsCurve") {
                curves_ += model.is_hidden ? 0 : 1;
            } else if (!model.is_hidden) {
                throw Refusal("",
                              "model \"" + model.object->name + "\": geometry of kind \"" +
                                  geometry->kind + "\" is not read",
                              "polygon meshes");
            }
        }
        return meshes;
    }

    void take_meshes(const FbxModel& model) {
        const std::vector<const FbxObject*> meshes = meshes_of(model);
        if (meshes.empty()) return;
        if (model.is_hidden) {
            ++hidden_;
            return;
        }
        std::vector<const FbxObject*> key = meshes;
        const auto materials = children_of(*model.object, "Material");
        key.insert(key.end(), materials.begin(), materials.end());
        const bool is_skinned = std::ranges::any_of(
            meshes, [](auto* mesh) { return !children_of(*mesh, "Deformer", "Skin").empty(); });
        auto number = static_cast<std::uint32_t>(reply_.meshes.size());
        const auto [known, is_new] = mesh_of_.try_emplace(std::move(key), number);
        if (!is_new && !is_skinned) {
            number = known->second;
        } else {
            ImportedMesh mesh;
            for (const FbxObject* geometry : meshes)
                append(*geometry, model, is_skinned, mesh);
            mesh.name = meshes.front()->name.empty() ? model.object->name : meshes.front()->name;
            reply_.meshes.push_back(std::move(mesh));
        }
        if (reply_.meshes[number].triangles.empty()) return;
        reply_.instances.push_back(
            {.mesh = number,
             .world_from_object = is_skinned ? glm::dmat4(1) : world_of_mesh(model),
             .name = model.object->name});
    }

    [[nodiscard]] static glm::dmat4 world_of_mesh(const FbxModel& model) {
        return model.world_from_model * model.model_from_mesh;
    }

    /// Takes the points of a geometry, and the normals of its corners, where its skin takes them,
    /// else where its model stands.
    void take_to_world(const FbxObject& geometry,
                       const FbxModel& model,
                       const FbxCorners& corners,
                       std::vector<glm::dvec3>& points,
                       std::vector<glm::dvec3>& normals) const {
        const auto skin = world_from_points(geometry, model, models_, points.size());
        const std::vector<glm::dmat4> places =
            skin ? *skin : std::vector<glm::dmat4>(points.size(), world_of_mesh(model));
        for (std::size_t p = 0; p < points.size(); ++p)
            points[p] = places[p] * glm::dvec4(points[p], 1);
        for (std::size_t n = 0; n < normals.size(); ++n) {
            const glm::dmat3 turn(places[corners.points[n]]);
            // The cofactors, as in scene::pose_scene.
            normals[n] = glm::dmat3(glm::cross(turn[1], turn[2]),
                                    glm::cross(turn[2], turn[0]),
                                    glm::cross(turn[0], turn[1])) *
                         normals[n];
        }
    }

    /// Appends a geometry with its blend shapes. What has a skin, or is in one object with such,
    /// stands in world space.
    void append(const FbxObject& geometry,
                const FbxModel& model,
                bool is_in_world,
                ImportedMesh& mesh) {
        std::vector<glm::dvec3> points = points_of(geometry);
        const FbxCorners corners = corners_of(geometry, points.size());
        // Normals of another shape than the base are not known.
        const bool is_base = !add_blend_shapes(geometry, points);
        std::vector<glm::dvec3> normals;
        if (is_base) normals = normals_of(geometry, corners);
        if (is_in_world) take_to_world(geometry, model, corners, points, normals);
        std::vector<glm::dvec3> positions;
        for (const std::uint32_t point : corners.points)
            positions.push_back(points[point]);
        std::vector<std::uint32_t> numbers;
        for (const FbxObject* material : children_of(*model.object, "Material"))
            numbers.push_back(number_of_.at(material));
        const auto none = static_cast<std::uint32_t>(number_of_.size());
        const std::size_t first = mesh.positions.size();
        poor_ += append_polygons(corners, positions, numbers, none, mesh);
        if (!normals.empty() || !mesh.normals.empty()) {
            mesh.normals.resize(first, glm::vec3(0));
            for (const glm::dvec3& normal : normals)
                mesh.normals.emplace_back(normal);
            mesh.normals.resize(mesh.positions.size(), glm::vec3(0));
        }
        const FbxElement* smoothness = geometry.element->child("Smoothness");
        cages_ += smoothness != nullptr && smoothness->whole(0) > 0 ? 1 : 0;
    }

    /// By how much the file's axes make lengths longer.
    [[nodiscard]] double world_per_unit() const {
        return glm::length(glm::dvec3(world_from_file_[0]));
    }

    /// It looks along its x, y is up. FieldOfView is horizontal; OrthoZoom 1 is 30 units wide.
    void take_camera(const FbxModel& model, const FbxProperties& lens) {
        constexpr double kWidthOfZoom = 30, kFovDeg = 25.114999771118164;
        const glm::dmat4& world = model.world_from_model;
        const double named = lens.real("AspectWidth", 1) / lens.real("AspectHeight", 1);
        const double aspect = named > 0.05 && named < 20 ? named : 1;
        const double fov_x_rad = lens.real("FieldOfView", kFovDeg) * std::numbers::pi / 180;
        ImportedCamera& camera = reply_.cameras.emplace_back();
        camera.name = model.object->name;
        camera.eye_world = world[3];
        camera.target_world = world[3] + world[0];
        camera.up_world = world[1];
        camera.fov_y_rad = 2 * std::atan(std::tan(fov_x_rad / 2) / aspect);
        if (lens.whole("CameraProjectionType", 0) == 1)
            camera.height_world =
                world_per_unit() * kWidthOfZoom * lens.real("OrthoZoom", 1) / aspect;
    }

    /// It shines along -y. Where it decays, half of its light is left at DecayStart, in units of
    /// the file.
    void take_light(const FbxModel& model, const FbxProperties& lamp) {
        static constexpr LightKind kKinds[] = {
            LightKind::point, LightKind::distant, LightKind::spot};
        const int type = lamp.whole("LightType", 0);
        ImportedLight& light = reply_.lights.emplace_back();
        light.kind = type >= 0 && type < 3 ? kKinds[type] : LightKind::point;
        light.p_world = model.world_from_model[3];
        light.direction_world = -model.world_from_model[1];
        light.color = lamp.vector("Color", glm::dvec3(1)) * (lamp.real("Intensity", 100) / 100);
        const double start = lamp.real("DecayStart", 1);
        if (lamp.whole("DecayType", 0) != 0 && start > 0)
            light.range = 2 * start * world_per_unit();
    }

    void note(std::size_t count, const char* what, const char* how) {
        if (count > 0) reply_.notes.push_back(counted(count, what) + how);
    }

    void note_the_rest() {
        note(hidden_, "hidden model", ": not drawn");
        note(curves_, "curve", " without a surface: left out");
        note(poor_, "face", " of less than 3 corners: left out");
        note(cages_, "cage", " to be subdivided: drawn as it stands");
        note(
            document_.all("Constraint").size(), "constraint", ": models stand as they are written");
        std::size_t groups = 0;
        for (const FbxObject* attribute : document_.all("NodeAttribute"))
            groups += attribute->kind == "LodGroup" ? 1 : 0;
        note(groups, "group", " of levels of detail: all levels are drawn");
        std::set<std::uint32_t> transparent;
        for (const ImportedMesh& mesh : reply_.meshes)
            for (const MeshPart& part : mesh.parts)
                if (part.material < reply_.base_colors.size() &&
                    reply_.base_colors[part.material].w < 1)
                    transparent.insert(part.material);
        if (!transparent.empty()) reply_.notes.push_back(drawn_opaque(transparent.size()));
    }

    const FbxDocument& document_;
    glm::dmat4 world_from_file_;
    std::vector<FbxModel> models_;
    std::map<const FbxObject*, std::uint32_t> number_of_;             ///< of materials
    std::map<std::vector<const FbxObject*>, std::uint32_t> mesh_of_;  ///< by geometry and material
    std::size_t hidden_ = 0, curves_ = 0, poor_ = 0, cages_ = 0;
    ImportReply reply_;
};

}  // namespace

std::optional<ImportReply> read_fbx(const std::filesystem::path& path, const ModelChoice& choice) {
    const std::string head = head_of(path);
    const bool is_named = lower_case(path.extension().string()) == ".fbx" && !is_utf16(head);
    if (!is_fbx_binary(head) && !without_mark(head).starts_with("; FBX") && !is_named)
        return std::nullopt;
    const std::vector<std::byte> bytes = bytes_of(path);
    return read_fbx_bytes(without_mark(text_of(bytes)), choice);
}

ImportReply read_fbx_bytes(std::string_view file, const ModelChoice& choice) {
    return FbxReader(FbxDocument(file)).read(choice);
}

}  // namespace ink::import
