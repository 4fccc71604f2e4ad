#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "buffers/hidden_lines.h"
#include "methods/edge_list/edge_builders.h"
#include "scene/prepared_scene.h"
#include "scene/scene.h"

namespace ink::methods {

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
