#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "scene/camera.h"
#include "scene/surface.h"

namespace ink::scene {

struct Clusters;
struct FaceGraph;

/// A ring of edges of one solid that have one face each, and what would cover it: a fan of
/// triangles from a point at or near the mean of its corners, turned as the faces around it are.
struct Hole {
    std::uint32_t first_corner = 0;  ///< into Clusters::rims
    std::uint32_t corner_count = 0;  ///< at least 3
    glm::dvec3 apex_world{0};        ///< where the fan's triangles meet
    Sphere bounds;                   ///< of the fan, about its apex
    /// No face meets the fan, and it is not folded: what is seen through the hole is seen through a
    /// triangle of the fan that faces the eye. Else through anything in its ball.
    bool is_covered = false;
};

/// A solid with more holes than this is left open.
inline constexpr std::size_t kMostHoles = 16;

/// Finds the holes of a surface whose solids are numbered as `graph` has them, and which of them
/// belong to which: `holes`, `rims` and each solid's part of them.
///
/// A solid has none where one of its edges is neither a hole's nor shared by two faces that run
/// through it in opposite directions, where two holes meet in a corner, or where they are more than
/// kMostHoles.
void find_holes(const FaceGraph& graph, Clusters& clusters);

/// Six times the signed volume between a solid's faces and `origin_world`.
struct OpenVolume {
    glm::dvec3 origin_world{0};
    double six_volumes = 0;
};

/// Takes the apex and ball of a solid's holes from where its corners are now, and says whether the
/// solid is watertight once they are covered:
///
/// - no face of it meets the fan of a hole that is called covered, but for the corners and edges
///   that they share, and the fan is not folded: its area is at most twice that of its shadow;
/// - what lies outside the balls of the other holes hangs together;
/// - the covered solid is turned outwards, and holds twice the volume of all balls.
///
/// Where the solid's faces do not cross each other, a sight line from outside that misses the balls
/// of the holes that are not covered then meets the back of a face first only if it came in through
/// a fan's triangle that faces the eye. For the fans and those balls cut space into pockets and the
/// rest, and the faces outside the balls lie in the rest. There the covered solid winds k times
/// round what lies in front of a face and k + 1 times round what lies behind it, with the same k
/// for all, since they hang together. Infinity lies in the rest, so k is 0 or -1; and -1 would
/// leave no volume but that of the pockets. So the line has come in k + 1 = 1 times more than it
/// went out where it meets a back, and it met no face on its way.
[[nodiscard]] bool refresh_holes(const Surface& moved,
                                 std::uint32_t solid,
                                 const OpenVolume& volume,
                                 Clusters& clusters);

/// Whether some triangle of a hole's fan may be seen from its front: it is not surely turned away.
/// `rim` are the hole's corners in the surface.
[[nodiscard]] bool may_face(const Hole& hole,
                            std::span<const glm::dvec3> rim_world,
                            const Viewpoint& eye);

}  // namespace ink::scene
