#pragma once

#include <array>
#include <cstdint>
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

/// A triangle of a scene and what lies across its edges: edge i joins corners i and (i + 1) % 3.
struct LookupFace {
    /// `beyond` of an edge of more than two faces.
    static constexpr std::uint32_t kMany = 0xfffffffeU;

    std::array<std::uint32_t, 3> vertices{};  ///< into LookupMesh::p_world
    std::array<std::uint32_t, 3> beyond{};    ///< a face, kNoNeighbour or kMany
    std::array<LineKind, 3> kinds{};          ///< what the edge is where both its faces are seen
    std::uint32_t object = 0;                 ///< instance
    std::uint32_t patch = 0;                  ///< a name: faces joined over edges that are no line
};

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
    std::vector<glm::dvec3> p_world;
    std::vector<LookupFace> faces;
    std::vector<ManyFaces> many;  ///< ascending
    /// Per global triangle its face, or that which it repeats; kNoNeighbour if it has no area.
    std::vector<std::uint32_t> face_of_triangle;
    std::vector<double> crack_world;     ///< per object: boundaries this near meet
    std::vector<double> rounding_world;  ///< per object: how far off its vertices may be as floats
};

/// Vertices at one place are one, over objects too. Boundaries that do not share their vertices
/// meet where both ends lie within `weld_epsilon`, if only two do; nothing is moved. O(n log n). An
/// empty scene gives an empty mesh.
[[nodiscard]] LookupMesh make_lookup_mesh(const scene::PreparedScene& scene,
                                          const LookupOptions& options);

/// By how much two faces that meet deviate from flat, 0..pi, each given by the ends of the edge as
/// it has them and its third corner.
[[nodiscard]] double deviation_rad(const std::array<glm::dvec3, 3>& one,
                                   const std::array<glm::dvec3, 3>& other);

}  // namespace ink::methods
