#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "method/method.h"
#include "scene/camera.h"
#include "scene/surface.h"
#include "truth/truth.h"

namespace ink::harness {

struct DrawnTriangle;

/// What a declared code holds at a pixel.
struct PixelCode {
    /// What depth and the normal's x, y and z contribute, in code units, not rounded.
    std::array<double, 4> channels{};
    int code = 0;  ///< their sum, rounded, saturated or wrapped
};

/// A declared code, worked out from the truth instead of from an image: which triangle a pixel
/// centre sees is the truth's, depth and normal are the scene's, and the sum is as declared.
///
/// Borrows everything it is made of; for many threads at once.
class TruthCode {
  public:
    /// `surface` has the normals that `code` asks for, `bounds` is the scene's sphere.
    TruthCode(const scene::Surface& surface,
              const scene::Sphere& bounds,
              const scene::View& view,
              const method::LinearCode& code);

    /// The code of the pixel at (x, y) if it sees `triangle` (truth::kNoTriangle: sky).
    [[nodiscard]] PixelCode at(int x_px, int y_px, std::uint32_t triangle) const;

  private:
    struct Inputs;
    [[nodiscard]] Inputs inputs_at(int x_px, int y_px, std::uint32_t triangle) const;
    [[nodiscard]] Inputs interpolated(const DrawnTriangle& corners) const;
    [[nodiscard]] int limited(double sum) const;

    const scene::Surface& surface_;
    scene::Camera camera_;
    scene::Projection projection_;
    raster::DepthRange range_;
    const method::LinearCode& code_;
};

}  // namespace ink::harness
