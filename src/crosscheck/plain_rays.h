#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "crosscheck/sight_rays.h"

namespace ink::crosscheck {

/// Sees without Embree: tries every triangle near a point, in double, with exact predicates for
/// what holds it. Slow, so for a few places alone.
class PlainRays final : public SightRays {
  public:
    /// Sorts the triangles that may be seen within kReach_px of `places_px` into their pixels.
    PlainRays(const ClipMesh& mesh, std::span<const glm::dvec2> places_px);

    static constexpr double kReach_px = 1.0 / 64;

    /// For points within kReach_px of a place; others see the sky.
    [[nodiscard]] Sight look(const glm::dvec2& p_px) const override;
    /// The triangles that may be seen in the pixel of a point, hidden ones too; none for pixels
    /// without a place.
    [[nodiscard]] std::span<const std::uint32_t> faces_near(const glm::dvec2& p_px) const;

  private:
    [[nodiscard]] bool is_met(std::uint32_t face, const glm::dvec3& ray) const;

    std::vector<std::uint64_t> pixels_;              ///< keys of those with a place, ascending
    std::vector<std::vector<std::uint32_t>> faces_;  ///< per pixel
};

}  // namespace ink::crosscheck
