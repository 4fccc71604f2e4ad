#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/topology.h"

namespace ink::truth {

/// A stretch of a boundary edge across which the surface goes on, though no vertices are shared:
/// a T-junction, a crack narrower than the weld tolerance, a flat overlap.
struct Continuation {
    std::uint32_t edge = 0;  ///< an edge of one face
    double t_begin = 0;      ///< the stretch is a + t (b - a), t_begin <= t <= t_end
    double t_end = 1;
    std::uint32_t face = 0;      ///< the face that goes on
    double gap_begin_world = 0;  ///< how far that face is from the edge where the stretch begins
    double gap_end_world = 0;    ///< and where it ends; in between no farther than in proportion
    glm::dvec3 into_world{0};    ///< unit: in that face, orthogonal to the edge, away from it
};

/// How near and how flat two faces must lie for the surface to go on from one to the other.
struct ContinuationOptions {
    std::span<const double> tolerances;  ///< of each object (scene::weld_tolerances)
    double crease_rad = 0;  ///< faces that bend by at least this do not continue each other
    int threads = 1;
};

/// Every stretch of a boundary edge from which another face goes on within the tolerance of the
/// edge's object, flatter than the crease angle, sorted by edge, then t_begin, then face.
///
/// A face goes on from a point of the edge if it holds a point beside it (two tolerances into the
/// face, orthogonal to the edge). So a face that meets the edge with its own border counts, and so
/// does one that runs on below it. Runs of stretches shorter than eight tolerances are contacts at
/// a corner and are left out; edges as short as that have none. Says nothing about any eye: whether
/// the two faces lie on different sides of the line of sight, and whether the gap can be seen, is
/// for the caller to find out.
///
/// O((faces + boundary edges) log(boundary edges)) plus the pairs whose boxes touch.
[[nodiscard]] std::vector<Continuation> find_continuations(const scene::Topology& topology,
                                                           const ContinuationOptions& options);

/// Those of one edge, from all of a topology.
[[nodiscard]] std::span<const Continuation> continuations_of(std::span<const Continuation> all,
                                                             std::uint32_t edge);

}  // namespace ink::truth
