#include "import/gltf/primitive.h"

#include <limits>
#include <numeric>

namespace ink::import {
namespace {

enum Mode : std::uint64_t { kTriangles = 4, kStrip = 5, kFan = 6 };

std::uint64_t mode_of(const JsonObject& primitive) {
    return primitive.whole_or("mode", kFan, kTriangles);
}

/// The triangles that vertices in order make (glTF 2.0, section 3.7.2.1).
std::vector<scene::Triangle> triangles_of(const std::vector<std::uint32_t>& v, std::uint64_t mode) {
    std::vector<scene::Triangle> triangles;
    const std::size_t step = mode == kTriangles ? 3 : 1;
    for (std::size_t i = 0, t = 0; i + 2 < v.size(); i += step, ++t) {
        if (mode == kTriangles) triangles.push_back({v[i], v[i + 1], v[i + 2]});
        if (mode == kStrip) triangles.push_back({v[i], v[i + 1 + t % 2], v[i + 2 - t % 2]});
        if (mode == kFan) triangles.push_back({v[i + 1], v[i + 2], v[0]});
    }
    return triangles;
}

}  // namespace

bool is_of_triangles(const JsonObject& primitive) {
    return mode_of(primitive) >= kTriangles;
}

GltfPrimitive::GltfPrimitive(const GltfDocument& document,
                             GltfBuffers& buffers,
                             GltfAccessors& accessors,
                             const JsonObject& primitive)
    : accessors_(accessors),
      json_(primitive),
      attributes_(primitive.at("attributes")),
      packed_json_(primitive.extension(kDracoMesh)) {
    if (packed_json_) {
        const std::size_t view = packed_json_->index("bufferView", document.buffer_views.size());
        packed_.emplace(buffers.view(view), *packed_json_);
        buffers.count_bytes(packed_->vertex_count());
    }
    vertices_ = packed_           ? packed_->vertex_count()
                : has("POSITION") ? accessors_.count(accessor("POSITION"))
                                  : 0;
}

/// Whether Draco's stream has the attribute.
bool GltfPrimitive::is_packed(const char* name) const {
    if (!packed_) return false;
    if (packed_json_->at("attributes").has(name)) return true;
    if (!accessors_.json(accessor(name)).has("bufferView"))
        packed_json_->fail(std::string("its stream has no ") + name);
    return false;
}

std::vector<double> GltfPrimitive::unpacked(const char* name, std::size_t width) const {
    const std::uint64_t id =
        packed_json_->at("attributes").whole(name, std::numeric_limits<std::uint32_t>::max());
    return packed_->numbers(static_cast<std::uint32_t>(id), width);
}

void GltfPrimitive::check_count(const char* name, std::size_t elements) const {
    if (elements == vertices_) return;
    attributes_.fail(std::string(name) + " has " + std::to_string(elements) + " elements",
                     std::to_string(vertices_) + ", as POSITION");
}

std::vector<double> GltfPrimitive::numbers(const char* name,
                                           const AccessorRule& rule,
                                           std::size_t width) {
    const std::size_t from = accessor(name);
    if (is_packed(name)) {
        accessors_.check(from, rule);
        std::vector<double> numbers = unpacked(name, width);
        accessors_.normalise(from, numbers);
        return numbers;
    }
    std::vector<double> numbers = accessors_.numbers(from, rule);
    check_count(name, numbers.size() / width);
    return numbers;
}

std::vector<double> GltfPrimitive::components(const char* name) {
    const std::size_t from = accessor(name);
    const std::size_t width = accessors_.width(from);
    if (is_packed(name)) return unpacked(name, width);
    std::vector<double> components = accessors_.components(from);
    check_count(name, components.size() / width);
    return components;
}

std::vector<std::uint32_t> GltfPrimitive::corners() {
    if (packed_) return packed_->indices();
    const auto accessor = json_.find_index("indices", accessors_.size());
    if (!accessor) {
        std::vector<std::uint32_t> all(vertices_);
        std::iota(all.begin(), all.end(), 0U);
        return all;
    }
    std::vector<std::uint32_t> indices = accessors_.indices(*accessor);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] < vertices_) continue;
        json_.fail("index " + std::to_string(i) + " is " + std::to_string(indices[i]),
                   "below " + std::to_string(vertices_) + ", the vertices");
    }
    return indices;
}

std::vector<scene::Triangle> GltfPrimitive::triangles() {
    // Draco's triangles are ones, whatever the primitive's mode says they were.
    return triangles_of(corners(), packed_ ? std::uint64_t{kTriangles} : mode_of(json_));
}

}  // namespace ink::import
