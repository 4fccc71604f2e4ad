#include "bake/edge_visibility.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "core/error.h"

namespace ink::bake {
namespace {

constexpr int kFloat = 5126, kVisibilityType = 5121;  // bytes

constexpr import::AccessorRule kPosition{"POSITION", "VEC3", import::kFloat | import::kSmall};

/// Outward normals of the triangles of a file, in object space, by their places in the scene.
class FileNormals {
  public:
    explicit FileNormals(const std::vector<BakedPrimitive>& primitives) : primitives_(primitives) {}

    /// Of length 1; 0 for a triangle without area, or of no primitive.
    [[nodiscard]] glm::dvec3 of(std::size_t scene_triangle) {
        const auto next = std::ranges::upper_bound(
            primitives_, scene_triangle, {}, &BakedPrimitive::first_triangle);
        if (next == primitives_.begin()) return glm::dvec3(0);
        const BakedPrimitive& primitive = *std::prev(next);
        const std::size_t t = scene_triangle - primitive.first_triangle;
        if (t >= primitive.triangles.size()) return glm::dvec3(0);
        // As the file had it: copied vertices are not in its accessors.
        auto& known = known_[&primitive];
        if (known.numbers.empty()) {
            import::GltfPrimitive source = primitive.source;
            known.numbers = source.numbers("POSITION", kPosition, 3);
            known.triangles = source.triangles();
        }
        const auto& [a, b, c] = known.triangles[t];
        const glm::dvec3 normal =
            glm::cross(known.place(b) - known.place(a), known.place(c) - known.place(a));
        const double length = glm::length(normal);
        return length > 0 ? normal / length : glm::dvec3(0);
    }

  private:
    struct Shape {
        std::vector<double> numbers;
        std::vector<scene::Triangle> triangles;
        [[nodiscard]] glm::dvec3 place(std::size_t vertex) const {
            return {numbers[3 * vertex], numbers[3 * vertex + 1], numbers[3 * vertex + 2]};
        }
    };

    const std::vector<BakedPrimitive>& primitives_;
    std::map<const BakedPrimitive*, Shape> known_;
};

/// The edges of a primitive's triangles in the order that these have in the baked file.
std::vector<std::array<std::uint32_t, 3>> edges_of(const BakedPrimitive& primitive,
                                                   const SceneEdges& edges) {
    std::vector<std::array<std::uint32_t, 3>> turned(primitive.triangles.size());
    for (std::size_t t = 0; t < turned.size(); ++t) {
        const auto& own = edges.of_triangle[primitive.first_triangle + t];
        for (std::size_t i = 0; i < 3; ++i)
            turned[t][i] = own[(i + primitive.turns[t]) % 3];
    }
    return turned;
}

void append(const glm::dvec3& normal, std::vector<float>& to) {
    for (int axis = 0; axis < 3; ++axis)
        to.push_back(static_cast<float>(normal[axis]));
}

/// Of the silhouette edges among the values, in their order.
std::vector<float> normals_of(const BakedPrimitive& primitive,
                              const std::vector<std::array<std::uint32_t, 3>>& own,
                              const std::vector<std::uint8_t>& values,
                              const SceneEdges& edges,
                              FileNormals& normals) {
    std::vector<float> numbers;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] != kSilhouette) continue;
        const KnownEdge& edge = edges.edges[own[i / 3][i % 3]];
        // The triangle's own normal comes first.
        const std::size_t triangle = primitive.first_triangle + i / 3;
        const bool is_second = edge.triangles[1] == triangle;
        glm::dvec3 one = normals.of(edge.triangles[is_second ? 1 : 0]);
        glm::dvec3 two = normals.of(edge.triangles[is_second ? 0 : 1]);
        if (edge.is_inconsistent) two = -two;
        if (one == glm::dvec3(0)) one = two == glm::dvec3(0) ? glm::dvec3(0, 0, 1) : two;
        if (two == glm::dvec3(0)) two = one;
        append(one, numbers);
        append(two, numbers);
    }
    return numbers;
}

}  // namespace

std::vector<std::uint8_t> edge_visibility(std::span<const std::array<std::uint32_t, 3>> triangles,
                                          std::span<const KnownEdge> edges) {
    std::vector<bool> is_known(edges.size(), false);
    std::vector<std::uint8_t> values;
    values.reserve(3 * triangles.size());
    for (const auto& triangle : triangles) {
        for (const std::uint32_t e : triangle) {
            if (e == SceneEdges::kNone || edges[e].kind == EdgeKind::hidden) {
                values.push_back(kHidden);
            } else if (edges[e].kind == EdgeKind::hard) {
                values.push_back(is_known[e] ? kHardAgain : kHard);
            } else {
                values.push_back(is_known[e] ? kHidden : kSilhouette);
            }
            if (e != SceneEdges::kNone) is_known[e] = true;
        }
    }
    return values;
}

std::vector<std::byte> packed_visibility(std::span<const std::uint8_t> values) {
    std::vector<std::byte> bytes((2 * values.size() + 7) / 8, std::byte{0});
    for (std::size_t i = 0; i < values.size(); ++i)
        bytes[i / 4] |= static_cast<std::byte>(values[i] << (2 * (i % 4)));
    return bytes;
}

bool has_edges(const BakedPrimitive& primitive) {
    return primitive.source.json().extension(import::kEdgeVisibility).has_value();
}

EdgeCounts add_edges(GltfEdit& edit,
                     const std::vector<BakedPrimitive>& primitives,
                     const SceneEdges& edges,
                     bool is_again) {
    EdgeCounts counts;
    FileNormals normals(primitives);
    for (const BakedPrimitive& primitive : primitives) {
        if (has_edges(primitive) && !is_again) {
            throw core::Error(
                primitive.place(),
                primitive.place() + ": it has edges of its own (" + import::kEdgeVisibility + ")",
                "a model without, or one that inkbench has baked");
        }
        const auto own = edges_of(primitive, edges);
        const std::vector<std::uint8_t> values = edge_visibility(own, edges.edges);
        counts.hard += static_cast<std::size_t>(std::ranges::count(values, kHard));
        if (std::ranges::all_of(values, [](auto value) { return value == kHidden; })) continue;
        const std::vector<std::byte> bytes = packed_visibility(values);
        Json extension = {
            {"visibility",
             edit.add_accessor({{"bufferView", edit.add_view(bytes, 0, GltfEdit::Use::other)},
                                {"componentType", kVisibilityType},
                                {"count", bytes.size()},
                                {"type", "SCALAR"}})}};
        const std::vector<float> pairs = normals_of(primitive, own, values, edges, normals);
        counts.silhouettes += pairs.size() / 6;
        if (!pairs.empty()) {
            const auto of_pairs = std::as_bytes(std::span(pairs));
            extension["silhouetteNormals"] =
                edit.add_accessor({{"bufferView", edit.add_view(of_pairs, 0, GltfEdit::Use::other)},
                                   {"componentType", kFloat},
                                   {"count", pairs.size() / 3},
                                   {"type", "VEC3"}});
        }
        edit.use_extension(import::kEdgeVisibility);
        primitive.json(edit)["extensions"][import::kEdgeVisibility] = std::move(extension);
    }
    return counts;
}

}  // namespace ink::bake
