#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "scene/camera.h"
#include "scene/clusters.h"
#include "scene/surface.h"

namespace ink::raster {

/// A hole of a solid that may let its inside be seen, as the eye sees it: the cone round the ball
/// that the hole's fan lies in, two pixels wider.
class Window {
  public:
    /// `pixel` is what a pixel at the image's centre measures at distance 1. Nothing if the eye is
    /// in the cone's ball.
    [[nodiscard]] static std::optional<Window> of(const scene::Sphere& ball,
                                                  const glm::dvec3& eye_world,
                                                  double pixel);

    /// Whether a sight line may meet the window, and then something in the ball.
    [[nodiscard]] bool may_show(const scene::Sphere& ball, const glm::dvec3& eye_world) const;

  private:
    glm::dvec3 axis_{0};
    double sine_ = 0;
    double cosine_ = 1;
    double nearest_ = 0;  ///< of the hole
};

/// The windows of a solid that is watertight when its holes are covered, of eyes outside its ball:
/// a covered hole whose fan is turned away lets nothing be seen. Nothing if a hole's ball holds the
/// eye.
[[nodiscard]] std::optional<std::vector<Window>> find_windows(const scene::Surface& surface,
                                                              const scene::Clusters& clusters,
                                                              const scene::Solid& solid,
                                                              const scene::View& view);

}  // namespace ink::raster
