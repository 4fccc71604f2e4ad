#include "import/assimp/assimp_reader.h"

#include <assimp/BaseImporter.h>
#include <assimp/camera.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/light.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <glm/matrix.hpp>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "import/animation_choice.h"
#include "import/assimp/assimp_nodes.h"
#include "import/assimp/dae_file.h"
#include "import/meshes/polygons.h"
#include "import/model_bytes.h"
#include "import/other_formats.h"
#include "import/rest_alone.h"
#include "import/stage_3ds.h"

namespace ink::import {
namespace {

LightKind kind_of(aiLightSourceType type) {
    if (type == aiLightSource_DIRECTIONAL) return LightKind::distant;
    if (type == aiLightSource_SPOT) return LightKind::spot;
    if (type == aiLightSource_AREA) return LightKind::area;
    return type == aiLightSource_AMBIENT ? LightKind::ambient : LightKind::point;
}

/// The range at which a lamp of ours has lost half of its light where the file's has; 0 for one
/// that loses none. The file's, 1 / (c + l d + q d^2), has no end. Its full light is what it has at
/// d = 0, or 1 where that is without bounds.
double range_of(const aiLight& light) {
    const double c = light.mAttenuationConstant;
    const double l = light.mAttenuationLinear;
    const double q = light.mAttenuationQuadratic;
    const bool is_unset = c == 0 && l == 1 && q == 0;  // as Assimp makes a light
    const double half = 2 * (c > 0 ? c : 1) - c;
    if (is_unset || !(l >= 0 && q >= 0 && l + q > 0)) return 0;
    const double half_way = q > 0 ? (std::sqrt(l * l + 4 * q * half) - l) / (2 * q) : half / l;
    return std::isfinite(half_way) ? 2 * half_way : 0;
}

/// By how much the root makes lengths longer.
double world_per_unit(const PlacedNode& root) {
    return std::cbrt(std::abs(glm::determinant(glm::dmat3(root.world_from_node))));
}

/// The lights of a file, each with the node of its name. Their strengths are as the file has them,
/// their ranges in the world's units.
std::vector<ImportedLight> convert_lights(const aiScene& scene,
                                          const std::vector<PlacedNode>& nodes) {
    std::vector<ImportedLight> lights;
    if (nodes.empty()) return lights;
    // Ways are in the file's units, which the root makes the world's.
    const double stretch = world_per_unit(nodes.front());
    const NodeNumbers numbers = numbers_of(nodes);
    for (unsigned i = 0; i < scene.mNumLights; ++i) {
        const aiLight& from = *scene.mLights[i];
        const auto home = numbers.find(from.mName.C_Str());
        const bool is_placed = home != numbers.end();
        const glm::dmat4 world = is_placed ? nodes[home->second].world_from_node : glm::dmat4{1};
        ImportedLight& light = lights.emplace_back();
        light.kind = kind_of(from.mType);
        light.p_world = world * glm::dvec4(to_glm(from.mPosition), 1);
        light.direction_world = glm::dmat3(world) * to_glm(from.mDirection);
        light.color = {from.mColorDiffuse.r, from.mColorDiffuse.g, from.mColorDiffuse.b};
        light.range = range_of(from) * stretch;
        light.node = is_placed ? home->second : scene::kNoNode;
    }
    return lights;
}

/// The name of the reader that took the file, such as "Collada Importer".
std::string reader_name(const Assimp::Importer& importer) {
    const int index = importer.GetPropertyInteger("importerIndex", -1);
    const aiImporterDesc* about =
        index < 0 ? nullptr : importer.GetImporterInfo(static_cast<std::size_t>(index));
    return about == nullptr ? std::string{} : about->mName;
}

/// Where a file names no aspect, 1 is a guess.
double aspect_of(const aiCamera& camera) {
    return camera.mAspect > 0.05F && camera.mAspect < 20 ? camera.mAspect : 1;
}

/// The camera's vertical angle. Assimp's documentation speaks of half the horizontal angle, its
/// readers (Collada; its issue 2256) store all of it.
double vertical_fov_rad(const aiCamera& camera) {
    return 2 * std::atan(std::tan(camera.mHorizontalFOV / 2.0) / aspect_of(camera));
}

ImportedCamera convert_camera(const aiCamera& from, const std::vector<PlacedNode>& nodes) {
    const auto home = std::ranges::find_if(
        nodes, [&](const PlacedNode& placed) { return placed.node->mName == from.mName; });
    const bool is_placed = home != nodes.end();
    const auto node = is_placed ? static_cast<std::uint32_t>(home - nodes.begin()) : scene::kNoNode;
    const glm::dmat4 world = is_placed ? home->world_from_node : glm::dmat4{1};
    const glm::dvec3 eye_node = to_glm(from.mPosition);
    const glm::dvec3 view_direction_node = to_glm(from.mLookAt), up_node = to_glm(from.mUp);
    const glm::dvec3 eye = world * glm::dvec4(eye_node, 1);
    return {.name = from.mName.C_Str(),
            .eye_world = eye,
            .target_world = eye + glm::dmat3(world) * view_direction_node,
            .up_world = glm::dmat3(world) * up_node,
            .fov_y_rad = vertical_fov_rad(from),
            .motion = {node, node, eye_node, eye_node + view_direction_node, up_node}};
}

/// What Assimp does not say of a file's cameras.
struct CameraFacts {
    std::vector<DaeCamera> dae{};
    std::map<std::string, std::size_t> asked{};  ///< how often, of each node

    /// The next Collada camera of a node, in the file's order. A node that is placed several times
    /// is asked for its own again.
    const DaeCamera* next_dae(const std::string& node) {
        const bool has_name = !node.starts_with("$ColladaAutoName$");
        std::vector<const DaeCamera*> own;
        for (const DaeCamera& camera : dae)
            if (camera.node == (has_name ? node : "")) own.push_back(&camera);
        return own.empty() ? nullptr : own[asked[has_name ? node : ""]++ % own.size()];
    }
};

void convert_cameras(const aiScene& scene,
                     const std::vector<PlacedNode>& nodes,
                     CameraFacts facts,
                     ImportReply& reply) {
    const double unit = nodes.empty() ? 1 : world_per_unit(nodes.front());
    for (unsigned c = 0; c < scene.mNumCameras; ++c) {
        const aiCamera& camera = *scene.mCameras[c];
        const std::string name = camera.mName.C_Str();
        const DaeCamera* dae = facts.next_dae(name);
        reply.cameras.push_back(convert_camera(camera, nodes));
        ImportedCamera& taken = reply.cameras.back();
        const auto angle = dae == nullptr ? std::nullopt : dae->fov_y_rad();
        if (angle) taken.fov_y_rad = *angle;
        if (dae != nullptr && dae->is_parallel) {
            taken.height_world = unit * dae->height();
        } else if (camera.mOrthographicWidth > 0) {
            taken.height_world = unit * 2 * camera.mOrthographicWidth / aspect_of(camera);
        }
    }
}

/// Each material's own colour, else that of its diffuse light, and its opacity.
void take_base_colors(const aiScene& scene, ImportReply& reply) {
    for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
        const aiMaterial& material = *scene.mMaterials[m];
        aiColor4D color(1, 1, 1, 1);
        float opacity = 1;
        if (material.Get(AI_MATKEY_BASE_COLOR, color) != aiReturn_SUCCESS)
            (void)material.Get(AI_MATKEY_COLOR_DIFFUSE, color);
        (void)material.Get(AI_MATKEY_OPACITY, opacity);
        reply.base_colors.emplace_back(color.r, color.g, color.b, opacity);
    }
}

/// What is said of materials that let light through.
void note_transparency(const aiScene& scene, ImportReply& reply) {
    std::set<unsigned> transparent;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const unsigned number = scene.mMeshes[m]->mMaterialIndex;
        float opacity = 1;
        if (number >= scene.mNumMaterials || !has_triangles(*scene.mMeshes[m])) continue;
        const bool is_known =
            scene.mMaterials[number]->Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS;
        if (is_known && opacity < 1) transparent.insert(number);
    }
    if (!transparent.empty()) reply.notes.push_back(drawn_opaque(transparent.size()));
}

/// Whether each camera and each light has a node of its name, and that name alone.
bool have_nodes(const aiScene& scene) {
    std::map<std::string, int> nodes;
    for (const PlacedNode& placed : placed_nodes(scene))
        ++nodes[placed.node->mName.C_Str()];
    const auto take = [&](const auto* thing) {
        const auto node = nodes.find(thing->mName.C_Str());
        return node != nodes.end() && node->second-- == 1;
    };
    return std::all_of(scene.mCameras, scene.mCameras + scene.mNumCameras, take) &&
           std::all_of(scene.mLights, scene.mLights + scene.mNumLights, take);
}

/// Leaves `importer` the readers of the formats that README.md has from it, and Quake's, with which
/// tests compare ours.
void keep_readers(Assimp::Importer& importer) {
    const std::set<std::string> kept{"3ds", "dae", "mdl", "md2", "md3"};
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        const std::string endings = importer.GetImporterInfo(i)->mFileExtensions;
        if (kept.contains(endings.substr(0, endings.find(' ')))) continue;
        Assimp::BaseImporter* reader = importer.GetImporter(i);
        importer.UnregisterLoader(reader);
        delete reader;  // NOLINT: Assimp gives it up with that
    }
}

ImportReply refusal(const Assimp::Importer& importer, const std::filesystem::path& path) {
    ImportReply reply;
    reply.reason = importer.GetErrorString();
    reply.status = ImportStatus::not_readable;
    if (reply.reason.starts_with("No suitable reader found")) {
        reply.status =
            has_read_ending(path) ? ImportStatus::wrong_content : ImportStatus::unknown_format;
    }
    return reply;
}

}  // namespace

ImportReply read_with_assimp(const std::filesystem::path& path,
                             const ImportChoice& choice,
                             int frame) {
    Assimp::Importer importer;
    keep_readers(importer);
    importer.SetPropertyInteger(AI_CONFIG_IMPORT_GLOBAL_KEYFRAME, frame);
    // A file without a mesh has none; the default makes up spikes for its nodes.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    std::optional<DaeFile> dae;
    if (is_dae(path)) dae = read_dae(path);
    const aiScene* scene =
        dae ? importer.ReadFileFromMemory(dae->text.data(), dae->text.size(), 0, "dae")
            : importer.ReadFile(path.string(), 0);
    if (scene == nullptr) return refusal(importer, path);
    const auto full =
        std::count_if(scene->mMeshes, scene->mMeshes + scene->mNumMeshes, [](const aiMesh* mesh) {
            return mesh->mNumVertices > 0 && mesh->mNumFaces > 0;
        });
    ImportReply reply;
    if (dae) reply.notes = dae->notes;
    if (dae && dae->has_motion) note_rest_alone(choice, reply.notes);
    if (full == 0) return reply;  // the validation would only say it less clearly
    const bool is_all_there = full == scene->mNumMeshes;
    // Points and lines stay in and are dropped with the faces that are no triangles: Assimp's own
    // sorting by kind would split meshes and reorder vertices. One empty part, or a light without a
    // node, is no reason to refuse the others, as the validation does.
    const bool is_validated = is_all_there && have_nodes(*scene);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate |
                                         (is_validated ? aiProcess_ValidateDataStructure : 0U));
    if (scene == nullptr) return refusal(importer, path);
    const std::string reader = reader_name(importer);
    const std::vector<PlacedNode> nodes = placed_nodes(*scene);
    for (unsigned a = 0; a < scene->mNumAnimations; ++a)
        reply.animation_names.emplace_back(scene->mAnimations[a]->mName.C_Str());
    scene::Animation motion;
    convert_meshes(*scene, nodes, reply, motion);
    convert_motion(
        *scene, nodes, choose_animation(reply.animation_names, choice.animation), motion);
    if (reader.starts_with("Discreet 3DS") && !nodes.empty()) {
        reply.cameras = read_3ds_cameras(path, motion);
        reply.lights = read_3ds_lights(path, motion, reply.notes);
    } else {
        convert_cameras(
            *scene, nodes, {.dae = dae ? dae->cameras : std::vector<DaeCamera>{}}, reply);
        reply.lights = convert_lights(*scene, nodes);
    }
    take_base_colors(*scene, reply);
    note_transparency(*scene, reply);
    if (motion.duration_s > 0 || !motion.skins.empty()) reply.animation = std::move(motion);
    return reply;
}

}  // namespace ink::import
