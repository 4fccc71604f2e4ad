#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>

#include "truth/eye_scene.h"
#include "truth/eye_view.h"
#include "truth/truth.h"

namespace ink::truth {

/// A point of a line, and the mesh edge or the crossing it is a point of.
struct LinePoint {
    std::uint32_t edge = kNoEdge;  ///< kNoEdge on a crossing
    glm::dvec3 p_world{0};
    double w = 0;  ///< distance along the view direction
    const Crossing* crossing = nullptr;
    double noise_world = 0;  ///< how far off its line computing it may have put it
    double doubt_world = 0;  ///< how far rounding of vertices may have moved a point of a crossing
};

/// Of a few operations in double, relative.
inline constexpr double kRounding = 32 * std::numeric_limits<double>::epsilon();

/// How far off the line between two points rounding may put one that is computed to lie on it.
[[nodiscard]] double rounding_between(const glm::dvec3& a_world, const glm::dvec3& b_world);

/// The exact rule of visibility: a point of a line is visible if the open segment from the eye to
/// it meets no triangle except the line's own faces: those of the edge, or the two that cross.
///
/// Embree offers candidates along the segment and 1/2048 px beside it (even its robust mode lets a
/// ray slip between two triangles now and then); each is confirmed or dropped by exact predicates
/// on the segment itself. A triangle whose plane holds the point, or the eye, does not block. What
/// lies in front of the near plane is not there.
///
/// A crossing lies where the rounding of its two faces put it, so there a triangle's plane holds
/// the point if that leaves the side open. Such a triangle through the line is one more sheet of
/// the bundle: it hides the crossing where, to one side of it, it is nearer than the two faces, or
/// coincides with the nearer of them and is the lower; then the line is drawn once, as the crossing
/// of those that are seen.
class Visibility {
  public:
    Visibility(const EyeView& eye, const EyeScene& scene) : eye_(eye), scene_(scene) {}

    /// Whether the point is visible. `blocker` is tried first and set to the face that blocked:
    /// neighbouring points mostly hide behind the same one. `rays` counts up.
    [[nodiscard]] bool is_visible(const LinePoint& point,
                                  std::uint32_t& blocker,
                                  std::size_t& rays) const;

    /// The nearest face beyond a visible point on the line of sight, or touching it there, the
    /// edge's own faces left out; nothing before the sky. The distance is Embree's.
    [[nodiscard]] std::optional<EyeScene::Hit> first_behind(const LinePoint& point,
                                                            std::size_t& rays) const;

    /// One ray, which may slip by a surface that ends right behind the point, or five.
    enum class Look { quick, close };

    /// What lies behind a visible contour point: the object of `first_behind`. Where a scene is one
    /// object any face will do.
    [[nodiscard]] ContourKind kind_behind(const LinePoint& point,
                                          Look look,
                                          std::size_t& rays) const;

  private:
    [[nodiscard]] std::array<scene::SightLine, 4> beside(const LinePoint& point) const;
    [[nodiscard]] EyeRay beyond(const LinePoint& point) const;
    [[nodiscard]] std::uint32_t closely_behind(const LinePoint& point, std::size_t& rays) const;
    [[nodiscard]] double depth_of(std::uint32_t face, const LinePoint& point) const;
    [[nodiscard]] bool blocks(std::uint32_t face, const LinePoint& point) const;
    [[nodiscard]] bool is_behind(std::uint32_t face, const LinePoint& point) const;
    [[nodiscard]] int side_of_point(std::uint32_t face, const LinePoint& point) const;
    [[nodiscard]] bool is_touched_by(std::uint32_t face, std::uint32_t edge) const;
    [[nodiscard]] int side_of_crossing(std::uint32_t face, const LinePoint& point) const;
    [[nodiscard]] bool covers(std::uint32_t face, const LinePoint& point) const;
    [[nodiscard]] bool is_coplanar(std::uint32_t face0, std::uint32_t face1) const;
    [[nodiscard]] int side_by_ends(const LinePoint& point,
                                   double slack_world,
                                   const glm::dvec3& q,
                                   const glm::dvec3& r) const;
    [[nodiscard]] bool pierces(std::uint32_t face,
                               const LinePoint& point,
                               double slack_world = 0) const;
    [[nodiscard]] double doubt_of(std::uint32_t face, const LinePoint& point) const;
    [[nodiscard]] bool is_cut_away(std::uint32_t face, const LinePoint& point) const;
    [[nodiscard]] bool is_own(std::uint32_t face, const LinePoint& point) const;

    const EyeView& eye_;
    const EyeScene& scene_;
};

}  // namespace ink::truth
