#include "import/gltf/meshes.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "import/gltf/draco_mesh.h"

namespace ink::import {
namespace {

constexpr AccessorRule kPosition{"POSITION", "VEC3", kFloat | kSmall};
constexpr AccessorRule kNormal{"NORMAL", "VEC3", kFloat | kByte | kShort, true};
constexpr AccessorRule kJoints{"JOINTS", "VEC4", kUnsignedByte | kUnsignedShort};
constexpr AccessorRule kWeights{"WEIGHTS", "VEC4", kFloat | kUnsignedByte | kUnsignedShort, true};

constexpr const char* kDraco = "KHR_draco_mesh_compression";

enum Mode : std::uint64_t { kTriangles = 4, kStrip = 5, kFan = 6 };

/// The corners of triangles that vertices in order make (glTF 2.0, section 3.7.2.1).
std::vector<scene::Triangle> triangles_of(const std::vector<std::uint32_t>& v,
                                          std::uint64_t mode,
                                          std::uint32_t first_vertex) {
    std::vector<scene::Triangle> triangles;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        triangles.push_back({v[a] + first_vertex, v[b] + first_vertex, v[c] + first_vertex});
    };
    const std::size_t step = mode == kTriangles ? 3 : 1;
    for (std::size_t i = 0, t = 0; i + 2 < v.size(); i += step, ++t) {
        if (mode == kTriangles) add(i, i + 1, i + 2);
        if (mode == kStrip) add(i, i + 1 + t % 2, i + 2 - t % 2);
        if (mode == kFan) add(i + 1, i + 2, 0);
    }
    return triangles;
}

/// Appends vectors for vertices that come after `before` others, which have zeros if they have
/// none.
void append(const std::vector<double>& numbers, std::size_t before, std::vector<glm::vec3>& to) {
    to.resize(before);
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        to.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
}

}  // namespace

/// The attributes of one primitive, from its accessors or from Draco's stream.
class GltfMeshReader::Attributes {
  public:
    Attributes(GltfMeshReader& reader, const JsonObject& primitive)
        : accessors_(reader.accessors_), json_(primitive.at("attributes")) {
        packed_json_ = primitive.extension(kDraco);
        if (packed_json_) {
            const std::size_t view =
                packed_json_->index("bufferView", reader.document_.buffer_views.size());
            packed_.emplace(reader.buffers_.view(view), *packed_json_);
            reader.buffers_.count_bytes(packed_->vertex_count());
        }
        vertices_ = packed_           ? packed_->vertex_count()
                    : has("POSITION") ? accessors_.count(accessor("POSITION"))
                                      : 0;
    }

    [[nodiscard]] const JsonObject& json() const { return json_; }
    [[nodiscard]] bool has(const char* name) const { return json_.has(name); }
    [[nodiscard]] std::size_t accessor(const char* name) const {
        return json_.index(name, accessors_.size());
    }
    [[nodiscard]] std::size_t vertices() const { return vertices_; }
    [[nodiscard]] const std::optional<DracoMesh>& packed() const { return packed_; }

    [[nodiscard]] std::vector<double> numbers(const char* name,
                                              const AccessorRule& rule,
                                              std::size_t width) {
        const std::size_t from = accessor(name);
        if (packed_ && packed_json_->at("attributes").has(name)) return unpacked(name, rule, width);
        if (packed_ && !accessors_.json(from).has("bufferView"))
            packed_json_->fail(std::string("its stream has no ") + name);
        std::vector<double> numbers = accessors_.numbers(from, rule);
        if (numbers.size() != vertices_ * width) {
            json_.fail(
                std::string(name) + " has " + std::to_string(numbers.size() / width) + " elements",
                std::to_string(vertices_) + ", as POSITION");
        }
        return numbers;
    }

  private:
    [[nodiscard]] std::vector<double> unpacked(const char* name,
                                               const AccessorRule& rule,
                                               std::size_t width) {
        const std::size_t from = accessor(name);
        accessors_.check(from, rule);
        const std::uint64_t id =
            packed_json_->at("attributes").whole(name, std::numeric_limits<std::uint32_t>::max());
        std::vector<double> numbers = packed_->numbers(static_cast<std::uint32_t>(id), width);
        accessors_.normalise(from, numbers);
        return numbers;
    }

    GltfAccessors& accessors_;
    JsonObject json_;
    std::optional<JsonObject> packed_json_;
    std::optional<DracoMesh> packed_;
    std::size_t vertices_ = 0;
};

std::vector<std::uint32_t> GltfMeshReader::corners(const JsonObject& primitive,
                                                   const Attributes& attributes) {
    if (attributes.packed()) return attributes.packed()->indices();
    const std::size_t vertices = attributes.vertices();
    const auto accessor = primitive.find_index("indices", accessors_.size());
    if (!accessor) {
        std::vector<std::uint32_t> all(vertices);
        std::iota(all.begin(), all.end(), 0U);
        return all;
    }
    std::vector<std::uint32_t> indices = accessors_.indices(*accessor);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] < vertices) continue;
        primitive.fail("index " + std::to_string(i) + " is " + std::to_string(indices[i]),
                       "below " + std::to_string(vertices) + ", the vertices");
    }
    return indices;
}

void GltfMeshReader::add_influences(Attributes& attributes, GltfMesh& to) {
    const std::size_t first = to.influences.size();
    to.influences.resize(first + attributes.vertices());
    for (int set = 0;; ++set) {
        const std::string joints_name = "JOINTS_" + std::to_string(set);
        const std::string weights_name = "WEIGHTS_" + std::to_string(set);
        if (!attributes.has(joints_name.c_str()) && !attributes.has(weights_name.c_str())) {
            if (set == 0) attributes.json().fail("it has no JOINTS_0, and a node gives it a skin");
            return;
        }
        const auto joints = attributes.numbers(joints_name.c_str(), kJoints, 4);
        const auto weights = attributes.numbers(weights_name.c_str(), kWeights, 4);
        for (std::size_t i = 0; i < joints.size(); ++i) {
            if (weights[i] < 0) {
                attributes.json().fail(
                    weights_name + " of vertex " + std::to_string(i / 4) + " is below 0",
                    "0 or more");
            }
            if (weights[i] == 0) continue;  // whatever its joint is
            to.influences[first + i / 4].push_back(
                {static_cast<std::uint32_t>(joints[i]), static_cast<float>(weights[i])});
        }
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
                                  Attributes& attributes,
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
            !primitive.extension(kDraco) && !json.extension(kDraco))
            return first_vertex;
    }
    return std::nullopt;
}

void GltfMeshReader::add_primitive(const JsonObject& primitive,
                                   std::uint32_t number,
                                   GltfMesh& to) {
    const std::uint64_t mode = primitive.whole_or("mode", kFan, kTriangles);
    if (mode < kTriangles) {
        ++to.lines_left_out;
        return;
    }
    Attributes attributes(*this, primitive);
    if (!attributes.has("POSITION")) {
        ++to.empty_parts;
        return;
    }
    const std::size_t position = attributes.accessor("POSITION");
    const auto shared = shared_vertices(primitive, position);
    // Before the corners: their number is then known to be in the file.
    const auto p = shared ? std::vector<double>{} : attributes.numbers("POSITION", kPosition, 3);
    const std::vector<std::uint32_t> v = corners(primitive, attributes);
    if (v.size() < 3) {
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
    // Draco's triangles are ones, whatever the primitive's mode says they were.
    const auto triangles =
        triangles_of(v, attributes.packed() ? std::uint64_t{kTriangles} : mode, first_vertex);
    to.mesh.triangles.insert(to.mesh.triangles.end(), triangles.begin(), triangles.end());
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
