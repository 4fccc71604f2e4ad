#include "import/gltf/meshes.h"

#include "import/gltf/primitive.h"

namespace ink::import {
namespace {

constexpr AccessorRule kPosition{"POSITION", "VEC3", kFloat | kSmall};
constexpr AccessorRule kNormal{"NORMAL", "VEC3", kFloat | kByte | kShort, true};
constexpr AccessorRule kJoints{"JOINTS", "VEC4", kUnsignedByte | kUnsignedShort};
constexpr AccessorRule kWeights{"WEIGHTS", "VEC4", kFloat | kUnsignedByte | kUnsignedShort, true};
constexpr AccessorRule kVisibility{"visibility", "SCALAR", kUnsignedByte};

/// Appends vectors for vertices that come after `before` others, which have zeros if they have
/// none.
void append(const std::vector<double>& numbers, std::size_t before, std::vector<glm::vec3>& to) {
    to.resize(before);
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        to.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
}

}  // namespace

void GltfMeshReader::add_influences(GltfPrimitive& attributes, GltfMesh& to) {
    const std::size_t first = to.influences.size();
    to.influences.resize(first + attributes.vertices());
    for (int set = 0;; ++set) {
        const std::string joints_name = "JOINTS_" + std::to_string(set);
        const std::string weights_name = "WEIGHTS_" + std::to_string(set);
        if (!attributes.has(joints_name.c_str()) && !attributes.has(weights_name.c_str())) {
            if (set == 0)
                attributes.attributes().fail("it has no JOINTS_0, and a node gives it a skin");
            return;
        }
        const auto joints = attributes.numbers(joints_name.c_str(), kJoints, 4);
        const auto weights = attributes.numbers(weights_name.c_str(), kWeights, 4);
        for (std::size_t i = 0; i < joints.size(); ++i) {
            if (weights[i] < 0) {
                attributes.attributes().fail(
                    weights_name + " of vertex " + std::to_string(i / 4) + " is below 0",
                    "0 or more");
            }
            if (weights[i] == 0) continue;  // whatever its joint is
            to.influences[first + i / 4].push_back(
                {static_cast<std::uint32_t>(joints[i]), static_cast<float>(weights[i])});
        }
    }
}

/// Takes the hard sides of the triangles from a number on: two bits a side, four sides a byte.
void GltfMeshReader::add_marks(const JsonObject& primitive,
                               std::size_t first_triangle,
                               ImportedMesh& to) {
    const auto extension = primitive.extension(kEdgeVisibility);
    if (!extension || !extension->has("visibility")) return;
    const std::size_t sides = 3 * (to.triangles.size() - first_triangle);
    const std::vector<double> bytes =
        accessors_.numbers(extension->index("visibility", accessors_.size()), kVisibility);
    if (bytes.size() != (sides + 3) / 4) {
        extension->fail("visibility has " + std::to_string(bytes.size()) + " elements",
                        std::to_string((sides + 3) / 4) + ", for " + std::to_string(sides) +
                            " sides of triangles");
    }
    to.marked_sides.resize(to.triangles.size(), 0);
    for (std::size_t i = 0; i < sides; ++i) {
        const unsigned value = static_cast<unsigned>(bytes[i / 4]) >> (2 * (i % 4)) & 3U;
        if (value == kHard || value == kHardAgain)
            to.marked_sides[first_triangle + i / 3] |= static_cast<std::uint8_t>(1U << i % 3);
    }
}

void GltfMeshReader::add_targets(const JsonObject& primitive, std::size_t vertices, GltfMesh& to) {
    const std::vector<JsonObject> targets = primitive.list("targets", "target");
    const bool is_first = to.mesh.positions.size() == vertices;
    if (is_first) to.targets.resize(targets.size());
    if (targets.size() != to.targets.size()) {
        primitive.fail("it has " + std::to_string(targets.size()) + " targets",
                       std::to_string(to.targets.size()) + ", as the mesh's other primitives");
    }
    const std::size_t before = to.mesh.positions.size() - vertices;
    for (std::size_t t = 0; t < targets.size(); ++t) {
        const auto add = [&](const AccessorRule& rule, std::vector<glm::vec3>& list) {
            const auto accessor = targets[t].find_index(rule.use, accessors_.size());
            if (!accessor) return;
            const std::vector<double> numbers = accessors_.numbers(*accessor, rule);
            if (numbers.size() != 3 * vertices) {
                targets[t].fail(std::string(rule.use) + " has " +
                                    std::to_string(numbers.size() / 3) + " elements",
                                std::to_string(vertices) + ", as the primitive");
            }
            append(numbers, before, list);
        };
        add(kPosition, to.targets[t].positions);
        add(kNormal, to.targets[t].normals);
    }
}

void GltfMeshReader::add_vertices(const JsonObject& primitive,
                                  GltfPrimitive& attributes,
                                  const std::vector<double>& p,
                                  GltfMesh& to) {
    const std::size_t before = to.mesh.positions.size();
    to.mesh.positions.reserve(before + p.size() / 3);
    for (std::size_t i = 0; i + 2 < p.size(); i += 3)
        to.mesh.positions.emplace_back(p[i], p[i + 1], p[i + 2]);
    to.mesh.are_floats = to.mesh.are_floats && accessors_.is_float(attributes.accessor("POSITION"));
    if (attributes.has("NORMAL"))
        append(attributes.numbers("NORMAL", kNormal, 3), before, to.mesh.normals);
    if (to.has_bones) add_influences(attributes, to);
    add_targets(primitive, attributes.vertices(), to);
}

/// The first vertex of an earlier primitive that has the very same ones: files that split a mesh by
/// material share them. Nothing if there is none.
std::optional<std::uint32_t> GltfMeshReader::shared_vertices(const JsonObject& primitive,
                                                             std::size_t position) const {
    const auto [first, last] = added_.equal_range(position);
    for (auto other = first; other != last; ++other) {
        const auto& [json, first_vertex] = other->second;
        if (primitive.is_same("attributes", json) && primitive.is_same("targets", json) &&
            !primitive.extension(kDracoMesh) && !json.extension(kDracoMesh))
            return first_vertex;
    }
    return std::nullopt;
}

void GltfMeshReader::add_primitive(const JsonObject& primitive,
                                   std::uint32_t number,
                                   GltfMesh& to) {
    if (!is_of_triangles(primitive)) {
        ++to.lines_left_out;
        return;
    }
    GltfPrimitive attributes(document_, buffers_, accessors_, primitive);
    if (!attributes.has("POSITION")) {
        ++to.empty_parts;
        return;
    }
    const std::size_t position = attributes.accessor("POSITION");
    const auto shared = shared_vertices(primitive, position);
    // Before the corners: their number is then known to be in the file.
    const auto p = shared ? std::vector<double>{} : attributes.numbers("POSITION", kPosition, 3);
    const std::vector<scene::Triangle> triangles = attributes.triangles();
    if (triangles.empty()) {
        ++to.empty_parts;
        return;
    }
    const auto first_vertex = shared.value_or(static_cast<std::uint32_t>(to.mesh.positions.size()));
    to.mesh.parts.push_back({.first_triangle = static_cast<std::uint32_t>(to.mesh.triangles.size()),
                             .material = static_cast<std::uint32_t>(
                                 primitive.find_index("material", document_.materials.size())
                                     .value_or(document_.materials.size())),
                             .primitive = number,
                             .first_vertex = first_vertex});
    for (const auto& [a, b, c] : triangles)
        to.mesh.triangles.push_back({a + first_vertex, b + first_vertex, c + first_vertex});
    add_marks(primitive, to.mesh.parts.back().first_triangle, to.mesh);
    if (shared) return;
    add_vertices(primitive, attributes, p, to);
    added_.emplace(position, std::pair(primitive, first_vertex));
}

GltfMesh GltfMeshReader::read_mesh(std::size_t index, bool has_bones) {
    const JsonObject& json = document_.meshes[index];
    GltfMesh result;
    result.has_bones = has_bones;
    added_.clear();
    result.mesh.name = json.text("name");
    result.mesh.are_floats = true;
    const std::vector<JsonObject> primitives = json.list("primitives", "primitive");
    for (std::size_t p = 0; p < primitives.size(); ++p)
        add_primitive(primitives[p], static_cast<std::uint32_t>(p), result);
    const auto fill = [&](std::vector<glm::vec3>& list) {
        if (!list.empty()) list.resize(result.mesh.positions.size());
    };
    fill(result.mesh.normals);
    if (!result.mesh.marked_sides.empty())
        result.mesh.marked_sides.resize(result.mesh.triangles.size(), 0);
    for (scene::Morph::Target& target : result.targets) {
        fill(target.positions);
        fill(target.normals);
        if (result.mesh.normals.empty()) target.normals.clear();
    }
    const auto weights = json.numbers("weights", result.targets.size());
    for (std::size_t t = 0; weights && t < result.targets.size(); ++t)
        result.targets[t].weight = (*weights)[t];
    return result;
}

}  // namespace ink::import
