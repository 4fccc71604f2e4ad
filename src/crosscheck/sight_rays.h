#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>

#include "crosscheck/clip_mesh.h"

namespace ink::crosscheck {

/// What a sample sees.
struct Sight {
    std::uint32_t face = kNothing;  ///< into Topology::faces, kNothing for the sky
    double w = 0;                   ///< distance along the view direction, world units
};

/// Says which triangle is nearest behind a point of the image: Embree on float triangles in view
/// space finds candidates near the front, and double arithmetic in px decides among them.
///
/// Borrows the mesh. Thread-safe once built.
class SightRays {
  public:
    SightRays(const ClipMesh& mesh, int threads);
    ~SightRays();
    SightRays(const SightRays&) = delete;
    SightRays& operator=(const SightRays&) = delete;

    /// The nearest triangle that holds the point and is not in front of the near plane there; of
    /// those in one plane with it, as far as rounding can tell, the lowest. Where Embree names a
    /// neighbour that the point misses by at most 1e-3 px, the surface is followed from there.
    [[nodiscard]] Sight look(const glm::dvec2& p_px) const;

    [[nodiscard]] const ClipMesh& mesh() const { return mesh_; }

  private:
    struct Handles;
    const ClipMesh& mesh_;
    std::unique_ptr<Handles> handles_;
    double scale_ = 1;  ///< a power of two that brings the scene near 1
};

}  // namespace ink::crosscheck
