#include "import/imported_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "core/error.h"
#include "import/printable.h"
#include "scene/materials.h"

namespace ink::import {
namespace {

constexpr std::size_t kMostNameChars = 80;
constexpr std::size_t kMostNoteChars = 160;
constexpr std::size_t kMostCameras = 256;
// Products of three coordinates, as the predicates form them, stay far from overflow.
constexpr double kMostSceneExtent = 1e60;

bool is_usable_normal(const glm::vec3& n) {
    const double length = glm::length(glm::dvec3(n));
    return std::isfinite(length) && length > 0;
}

bool has_area(const scene::Mesh& mesh, const scene::Triangle& triangle) {
    const glm::dvec3 a = mesh.positions[triangle[0]];
    const glm::dvec3 b = mesh.positions[triangle[1]];
    const glm::dvec3 c = mesh.positions[triangle[2]];
    return glm::length(glm::cross(b - a, c - a)) > 0;
}

/// Makes the normals unit, or drops them all if a triangle that can be seen uses one that is none
/// (many STL writers leave zeros): a mesh has normals or it has not.
void tidy_normals(scene::Mesh& mesh) {
    const auto is_bad = [&](std::uint32_t v) { return !is_usable_normal(mesh.normals[v]); };
    const bool has_bad = std::ranges::any_of(mesh.triangles, [&](const scene::Triangle& triangle) {
        return !mesh.normals.empty() && std::ranges::any_of(triangle, is_bad) &&
               has_area(mesh, triangle);
    });
    if (has_bad) mesh.normals.clear();
    for (glm::vec3& n : mesh.normals) {
        n = is_usable_normal(n) ? glm::vec3(glm::normalize(glm::dvec3(n))) : glm::vec3(0, 0, 1);
    }
}

/// What must hold before anything walks the meshes.
void check_indices(const ImportReply& reply, const std::string& where) {
    const auto check = [&](bool is_good, const char* what) {
        if (!is_good) throw core::Error(where, std::string("its reader ") + what);
    };
    for (const ImportedInstance& instance : reply.instances)
        check(instance.mesh < reply.meshes.size(), "placed a mesh that it did not hand over");
    for (std::size_t m = 0; m < reply.meshes.size(); ++m) {
        const ImportedMesh& mesh = reply.meshes[m];
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (const std::uint32_t v : mesh.triangles[t]) {
                if (v < mesh.positions.size()) continue;
                throw core::Error(where,
                                  fmt::format("mesh {}: triangle {} uses vertex {}", m, t, v),
                                  mesh.positions.empty()
                                      ? "a mesh with vertices"
                                      : fmt::format("0..{}", mesh.positions.size() - 1));
            }
        std::uint32_t first = 0;  // of the part that comes next, at least
        for (const MeshPart& part : mesh.parts) {
            check(&part == mesh.parts.data() ? part.first_triangle == 0
                                             : part.first_triangle >= first,
                  "put the parts of a mesh out of order");
            first = part.first_triangle;
        }
        check(first <= mesh.triangles.size(), "put a part of a mesh behind its end");
    }
    if (!reply.animation) return;
    const scene::Animation& animation = *reply.animation;
    for (std::size_t n = 0; n < animation.nodes.size(); ++n) {
        const std::uint32_t parent = animation.nodes[n].parent;
        check(parent == scene::kNoNode || parent < n, "hung a node on one that comes later");
    }
    for (const scene::Skin& skin : animation.skins) {
        check(skin.mesh < reply.meshes.size(), "gave bones to a mesh that it did not hand over");
        for (const scene::Skin::Bone& bone : skin.bones)
            check(bone.node < animation.nodes.size(), "made a bone of a node that is not there");
    }
    for (const scene::Morph& morph : animation.morphs)
        check(morph.mesh < reply.meshes.size(), "shaped a mesh that it did not hand over");
}

void check_counts(const scene::Scene& scene,
                  std::uint64_t most_triangles,
                  const std::string& where) {
    const std::size_t triangles = scene::triangle_count(scene);
    if (triangles == 0) {
        throw core::Error(where, "it holds no triangle", "a model with at least one");
    }
    if (triangles > most_triangles) {
        throw core::Error(where,
                          fmt::format("it holds {} triangles", triangles),
                          fmt::format("up to {}", most_triangles));
    }
}

/// Calls `check`, with the path in front of what it says of the scene.
template <class Check>
void check_at(const std::string& where, const scene::Scene& scene, Check check) {
    try {
        check();
    } catch (const core::Error& error) {
        // "name, mesh 3" without the name, for the path stands there already.
        const std::size_t name_end = std::min(error.where().size(), scene.name.size() + 2);
        const std::string place = error.where().substr(name_end);
        throw core::Error(where,
                          (place.empty() ? place : place + ": ") + error.what_happened(),
                          error.accepted());
    }
}

/// check_scene, and a look at the whole extent.
void check_numbers(const scene::Scene& scene, const std::string& where) {
    check_at(where, scene, [&] { scene::check_scene(scene); });
    const double radius = scene::bounding_sphere(scene).radius;
    if (!(radius < kMostSceneExtent)) {
        throw core::Error(where,
                          fmt::format("its extent is {:g}", radius),
                          fmt::format("less than {:g}", kMostSceneExtent));
    }
}

/// Gives the scene its motion, if that is sound; what has bones or shapes is put as it is at
/// rest. Returns it for what else moves; null if nothing does.
std::shared_ptr<scene::Animation> take_animation(std::optional<scene::Animation>&& animation,
                                                 scene::Scene& scene,
                                                 const std::string& where) {
    if (!animation) return nullptr;
    // A mesh that lost its normals must not get them back with a frame.
    for (std::size_t m = 0; m < std::min(scene.meshes.size(), animation->vertex_frames.size());
         ++m) {
        if (scene.meshes[m].normals.empty()) animation->vertex_frames[m].normals.clear();
    }
    for (scene::Skin& skin : animation->skins) {
        skin.positions = scene.meshes[skin.mesh].positions;
        skin.normals = scene.meshes[skin.mesh].normals;
    }
    for (scene::Morph& morph : animation->morphs) {
        morph.positions = scene.meshes[morph.mesh].positions;
        morph.normals = scene.meshes[morph.mesh].normals;
        for (scene::Morph::Target& target : morph.targets)
            if (morph.normals.empty()) target.normals.clear();
    }
    check_at(where, scene, [&] { scene::check_animation(scene, *animation); });
    const bool is_moving = animation->duration_s > 0;
    auto taken = std::make_shared<scene::Animation>(std::move(*animation));
    scene.animation = taken;
    if (!taken->skins.empty() || !taken->morphs.empty()) scene::rest_scene(scene);
    if (is_moving) return taken;
    scene.animation.reset();
    return nullptr;
}

/// A camera's name as a word fit for tables and file names, not yet in `taken`.
std::string camera_name(const std::string& wanted, std::set<std::string>& taken) {
    std::string base = wanted.substr(0, kMostNameChars);
    for (char& c : base) {
        const bool is_plain =
            (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        if (!is_plain && c != '-') c = '_';
    }
    if (base.empty()) base = "camera";
    std::string name = base;
    for (int i = 2; !taken.insert(name).second; ++i)
        name = fmt::format("{}_{}", base, i);
    return name;
}

/// Gives the scene the cameras that look somewhere; returns their nodes, one for one.
std::vector<std::uint32_t> take_cameras(const std::vector<ImportedCamera>& imported,
                                        scene::Scene& scene) {
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    std::vector<std::uint32_t> nodes;
    std::set<std::string> taken;
    for (const ImportedCamera& from : imported) {
        if (scene.cameras.size() == kMostCameras) break;
        constexpr double kLeastFov_rad = 1e-3;
        constexpr double kMostFov_rad = std::numbers::pi - 1e-3;
        const bool is_parallel = from.height_world > 0 && std::isfinite(from.height_world);
        const bool is_pinhole = from.height_world == 0 && from.fov_y_rad >= kLeastFov_rad &&
                                from.fov_y_rad <= kMostFov_rad;
        if (!is_parallel && !is_pinhole) continue;
        try {
            scene::Camera camera =
                scene::look_at(from.eye_world, from.target_world, from.up_world, from.fov_y_rad);
            camera.height_world = from.height_world;
            camera.name = camera_name(from.name, taken);
            scene::fit_clip_range(camera, bounds);
            scene::stand_before(camera, bounds);
            scene.cameras.push_back(std::move(camera));
            nodes.push_back(from.node);
        } catch (const core::Error&) {
            continue;  // it looks nowhere, which does not make the model worse
        }
    }
    return nodes;
}

/// Lets the cameras go with their nodes where those move at all.
void take_camera_nodes(const std::vector<std::uint32_t>& nodes,
                       const std::shared_ptr<scene::Animation>& animation,
                       const scene::Scene& scene,
                       const std::string& where) {
    if (!animation) return;
    animation->node_of_camera = nodes;
    check_at(where, scene, [&] { scene::check_animation(scene, *animation); });
    bool is_any = false;
    for (std::uint32_t& node : animation->node_of_camera) {
        const bool is_moving = node != scene::kNoNode && animation->is_moving(node);
        if (!is_moving) node = scene::kNoNode;
        is_any = is_any || is_moving;
    }
    if (!is_any) animation->node_of_camera.clear();
}

/// What the reply says of the file, fit to be printed.
scene::FileFacts facts_of(const ImportReply& reply) {
    const auto all = [](std::vector<std::string> texts, std::size_t most) {
        for (std::string& text : texts)
            text = printable(text, most);
        return texts;
    };
    return {.animation_names = all(reply.animation_names, kMostNameChars),
            .notes = all(reply.notes, kMostNoteChars)};
}

}  // namespace

scene::Scene scene_from_reply(ImportReply&& reply,
                              const std::filesystem::path& path,
                              std::uint64_t most_triangles,
                              bool material_seams) {
    const std::string where = path.string();
    check_indices(reply, where);
    scene::Scene scene;
    scene.name = path.stem().string();
    scene.split = scene::Split::real;
    scene.origin = take_out_origin(reply);
    for (ImportedMesh& mesh : reply.meshes) {
        mesh.name = printable(mesh.name, kMostNameChars);
        scene.meshes.push_back(to_float_mesh(std::move(mesh)));
    }
    for (const ImportedInstance& instance : reply.instances) {
        scene.instances.push_back(
            {instance.mesh, instance.world_from_object, printable(instance.name, kMostNameChars)});
    }
    check_counts(scene, most_triangles, where);
    // Normals wait aside: bad ones are no reason to refuse a file, but the indices must be known to
    // be good before they are looked at.
    std::vector<std::vector<glm::vec3>> normals;
    for (scene::Mesh& mesh : scene.meshes)
        normals.push_back(std::exchange(mesh.normals, {}));
    check_numbers(scene, where);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        if (normals[m].size() != scene.meshes[m].positions.size()) continue;
        scene.meshes[m].normals = std::move(normals[m]);
        tidy_normals(scene.meshes[m]);
    }
    scene.file = facts_of(reply);
    const auto animation = take_animation(std::move(reply.animation), scene, where);
    const auto camera_nodes = take_cameras(reply.cameras, scene);
    take_lights(reply.lights, animation, scene);
    take_camera_nodes(camera_nodes, animation, scene, where);  // checks the lights', too
    if (material_seams) scene::split_materials(scene);
    return scene;
}

}  // namespace ink::import
