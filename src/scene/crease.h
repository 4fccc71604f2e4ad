#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "scene/scene.h"
#include "scene/topology.h"

namespace ink::scene {

/// Which edges of two faces are creases.
enum class CreaseSource {
    angle,  ///< those where the faces deviate from flat by the crease angle or more
    file,   ///< those that the model's file marks as lines (Mesh::marked_sides)
};

/// "angle", "file": the spelling of options, files and columns.
inline constexpr std::array<std::string_view, 2> kCreaseSourceNames = {"angle", "file"};

struct CreaseRule {
    double angle_rad = 0;
    CreaseSource source = CreaseSource::angle;
};

/// Whether two faces at an edge of a welded scene crease. By file, two faces that are all that one
/// object has there crease if a side of theirs is marked; of other pairs files say nothing, and the
/// angle decides (precision/rounding.h).
[[nodiscard]] bool is_crease(const Topology& topology,
                             const Edge& edge,
                             std::uint32_t face0,
                             std::uint32_t face1,
                             const CreaseRule& rule);

/// A crease angle for a scene, in the gap between the bends of its curved surfaces and its creases.
struct CreaseProposal {
    double angle_rad = 0;
    double from_rad = 0;  ///< the gap
    double to_rad = 0;
};

/// The widest range of angles, as a ratio, within 8 to 60 degrees in which hardly any edge bends
/// and below which some do. Hardly any and some are a hundredth of the length of the edges of two
/// faces that bend at all (by 1 degree). The angle is the geometric mean of its ends, in whole
/// degrees; 40 where there is no such range.
///
/// The numbers come from CAD models whose edges are known (experiments/notes/cad_edges.md).
/// O(edges).
[[nodiscard]] CreaseProposal propose_crease(const Topology& topology);

/// Throws core::Error (where = the scene's name) if creases are to be the file's, and no mesh of
/// the scene has marks.
void check_creases(const Scene& scene, CreaseSource source);

}  // namespace ink::scene
