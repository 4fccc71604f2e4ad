#pragma once

#include <cstddef>
#include <memory>

#include "scene/scene.h"

namespace ink::bench {

struct DenseCounts {
    std::size_t rays = 0;
    std::size_t mixed_px = 0;  ///< pixels in which more than one triangle, or the sky, is seen
};

/// A truth by brute force, as a renderer would make it: triangle ids of 16 x 16 rays a pixel, cast
/// in coherent packets of 16 against Embree's robust tree, nothing filtered. One thread.
class DenseRays {
  public:
    DenseRays(const scene::Scene& scene, const scene::View& view);
    ~DenseRays();
    DenseRays(const DenseRays&) = delete;
    DenseRays& operator=(const DenseRays&) = delete;

    /// 256 rays in every pixel.
    [[nodiscard]] DenseCounts cast_everywhere() const;

    /// One ray at each corner of the pixels, and the 256 only in pixels whose corners, with those
    /// of the eight pixels round them, do not all see one triangle.
    [[nodiscard]] DenseCounts cast_adaptive() const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace ink::bench
