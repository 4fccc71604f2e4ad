#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <memory>
#include <span>

#include "crosscheck/clip_mesh.h"

namespace ink::crosscheck {

/// What a sample sees.
struct Sight {
    std::uint32_t face = kNothing;  ///< into Topology::faces, kNothing for the sky
    double w = 0;                   ///< distance along the view direction, world units
};

/// Of the faces that a ray meets the one that is seen: the nearest, and of those in one plane with
/// it, as far as rounding can tell, the lowest.
class Foremost {
  public:
    /// Whether a face at this distance may be the one, or lie in its plane.
    [[nodiscard]] bool may_take(double w) const { return w <= nearest_.w * kAlmost; }
    void add(const ClipMesh& mesh, const Sight& sight);
    /// The face that is seen, at the distance of the nearest; sky if none was added.
    [[nodiscard]] const Sight& seen() const { return seen_; }

  private:
    static constexpr double kAlmost = 1 + 1e-5;  ///< farther off, no face lies in that plane
    Sight nearest_{kNothing, std::numeric_limits<double>::infinity()};
    Sight seen_;
};

/// Says which triangle is nearest behind a point of the image. Borrows the mesh.
class SightRays {
  public:
    /// A look may name a triangle that the point misses by `reach_px`.
    SightRays(const ClipMesh& mesh, double reach_px) : mesh_(mesh), reach_px_(reach_px) {}
    virtual ~SightRays() = default;
    SightRays(const SightRays&) = delete;
    SightRays& operator=(const SightRays&) = delete;

    /// The nearest triangle that holds the point and is not in front of the near plane there; of
    /// those in one plane with it, as far as rounding can tell, the lowest. Thread-safe.
    [[nodiscard]] virtual Sight look(const glm::dvec2& p_px) const = 0;
    /// The same at each of some points: quicker where those that follow each other lie close by.
    /// `sights` has one entry per point.
    virtual void look_at(std::span<const glm::dvec2> points_px, std::span<Sight> sights) const;

    [[nodiscard]] const ClipMesh& mesh() const { return mesh_; }
    [[nodiscard]] double reach_px() const { return reach_px_; }

  private:
    const ClipMesh& mesh_;
    double reach_px_;
};

/// Embree on float triangles in view space finds candidates near the front, and double arithmetic
/// in px decides among them. Where Embree names a neighbour that the point misses by at most
/// 1e-3 px, the surface is followed from there.
class EmbreeRays final : public SightRays {
  public:
    EmbreeRays(const ClipMesh& mesh, int threads);
    ~EmbreeRays() override;

    [[nodiscard]] Sight look(const glm::dvec2& p_px) const override;
    void look_at(std::span<const glm::dvec2> points_px, std::span<Sight> sights) const override;

    static constexpr int kPacket = 16;
    /// Looks at `sights.size()` (at most kPacket) points, 1 px apart along a row from `first_px`
    /// on. Quicker by far, but where surfaces lie nearer to each other than floats tell, any of
    /// them.
    void look_along(const glm::dvec2& first_px, std::span<Sight> sights) const;

  private:
    void look_at_packet(std::span<const glm::dvec2> points_px, std::span<Sight> sights) const;
    [[nodiscard]] float near() const;

    struct Handles;
    std::unique_ptr<Handles> handles_;
    double scale_ = 1;  ///< a power of two that brings the scene near 1
};

}  // namespace ink::crosscheck
