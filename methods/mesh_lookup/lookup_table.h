#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "methods/mesh_lookup/lookup_mesh.h"
#include "scene/prepared_scene.h"

namespace ink::methods {

/// Per face its word (side_lists.h), of codes per global triangle. What codes cannot tell is
/// flagged: a face at an edge of many, and both faces of an edge where codes and mesh disagree
/// whether it is a line.
[[nodiscard]] std::vector<std::uint32_t> lookup_words(const LookupMesh& mesh,
                                                      const std::vector<std::uint32_t>& codes);

/// What the shaders of surface_lookup and chords read, at default parameters but the crease.
struct LookupTable {
    static constexpr std::uint32_t kObject = 0x3fff;  ///< bits by which objects are told apart
    /// Corners and patch, and the twins of edges (Twin); the last has the face's code and flag in
    /// its upper nine bits, as its word, then its object, and in its lower nine 3 bits for the kind
    /// of each edge; of one of many faces 1 if it is flat from the front, and 2 if from the back.
    struct Face {
        std::array<std::uint32_t, 3> corners;
        std::uint32_t patch;
        std::array<std::uint32_t, 3> twins;
        std::uint32_t rest;
    };
    std::vector<Face> faces;
    std::vector<glm::vec4> p_world;      ///< the fourth is 1
    std::vector<std::uint32_t> corners;  ///< per point one that is there: 3 global index + 0..2
};

/// Throws core::Error where faces are too many for words.
[[nodiscard]] LookupTable lookup_table(const scene::PreparedScene& scene, double crease_deg);

}  // namespace ink::methods
