#include "bake/mark.h"

#include <algorithm>
#include <array>

#include "core/error.h"
#include "core/hash.h"

namespace ink::bake {
namespace {

constexpr const char* kName = "inkbench";

/// Where the mark is or may be: extras that are no object leave no room.
template <class AnyJson>
AnyJson* home_of(AnyJson& gltf) {
    for (AnyJson* owner : {&gltf["asset"], &gltf}) {
        const auto extras = owner->find("extras");
        if (extras == owner->end() || extras->is_object()) return owner;
    }
    return nullptr;
}

std::string text_of(const Json& mark, const char* key) {
    const auto found = mark.find(key);
    return found != mark.end() && found->is_string() ? found->get<std::string>() : "";
}

Json part_of(const Json& mark, const char* key) {
    const auto found = mark.find(key);
    return found != mark.end() && found->is_object() ? *found : Json();
}

}  // namespace

std::optional<Mark> read_mark(const Json& gltf) {
    const Json* home = home_of(gltf);
    if (home == nullptr || !home->contains("extras")) return std::nullopt;
    const auto mark = (*home)["extras"].find(kName);
    if (mark == (*home)["extras"].end() || !mark->is_object()) return std::nullopt;
    return Mark{.version = text_of(*mark, "version"),
                .mesh = text_of(*mark, "mesh"),
                .pose = text_of(*mark, "pose"),
                .codes = part_of(*mark, "codes"),
                .edges = part_of(*mark, "edges")};
}

void write_mark(Json& gltf, const Mark& mark) {
    Json* home = home_of(gltf);
    if (home == nullptr)
        throw core::Error("extras",
                          "asset.extras and extras are no objects, so nothing can be added",
                          "a file with an object, or none, as one of them");
    Json json = {{"version", mark.version}, {"mesh", mark.mesh}};
    if (!mark.pose.empty()) json["pose"] = mark.pose;
    if (!mark.codes.is_null()) json["codes"] = mark.codes;
    if (!mark.edges.is_null()) json["edges"] = mark.edges;
    (*home)["extras"][kName] = std::move(json);
}

std::string mesh_hash(const scene::Scene& scene) {
    core::Hasher hasher;
    hasher.value(scene.origin);
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        hasher.value(instance.world_from_object).value(mesh.triangles.size());
        for (const scene::Triangle& triangle : mesh.triangles) {
            std::array<std::array<float, 3>, 3> p{};
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::vec3 place = mesh.positions[triangle[i]] + 0.0F;  // -0 is 0
                p[i] = {place.x, place.y, place.z};
            }
            auto turned = p;
            for (int turn = 0; turn < 2; ++turn) {
                std::rotate(turned.begin(), turned.begin() + 1, turned.end());
                p = std::min(p, turned);
            }
            hasher.value(p);
        }
    }
    return hasher.hex();
}

}  // namespace ink::bake
