#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/prepared_scene.h"
#include "scene/scene.h"

namespace ink::methods {

/// What a line shows; numbered as the labels of truth images, 0 where there is none. Of two in one
/// pixel the lower number wins.
enum class LineKind : std::uint8_t {
    none = 0,
    contour = 1,
    boundary = 2,
    crease = 3,
    intersection = 4,
    seam = 5,
};

/// Where there is no face: sky, or nothing beyond an edge.
inline constexpr std::uint32_t kNoNeighbour = 0xffffffffU;

/// What lies across an edge, in a word: the face beyond, which of its edges this is, and whether
/// both run along it the same way.
struct Twin {
    static constexpr std::uint32_t kTurned = 0x80000000U;
    static constexpr std::uint32_t kClosed = 0x40000000U;  ///< a line at rest, a crack, or no face
    static constexpr std::uint32_t kFace = 0x3ffffffcU;
    /// Faces that a word can tell apart.
    static constexpr std::uint32_t kMostFaces = 0x0ffffffeU;

    std::uint32_t word = kNoNeighbour;

    [[nodiscard]] static Twin of(std::uint32_t face, std::size_t edge) {
        return {face << 2 | static_cast<std::uint32_t>(edge)};
    }
    [[nodiscard]] static Twin of_many() { return {kNoNeighbour - 4}; }

    [[nodiscard]] bool is_nothing() const { return word == kNoNeighbour; }
    [[nodiscard]] bool is_many() const { return word == kNoNeighbour - 4; }
    /// Of an edge of two faces.
    [[nodiscard]] std::uint32_t face() const { return (word & kFace) >> 2; }
    [[nodiscard]] std::size_t edge() const { return word & 3; }
    [[nodiscard]] bool is_turned() const { return (word & kTurned) != 0; }
    [[nodiscard]] bool is_closed() const { return (word & kClosed) != 0; }
    /// Whether both faces are seen, one on each side of the edge, by which side of each is: 1 and
    /// -1, 0 edge-on. They face the same way.
    [[nodiscard]] bool is_open(int mine, int theirs) const {
        return mine != 0 && theirs == (is_turned() ? -mine : mine);
    }
};

/// A triangle of a scene and what lies across its edges: edge i joins corners i and (i + 1) % 3.
/// Half a cache line: reading it is what a look-up costs.
struct LookupFace {
    std::array<std::uint32_t, 3> vertices{};  ///< into LookupMesh::p_world
    std::array<Twin, 3> twins{};
    std::uint32_t patch = 0;          ///< a name: faces joined over edges that are no line
    std::array<LineKind, 3> kinds{};  ///< what the edge is where both its faces are seen
};
static_assert(sizeof(LookupFace) == 32);

/// How neighbours are found and told apart.
struct LookupOptions {
    double crease_rad = 0;    ///< dihedral deviation from which on an edge is a crease
    double weld_epsilon = 0;  ///< boundaries of an object this near meet, share of its diagonal
};

/// An edge of more than two faces, a < b, with one of them.
struct ManyFaces {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t face = 0;

    friend auto operator<=>(const ManyFaces&, const ManyFaces&) = default;
};

/// The table in which the line between two triangles is looked up: all faces of a scene, what they
/// border on, and what each of their edges is.
struct LookupMesh {
    /// Of a height over a plane in floats, as a share of what it is reckoned from: 16 roundings.
    static constexpr float kPlaneRounding = 1.0F / (1 << 20);
    static constexpr std::int8_t kInDoubt = 2;  ///< what such a height does not tell

    std::vector<glm::dvec3> p_world;
    std::vector<LookupFace> faces;       ///< along a Morton curve, vertices as faces come by them
    std::vector<std::uint32_t> objects;  ///< per face its instance
    std::vector<ManyFaces> many;         ///< ascending
    /// Per face the plane n p = d, the largest of n 1, by parts; all 0 where floats cannot tell it.
    /// Points count from `origin_world`, from which none is farther than `reach_world` / 4.
    std::array<std::vector<float>, 4> planes;
    glm::dvec3 origin_world{0};
    float reach_world = 0;
    /// Per global triangle its face, or that which it repeats; kNoNeighbour if it has no area.
    std::vector<std::uint32_t> face_of_triangle;
    std::vector<double> crack_world;      ///< per object: boundaries this near meet
    std::vector<double> tolerance_world;  ///< per object: scene::weld_tolerances

    /// Of length 1.
    [[nodiscard]] glm::dvec3 normal(std::uint32_t face) const {
        const auto& [a, b, c] = faces[face].vertices;
        return glm::normalize(glm::cross(p_world[b] - p_world[a], p_world[c] - p_world[a]));
    }
};

/// Vertices at one place are one, over objects too. Boundaries that do not share their vertices
/// meet where both ends lie within `weld_epsilon`, if only two do; nothing is moved. O(n log n). An
/// empty scene gives an empty mesh; one of more than Twin::kMostFaces faces throws core::Error.
[[nodiscard]] LookupMesh make_lookup_mesh(const scene::PreparedScene& scene,
                                          const LookupOptions& options);

}  // namespace ink::methods
