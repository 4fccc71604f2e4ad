#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "truth/embree.h"

namespace ink::bench {

/// A square of 4 x 4 rays, row by row.
inline constexpr int kPacketSide = 4;
inline constexpr int kPacket = kPacketSide * kPacketSide;
using PacketIds = std::array<std::uint32_t, kPacket>;

/// A scene in Embree's robust tree, looked at by coherent packets of 16 rays from a view's eye, on
/// one thread and without a filter: the fastest that Embree does this.
class RayTree {
  public:
    RayTree(const scene::Scene& scene, const scene::View& view);

    /// The global indices of the triangles seen by 4 x 4 rays from (x_px, y_px) on, `step_px` apart
    /// each way; 0xffffffff where there is sky.
    [[nodiscard]] PacketIds cast(double x_px, double y_px, double step_px) const;

  private:
    truth::embree::Handles handles_;
    float near_;
    glm::dvec3 corner_;  ///< the ray's direction at the image's top left corner ...
    glm::dvec3 right_;   ///< ... and what a pixel adds to it
    glm::dvec3 down_;
};

}  // namespace ink::bench
