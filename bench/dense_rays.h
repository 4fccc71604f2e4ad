#pragma once

#include <cstddef>
#include <string>

#include "bench/ray_tree.h"

namespace ink::bench {

struct DenseCounts {
    std::size_t rays = 0;
    std::size_t mixed_px = 0;  ///< pixels in which more than one triangle, or the sky, is seen
    std::string hash;          ///< of which these are
};

/// A truth by brute force, as a renderer would make it: triangle ids of 16 x 16 rays a pixel.
class DenseRays {
  public:
    DenseRays(const scene::Scene& scene, const scene::View& view);

    /// 256 rays in every pixel.
    [[nodiscard]] DenseCounts cast_everywhere() const;

    /// One ray at each corner of the pixels, and the 256 only in pixels whose corners, with those
    /// of the eight pixels round them, do not all see one triangle.
    [[nodiscard]] DenseCounts cast_adaptive() const;

  private:
    [[nodiscard]] bool is_mixed(int x, int y) const;

    RayTree tree_;
    int width_px_;
    int height_px_;
};

}  // namespace ink::bench
