#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/keyed_lists.h"
#include "methods/surface_codes/smooth_mesh.h"

namespace ink::methods {

/// Surface distances are whole numbers of these: 1024 make a step, one unit of a code.
inline constexpr std::int32_t kStep = 1024;

/// What a way over the surface costs.
struct StepCosts {
    double turn_rad = 0;  ///< turning of the normal that costs a step, > 0
    /// Length that costs a step at least, world units, per face; empty: lengths cost nothing less.
    std::vector<float> length_world;
};

/// Ways between faces that touch in one patch: from face to fan to face, and over smooth edges.
/// Every one costs a step at most, and less where the surface hardly turns or is small.
///
/// Nodes are faces, then fans. A fan where a crease ends inside a patch lies on both sides of it:
/// such a slit end is no way, so that there the two sides are joined over smooth edges alone.
class SurfaceGraph {
  public:
    SurfaceGraph(const SmoothMesh& mesh, const StepCosts& costs);

    [[nodiscard]] std::size_t face_count() const { return mesh_.face_count(); }
    [[nodiscard]] std::size_t node_count() const { return face_count() + mesh_.fan_count; }
    [[nodiscard]] bool is_slit_end(std::uint32_t fan) const { return is_slit_end_[fan] != 0; }

    /// Makes every way cost a whole step round these fans: in the faces that touch there, and in
    /// those that touch these.
    void steepen(const std::vector<std::uint32_t>& fans);

    /// Calls visit(node, cost) for every way from a node, cost 0..kStep.
    template <class Visit>
    void for_each_way(std::uint32_t node, Visit visit) const {
        const auto faces = static_cast<std::uint32_t>(face_count());
        if (node >= faces) {
            const std::uint32_t fan = node - faces;
            for (const std::uint32_t corner : corners_of_.of(fan))
                visit(corner / 3, half_costs_[corner]);
            return;
        }
        for (std::uint32_t corner = 3 * node; corner < 3 * node + 3; ++corner) {
            const std::uint32_t fan = mesh_.fan_of[corner];
            if (is_slit_end_[fan] == 0) visit(faces + fan, half_costs_[corner]);
            if (mesh_.across[corner] != SmoothMesh::kNone)
                visit(mesh_.across[corner], edge_costs_[corner]);
        }
        if (touching_.empty()) return;
        for (const Touching& way : touching_.of(node))
            visit(way.face, way.cost);
    }

  private:
    /// A way over an edge that two faces do not share.
    struct Touching {
        std::uint32_t face = 0;
        std::int32_t cost = 0;
    };

    void find_slit_ends();
    void set_costs(const StepCosts& costs);
    void list_touching(const StepCosts& costs, const std::vector<glm::dvec3>& normals);

    const SmoothMesh& mesh_;
    std::vector<std::uint8_t> is_slit_end_;       ///< per fan
    core::KeyedLists<std::uint32_t> corners_of_;  ///< per fan, ascending
    std::vector<std::int32_t> half_costs_;  ///< per corner: face to fan or back, kStep / 2 at most
    std::vector<std::int32_t> edge_costs_;  ///< per corner: over the edge that begins there
    core::KeyedLists<Touching> touching_;   ///< per face
};

/// Lowers `keys`, one per node, to what can be reached: key of another node plus the cost of the
/// way from it. `sources` are nodes whose keys were set lower than their ways allow; all other keys
/// must be within the ways' costs of each other, or at the greatest number. Dial 1969.
void spread(const SurfaceGraph& graph,
            std::span<const std::uint32_t> sources,
            std::vector<std::int32_t>& keys);

/// Faces of one patch on either side of a crease that ends inside it, and how they were parted.
struct SlitCount {
    std::size_t edges = 0;   ///< creases with one patch on both sides, two steps apart by any way
    std::size_t parted = 0;  ///< of these, two whole steps or more apart
};

/// Makes ways steep round the ends of creases that are too short to be parted: there, and two faces
/// round, every way costs a whole step.
void steepen_short_slits(const SmoothMesh& mesh, SurfaceGraph& graph);

/// Per face how far it lies from an end of its patch, in units of kStep: from what lies farthest
/// from the patch's first face.
///
/// Across a crease inside a patch, where
/// the distance may be the same on both sides, one side is lifted: by as little as parts them by
/// two steps, and all round it by as much as its ways allow. In rounds, since what is lifted may
/// come level with something else; the round that parts most counts, and `rounds` 0 lifts nothing.
/// Between the ends of a way distances never differ by more than its cost.
[[nodiscard]] std::vector<std::int32_t> surface_distance(const SmoothMesh& mesh,
                                                         const SurfaceGraph& graph,
                                                         int rounds,
                                                         SlitCount* slits = nullptr);

}  // namespace ink::methods
