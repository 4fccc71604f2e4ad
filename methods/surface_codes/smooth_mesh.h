#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "buffers/id_pass.h"
#include "scene/prepared_scene.h"
#include "scene/scene.h"
#include "scene/topology.h"

namespace ink::methods {

/// Two faces at an edge.
struct FacePair {
    std::uint32_t face0 = 0;
    std::uint32_t face1 = 0;
    std::uint32_t edge = 0;  ///< into Topology::edges
};

/// A welded scene cut into smooth patches, and each patch's corners into fans.
///
/// A patch is what faces of one object reach over edges that bend by less than a crease: edges of
/// two faces; edges of more, where two go on over it with each other alone; and boundaries that lie
/// on each other. A fan is what corners at one vertex reach over edges that they share: the faces
/// of a patch that touch there.
struct SmoothMesh {
    static constexpr std::uint32_t kNone = 0xffffffffU;

    scene::Topology topology;
    std::vector<std::uint32_t> patch_of;  ///< per face; numbered by their first faces
    std::uint32_t patch_count = 0;
    std::vector<std::uint32_t> fan_of;  ///< per corner, which is 3 * face + i; numbered likewise
    std::uint32_t fan_count = 0;
    std::vector<std::uint32_t>
        across;  ///< per corner i: the face smoothly beyond edges[i], or kNone
    /// Pairs of faces that a line parts: at creases, seams, and edges of more than two faces.
    std::vector<FacePair> borders;
    /// Pairs of faces of a patch that touch along an edge which they do not share (T-junctions).
    std::vector<FacePair> touching;

    [[nodiscard]] std::size_t face_count() const { return patch_of.size(); }
    /// Which corner of a face lies at one of its vertices.
    [[nodiscard]] std::uint32_t corner_at(std::uint32_t face, std::uint32_t vertex) const {
        return 3 * face + scene::corner_at(topology.faces[face], vertex);
    }
};

/// O(n log n) for the weld, O(n) for the rest. An empty scene has no faces.
[[nodiscard]] std::shared_ptr<const SmoothMesh> make_smooth_mesh(
    const scene::PreparedScene& scene, const buffers::PatchOptions& options);

/// Per triangle of the scene the face that it is, or that it repeats, or that lies beside it where
/// welding left no area of it, or of all round it; kNone where nothing does. `mesh` is the scene's,
/// welded with that epsilon.
[[nodiscard]] std::shared_ptr<const std::vector<std::uint32_t>> faces_of_triangles(
    const scene::PreparedScene& scene, const SmoothMesh& mesh, double weld_epsilon);

}  // namespace ink::methods
