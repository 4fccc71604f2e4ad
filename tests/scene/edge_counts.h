#pragma once

#include "scene/topology.h"

namespace ink::scene {

/// The edges of a topology that a closed solid has none of.
struct EdgeCounts {
    std::size_t boundary = 0;      ///< one face
    std::size_t nonmanifold = 0;   ///< more than two faces
    std::size_t inconsistent = 0;  ///< two faces that run through it in the same direction
};

inline EdgeCounts edge_counts(const Topology& topology) {
    EdgeCounts counts;
    for (const Edge& edge : topology.edges) {
        counts.boundary += edge.face_count == 1;
        counts.nonmanifold += edge.face_count > 2;
        counts.inconsistent += edge.face_count == 2 && !is_consistent(topology, edge);
    }
    return counts;
}

}  // namespace ink::scene
