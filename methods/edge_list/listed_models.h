#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "buffers/hidden_lines.h"
#include "scene/mesh.h"
#include "scene/prepared_scene.h"
#include "scene/scene.h"

namespace ink::methods {

/// How the edges of a list of triangles are found.
enum class EdgeBuilder {
    all_pairs,  ///< each side of a triangle compared with every later one
    temp_list,  ///< CoRgi's: each side looked up among those whose mate has not come yet
    hash,       ///< the same, those kept in a hash table
};

/// The face that an edge does not have.
inline constexpr std::uint32_t kNoFace = 0xffffffffU;

/// An edge between two vertices, a < b, and its two faces in their order; of a boundary edge the
/// second is kNoFace.
struct ListedEdge {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::array<std::uint32_t, 2> faces{kNoFace, kNoFace};

    [[nodiscard]] bool is_boundary() const { return faces[1] == kNoFace; }
    friend bool operator==(const ListedEdge&, const ListedEdge&) = default;
};

/// What the inner loop did.
struct BuildCounts {
    std::uint64_t lookups = 0;      ///< sides of triangles: three a triangle
    std::uint64_t comparisons = 0;  ///< of one side with another
    std::uint64_t longest = 0;      ///< the most sides that were waiting for their mates at a time

    [[nodiscard]] double comparisons_per_lookup() const {
        return lookups == 0 ? 0 : static_cast<double>(comparisons) / static_cast<double>(lookups);
    }
};

struct EdgeListing {
    std::vector<ListedEdge> edges;  ///< in no order that matters
    BuildCounts counts;
};

/// The edges of `triangles`, whose equal corners have equal numbers.
///
/// A side's mate is the next one, in the order of triangles, between the same two vertices that has
/// none yet, whichever way either runs. So every builder gives the same edges, of any triangles: on
/// a closed 2-manifold each edge with its two faces; where three meet, the first two are an edge
/// and the third is a boundary one; of four, two and two.
///
/// With n sides all_pairs makes n (n-1) / 2 comparisons and never stops early; temp_list goes
/// through its list from the latest entry back until it finds the mate, which then leaves the list;
/// hash compares what it meets on its way to a slot. No triangle gives no edge.
[[nodiscard]] EdgeListing list_edges(std::span<const scene::Triangle> triangles,
                                     EdgeBuilder builder);

/// Which triangles find each other's edges.
enum class EdgeScope {
    object,  ///< those of one object, as a program that loads models one by one
    scene,   ///< all of them, equal world positions being one place
};

/// Who says which way a face turns.
enum class FacingRule {
    position,   ///< the eye's position, exactly
    direction,  ///< the view direction alone, as CoRgi had it: right at the image's centre only
};

/// Whether an edge between what is in front and what is edge-on is a contour.
enum class EdgeOnRule { leave_out, include };

/// The edge lists of a scene, where its vertices are, and what each edge is in a view.
class ListedModels {
  public:
    ListedModels(EdgeScope scope, EdgeBuilder builder, double crease_rad)
        : scope_(scope), builder_(builder), crease_rad_(crease_rad) {}

    /// Lists the edges: once per mesh, or over the whole scene.
    ///
    /// Throws core::Error (where = edge_list) if all_pairs would take minutes.
    void prepare(const scene::PreparedScene& scene);
    /// World positions, normals and creases. With EdgeScope::scene a scene that moved is listed
    /// anew.
    void pose(const scene::PreparedScene& scene);

    /// The edges that are a line from this camera, in no order that matters.
    [[nodiscard]] std::vector<buffers::KnownEdge> lines(const scene::Camera& camera,
                                                        FacingRule facing,
                                                        EdgeOnRule edge_on) const;

  private:
    struct List {
        std::vector<std::uint32_t> vertices;  ///< per place one of the mesh's, or of the surface's
        std::vector<scene::Triangle> faces;
        std::vector<ListedEdge> edges;
    };
    /// A list where one of its uses stands.
    struct Placed {
        std::shared_ptr<const List> list;
        std::uint32_t instance = 0;  ///< not looked at with EdgeScope::scene
        std::vector<glm::dvec3> p_world;
        std::vector<glm::dvec3> normals;      ///< per face, unit, world
        std::vector<std::uint8_t> is_crease;  ///< per edge
    };

    using Lists = std::vector<std::shared_ptr<const List>>;
    [[nodiscard]] std::shared_ptr<const List> build(
        const std::vector<glm::dvec3>& points, const std::vector<scene::Triangle>& triangles) const;
    [[nodiscard]] Lists build_all(const scene::PreparedScene& scene) const;
    void place(Placed& placed, const scene::PreparedScene& scene) const;
    static void append_lines(const Placed& placed,
                             const std::vector<std::int8_t>& facings,
                             EdgeOnRule edge_on,
                             std::vector<buffers::KnownEdge>& lines);

    EdgeScope scope_;
    EdgeBuilder builder_;
    double crease_rad_;
    std::vector<Placed> placed_;
    std::uint64_t listed_hash_ = 0;  ///< of the scene as it was listed
};

}  // namespace ink::methods
