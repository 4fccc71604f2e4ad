#include "import/imported_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "core/error.h"
#include "import/printable.h"
#include "scene/materials.h"

namespace ink::import {
namespace {

constexpr std::size_t kMostLights = 64;  // each is worked out at every vertex
// How far a distant light hangs from the scene's middle, in radii: its rays differ by less than a
// tenth of a degree.
constexpr double kFarRadii = 1000;
// As far as check_animation lets anything reach.
constexpr double kMostExtent = 1e30;

bool is_usable(double x) {
    return std::isfinite(x) && std::abs(x) < kMostExtent;
}

bool is_usable(const glm::dvec3& v) {
    return is_usable(v.x) && is_usable(v.y) && is_usable(v.z);
}

bool is_usable(const ImportedLight& light) {
    const bool has_place =
        light.kind == LightKind::distant
            ? is_usable(light.direction_world) && glm::length(light.direction_world) > 0
            : is_usable(light.p_world);
    return has_place && is_usable(glm::dvec3(light.color)) && is_usable(light.range) &&
           light.range >= 0;
}

double brightest(const glm::dvec3& color) {
    return std::max({color.r, color.g, color.b});
}

/// A lamp and how it moves; its colour as doubles until it is made a share of the brightest.
struct Lamp {
    scene::OmniLight light;
    scene::LightMotion motion;
    glm::dvec3 color{0};
};

Lamp make_lamp(const ImportedLight& from, const scene::Sphere& bounds) {
    Lamp lamp;
    lamp.color = from.color;
    lamp.light.p_world = from.p_world;
    const double radius = bounds.radius > 0 ? bounds.radius : 1;
    if (from.kind == LightKind::distant) {
        lamp.light.p_world =
            bounds.center_world - glm::normalize(from.direction_world) * (kFarRadii * radius);
        return lamp;
    }
    lamp.light.range = from.range;
    if (!from.is_physical) return lamp;
    // Light thins out with the square of the way (which no lamp of the shading's does); from
    // within the scene as from its rim.
    const double way = std::max(glm::length(from.p_world - bounds.center_world), radius);
    lamp.color *= 1 / (way * way);
    return lamp;
}

/// Hangs the lamp on a node; one that is squeezed flat carries nothing.
void hang(std::uint32_t node, const std::vector<glm::dmat4>& world_from_node, Lamp& lamp) {
    const glm::dvec3 p_node =
        glm::inverse(world_from_node[node]) * glm::dvec4(lamp.light.p_world, 1);
    if (!is_usable(p_node)) return;
    lamp.motion.node = node;
    lamp.motion.p_node = p_node;
}

/// A line such as "2 spotlights shine to all sides", nothing for none.
void note(std::size_t count, const char* one, const char* many, scene::Scene& scene) {
    if (count == 0) return;
    scene.file.notes.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
}

/// Makes the brightest lamp 1: always where strengths are physical, else only from above.
void balance(bool is_physical, std::vector<Lamp>& lamps) {
    double most = 0;
    for (const Lamp& lamp : lamps)
        most = std::max(most, brightest(lamp.color));
    if (!(most > (is_physical ? 0 : 1))) return;
    for (Lamp& lamp : lamps)
        lamp.color *= 1 / most;
}

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

void take_lights(const std::vector<ImportedLight>& lights,
                 const std::shared_ptr<scene::Animation>& animation,
                 scene::Scene& scene) {
    const scene::Sphere bounds = scene::bounding_sphere(scene);
    const auto world_from_node =
        animation ? scene::world_from_nodes(*animation, std::nullopt) : std::vector<glm::dmat4>{};
    std::vector<Lamp> lamps;
    bool is_physical = false;
    std::size_t unusable = 0;
    std::size_t too_many = 0;
    for (const ImportedLight& from : lights) {
        if (!is_usable(from)) {
            ++unusable;
            continue;
        }
        Lamp lamp = make_lamp(from, bounds);
        if (lamp.color == glm::dvec3{0}) continue;
        if (lamps.size() == kMostLights) {
            ++too_many;
            continue;
        }
        if (from.node < world_from_node.size() && animation->is_moving(from.node))
            hang(from.node, world_from_node, lamp);
        is_physical = is_physical || from.is_physical;
        lamps.push_back(std::move(lamp));
    }
    balance(is_physical, lamps);
    const auto spots = std::ranges::count(lights, LightKind::spot, &ImportedLight::kind);
    note(static_cast<std::size_t>(spots),
         "spotlight shines to all sides",
         "spotlights shine to all sides",
         scene);
    note(unusable,
         "light of impossible numbers is not heeded",
         "lights of impossible numbers are not heeded",
         scene);
    note(too_many,
         "light beyond the 64th is not heeded",
         "lights beyond the 64th are not heeded",
         scene);
    bool is_any_moving = false;
    std::vector<scene::LightMotion> motions;
    for (Lamp& lamp : lamps) {
        lamp.light.color = lamp.color;
        scene.lights.push_back(lamp.light);
        is_any_moving = is_any_moving || lamp.motion.node != scene::kNoNode;
        motions.push_back(lamp.motion);
    }
    if (animation && is_any_moving) animation->lights = std::move(motions);
}

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
