#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "raster/mesh/mesh_pass.h"
#include "raster/pass/view_transform.h"
#include "scene/camera.h"
#include "scene/clusters.h"
#include "scene/surface.h"

namespace ink::raster {

/// A hole of a solid that may let its inside be seen, as the eye sees it: the cone round the ball
/// that the hole's fan lies in, two pixels wider; under a parallel camera, the cylinder.
class Window {
  public:
    /// `pixel` is what a pixel at the image's centre measures at distance 1, anywhere under a
    /// parallel camera. Nothing if the eye is in the cone's ball.
    [[nodiscard]] static std::optional<Window> of(const scene::Sphere& ball,
                                                  const scene::Viewpoint& eye,
                                                  double pixel);

    /// Whether a sight line may meet the window, and then something in the ball.
    [[nodiscard]] bool may_show(const scene::Sphere& ball, const scene::Viewpoint& eye) const;

  private:
    glm::dvec3 axis_{0};
    scene::Sphere wide_;  ///< of the hole, two pixels wider
    double sine_ = 0;
    double cosine_ = 1;
    double nearest_ = 0;  ///< of the hole
};

/// What a frame decides about each solid before any of its clusters is looked at.
struct SolidView {
    /// Watertight, with its holes covered at least, and seen from outside: a face turned away is
    /// never seen, but for sight lines through a window.
    bool hides_backs = false;
    std::vector<Window> windows{};
};

/// Looks at every solid once.
[[nodiscard]] std::vector<SolidView> view_solids(const MeshInput& input);

/// Into how many slices `threads` divide so many clusters to put them in order: one each, unless
/// that leaves too little in one to be worth waking a thread.
[[nodiscard]] std::size_t slice_count(std::size_t clusters, int threads);

/// The order in which clusters are drawn: those that face the eye before those that are turned away
/// but may be seen, each by the distance of their centres in coarse steps, as they come within one.
/// What lies behind is then mostly found hidden, and neighbours stay together.
struct ClusterOrder {
    std::vector<std::uint32_t> clusters;
    /// Per cluster, not in this order, 1 where it comes late: turned away, and not passed over.
    std::vector<std::uint8_t> is_late;
    /// The same, 1 where a face of it that is turned away is never seen: its solid hides its backs,
    /// and it lies behind no window.
    std::vector<std::uint8_t> hides_backs;
};
[[nodiscard]] ClusterOrder front_to_back(const MeshInput& input,
                                         const std::vector<SolidView>& solids);

/// The near plane and the sides of an image, a pixel outside it: what is snapped may move by a
/// part of one.
class ImageSides {
  public:
    ImageSides() = default;
    ImageSides(const ViewTransform& transform, const scene::View& view);

    /// Whether a ball lies beyond one of them, with room for rounding.
    [[nodiscard]] bool has_outside(const scene::Sphere& ball) const;

  private:
    ViewTransform transform_;
    double near_ = 0;
    double right_px_ = 0;
    double below_px_ = 0;
    double lengths_[4] = {};  ///< of the sides' normals: left, right, top, bottom
};

}  // namespace ink::raster
