#include "import/gltf/tree.h"

#include <cmath>
#include <optional>
#include <utility>

namespace ink::import {
namespace {

constexpr std::size_t kNobody = ~std::size_t{0};
constexpr double kUnitSlack = 0.02;    // normalised bytes are that good
constexpr double kAffineSlack = 1e-4;  // of matrices that were inverted in floats

glm::dvec3 vector_or(const JsonObject& node, const char* key, const glm::dvec3& fallback) {
    const auto v = node.numbers(key, 3);
    return v ? glm::dvec3((*v)[0], (*v)[1], (*v)[2]) : fallback;
}

glm::dmat4 parent_from_node(const JsonObject& node) {
    const auto m = node.numbers("matrix", 16);
    return m ? affine_matrix(*m, node) : place_of(node).matrix();
}

std::vector<std::vector<std::size_t>> children_of(const GltfDocument& document) {
    std::vector<std::vector<std::size_t>> children;
    for (const JsonObject& node : document.nodes)
        children.push_back(node.indices("children", document.nodes.size()));
    return children;
}

/// Whose child each node is.
std::vector<std::size_t> parents_of(const GltfDocument& document,
                                    const std::vector<std::vector<std::size_t>>& children) {
    std::vector<std::size_t> parents(document.nodes.size(), kNobody);
    for (std::size_t n = 0; n < children.size(); ++n)
        for (const std::size_t child : children[n]) {
            if (parents[child] != kNobody) {
                document.nodes[child].fail("it is a child of node " +
                                               std::to_string(parents[child]) + " and of node " +
                                               std::to_string(n),
                                           "one parent");
            }
            parents[child] = n;
        }
    return parents;
}

/// The roots of the scene that is shown; of all trees if the file has no scene.
std::vector<std::size_t> scene_roots(const GltfDocument& document,
                                     const std::vector<std::size_t>& parents) {
    std::vector<std::size_t> roots;
    if (document.scenes.empty()) {
        for (std::size_t n = 0; n < parents.size(); ++n)
            if (parents[n] == kNobody) roots.push_back(n);
        return roots;
    }
    const std::size_t number =
        document.root().find_index("scene", document.scenes.size()).value_or(0);
    const JsonObject& scene = document.scenes[number];
    roots = scene.indices("nodes", document.nodes.size());
    std::vector<bool> is_taken(document.nodes.size(), false);
    for (const std::size_t root : roots) {
        if (parents[root] != kNobody) {
            scene.fail("node " + std::to_string(root) + " is a child of node " +
                           std::to_string(parents[root]),
                       "nodes without a parent");
        }
        if (is_taken[root]) scene.fail("it has node " + std::to_string(root) + " twice", "once");
        is_taken[root] = true;
    }
    return roots;
}

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

glm::dmat4 GltfPlace::matrix() const {
    glm::dmat4 m = glm::mat4_cast(rotation);
    for (int axis = 0; axis < 3; ++axis)
        m[axis] *= scale[axis];
    m[3] = glm::dvec4(translation, 1);
    return m;
}

GltfPlace place_of(const JsonObject& node) {
    GltfPlace place;
    place.translation = vector_or(node, "translation", place.translation);
    place.scale = vector_or(node, "scale", place.scale);
    if (const auto q = node.numbers("rotation", 4))
        place.rotation = unit_rotation({(*q)[3], (*q)[0], (*q)[1], (*q)[2]}, node);
    return place;
}

glm::dquat unit_rotation(const glm::dquat& q, const JsonObject& owner) {
    const double length = std::sqrt(glm::dot(q, q));
    if (!(std::abs(length - 1) < kUnitSlack))
        owner.fail("a rotation of length " + std::to_string(length), "length 1");
    return q * (1 / length);
}

glm::dmat4 affine_matrix(const std::vector<double>& m, const JsonObject& owner) {
    glm::dmat4 result(1);
    for (int column = 0; column < 4; ++column) {
        const double* from = m.data() + std::ptrdiff_t{4} * column;
        const double last = column == 3 ? 1 : 0;
        if (!(std::abs(from[3] - last) < kAffineSlack))
            owner.fail("the last row of its matrix has " + std::to_string(from[3]), "0 0 0 1");
        result[column] = {from[0], from[1], from[2], last};
    }
    return result;
}

std::uint32_t GltfTree::add(std::uint32_t parent, const glm::dmat4& parent_from_node) {
    scene::AnimatedNode node;
    node.parent = parent;
    node.parent_from_node = parent_from_node;
    nodes.push_back(std::move(node));
    world_from_node.push_back(
        parent == scene::kNoNode ? parent_from_node : world_from_node[parent] * parent_from_node);
    return static_cast<std::uint32_t>(nodes.size() - 1);
}

GltfTree read_tree(const GltfDocument& document) {
    const auto children = children_of(document);
    const auto parents = parents_of(document, children);
    GltfTree tree;
    tree.number_of.assign(document.nodes.size(), scene::kNoNode);
    tree.is_hidden.assign(document.nodes.size(), false);
    const auto walk = [&](std::size_t root, bool is_in_scene) {
        std::vector<std::size_t> open{root};
        while (!open.empty()) {
            const std::size_t n = open.back();
            open.pop_back();
            const JsonObject& json = document.nodes[n];
            const bool has_parent = parents[n] != kNobody;
            const auto visibility = json.extension("KHR_node_visibility");
            tree.is_hidden[n] = (has_parent && tree.is_hidden[parents[n]]) ||
                                (visibility && !visibility->flag_or("visible", true));
            tree.number_of[n] = tree.add(has_parent ? tree.number_of[parents[n]] : scene::kNoNode,
                                         parent_from_node(json));
            if (is_in_scene) tree.in_scene.push_back(n);
            open.insert(open.end(), children[n].rbegin(), children[n].rend());
        }
    };
    for (const std::size_t root : scene_roots(document, parents))
        walk(root, true);
    // Bones may hang outside the scene.
    for (std::size_t n = 0; n < document.nodes.size(); ++n)
        if (parents[n] == kNobody && tree.number_of[n] == scene::kNoNode) walk(n, false);
    for (std::size_t n = 0; n < document.nodes.size(); ++n)
        if (tree.number_of[n] == scene::kNoNode)
            document.nodes[n].fail("it is below one of its own children", "a tree");
    return tree;
}

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
