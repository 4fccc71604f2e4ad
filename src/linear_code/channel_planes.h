#pragma once

#include <array>
#include <cstdint>

#include "core/image.h"
#include "edge/edge_image.h"
#include "method/method.h"
#include "scene/scene.h"
#include "scene/surface.h"

namespace ink::linear_code {

/// What a linear code reads of one view, worked out once for every set of weights: where the truth
/// sees a surface, the four channels of 0..1 that weights multiply.
///
/// Images are of the view's size. Channel 0 is depth as the code encodes it (near = high), 1..3 the
/// view-space normal's x, y, z as (n+1)/2; all are 0 where there is sky. With weights
/// w = {depth_weight, normal_weight[0..2]} a pixel's code is
///
///     code = limit(floor(offset + w0 c0 + w1 c1 + w2 c2 + w3 c3 + 1/2)),   sky_code on sky,
///     L(x, y) = 4 code(x, y) - code(x-1, y) - code(x+1, y) - code(x, y-1) - code(x, y+1),
///
/// `limit` saturates or wraps at 2^bits, and edge::respond(L, response) is the pixel's edge
/// response: codes_of() and responses_of() below do just that. Without rounding and limit L is w .
/// v with v the Laplacians of the four channels, wherever offset and sky_code are 0.
struct ChannelPlanes {
    std::array<core::Image<float>, 4> channels;
    edge::Mask is_sky;  ///< 1 where nothing is seen

    [[nodiscard]] int width_px() const { return is_sky.width_px(); }
    [[nodiscard]] int height_px() const { return is_sky.height_px(); }
};

/// Makes the planes of a scene's views, never from a method's image: which triangle a pixel
/// centre sees is the truth's, depth and normals are the scene's (harness/truths/truth_code.h).
class ChannelSource {
  public:
    /// Of `code` only encoding and inputs are read; weights, offset and bits do not matter. Borrows
    /// the scene.
    ChannelSource(const scene::Scene& scene, const method::LinearCode& code);

    /// The planes of `view`, of whose pixels `triangle` (truth::Layers::triangle, the view's size)
    /// says what they see.
    [[nodiscard]] ChannelPlanes planes(const scene::View& view,
                                       const core::Image<std::uint32_t>& triangle) const;

  private:
    method::LinearCode unit_code_;  ///< weights of 1: its channels are the planes
    scene::Surface surface_;
    scene::Sphere bounds_;
};

/// The packed buffer that a code makes of the planes: rounded once, limited to its bits.
[[nodiscard]] core::Image<std::uint16_t> codes_of(const ChannelPlanes& planes,
                                                  const method::LinearCode& code);

/// What its filter makes of that: edge responses, 0 in the image's outermost pixels, whose stencils
/// the frame cuts.
[[nodiscard]] edge::EdgeImage responses_of(const ChannelPlanes& planes,
                                           const method::LinearCode& code);

}  // namespace ink::linear_code
