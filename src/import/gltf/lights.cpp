#include "import/gltf/lights.h"

#include <optional>

namespace ink::import {
namespace {

constexpr const char* kExtension = "KHR_lights_punctual";

std::optional<LightKind> kind_of(const std::string& type) {
    if (type == "point") return LightKind::point;
    if (type == "spot") return LightKind::spot;
    if (type == "directional") return LightKind::distant;
    return std::nullopt;
}

double number_or(const JsonObject& json, const char* key, double fallback) {
    return json.has(key) ? json.number(key) : fallback;
}

/// The light that `json` describes, at a node.
ImportedLight light_at(const JsonObject& json, LightKind kind, const glm::dmat4& world_from_node) {
    ImportedLight light;
    light.kind = kind;
    light.p_world = world_from_node[3];
    light.direction_world = glm::dmat3(world_from_node) * glm::dvec3(0, 0, -1);
    const auto color = json.numbers("color", 3).value_or(std::vector<double>{1, 1, 1});
    light.color = glm::dvec3(color[0], color[1], color[2]) * number_or(json, "intensity", 1);
    light.is_physical = true;
    light.range = kind == LightKind::distant ? 0 : number_or(json, "range", 0);
    return light;
}

}  // namespace

std::vector<ImportedLight> read_lights(const GltfDocument& document,
                                       const GltfTree& tree,
                                       std::vector<std::string>& notes) {
    std::vector<ImportedLight> lights;
    const auto extension = document.root().extension(kExtension);
    if (!extension) return lights;
    const std::vector<JsonObject> all = extension->list("lights", "light");
    for (const std::size_t n : tree.in_scene) {
        const auto use = document.nodes[n].extension(kExtension);
        if (!use || tree.is_hidden[n]) continue;
        const JsonObject& json = all[use->index("light", all.size())];
        const std::string type = json.text("type");
        const auto kind = kind_of(type);
        if (!kind) {
            notes.push_back("a light of type '" + type + "' is not heeded");
            continue;
        }
        const std::uint32_t node = tree.number_of[n];
        lights.push_back(light_at(json, *kind, tree.world_from_node[node]));
        lights.back().node = node;
    }
    return lights;
}

}  // namespace ink::import
