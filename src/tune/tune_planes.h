#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image.h"
#include "edge/edge_image.h"
#include "harness/method_configs.h"
#include "harness/suite.h"
#include "linear_code/channel_planes.h"
#include "tune/tune_space.h"

namespace ink::tune {

/// Draws settings whose code is one linear sum without their method: from channel planes
/// (linear_code/channel_planes.h) that are made once per view and serve every set of weights.
///
/// Planes depend on what the code reads (normals, dihedral deviation, encoding, range,
/// interpolation) alone and are kept by that. An image of them is the method's but for pixels that
/// rounding decides, so it serves to choose among settings; what is reported is the method's.
class TunePlanes {
  public:
    /// Borrows the scenes.
    explicit TunePlanes(const std::vector<harness::SceneViews>& scenes) : scenes_(scenes) {}

    /// The next view of `scene_views`; `triangle` is what its pixels see (truth::Layers::triangle).
    void add_view(std::size_t scene_index,
                  const scene::View& view,
                  core::Image<std::uint32_t> triangle);

    /// Whether these settings can be drawn so: they declare a code that is the same in every scene,
    /// and a set of planes takes no more than a gigabyte. Hangs on no earlier call.
    [[nodiscard]] bool can_draw(const harness::MethodConfig& config) const;

    /// Whether it is worth it to search `space` so: none of its numbers makes new planes.
    [[nodiscard]] bool can_search(const harness::MethodConfig& config,
                                  const TuneSpace& space) const;

    /// The views' images, in the order in which they were added. can_draw() is the caller's duty.
    [[nodiscard]] std::vector<edge::EdgeImage> images(const harness::MethodConfig& config,
                                                      int threads);

  private:
    struct Seen {
        std::size_t scene_index = 0;
        scene::View view;
        core::Image<std::uint32_t> triangle;
    };
    struct PlaneSet {
        std::string key;  ///< what the code reads
        std::vector<linear_code::ChannelPlanes> views;
    };
    [[nodiscard]] std::size_t set_bytes() const;
    const PlaneSet& planes_of(const method::LinearCode& code, int threads);

    const std::vector<harness::SceneViews>& scenes_;
    std::vector<Seen> views_;
    std::vector<PlaneSet> kept_;  ///< the latest last
};

}  // namespace ink::tune
