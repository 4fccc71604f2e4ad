#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "crosscheck/dense_sampling.h"
#include "scene/camera.h"
#include "scene/topology.h"
#include "truth/line_class.h"

namespace ink::crosscheck {

inline constexpr std::uint32_t kNothing = 0xffffffffU;
inline constexpr double kReach_px = 1e-3;  ///< by so much a sample may miss the triangle it sees

/// A face as seen from a point of the image: (x, y) are px from there times w.
struct LocalFace {
    std::array<glm::dvec3, 3> p;
    std::array<double, 3> area{};  ///< of the point and edge i, signed: twice, times both w
    int orientation = 0;           ///< 1 counter-clockwise on a y-down image .. -1; 0 edge-on
};

/// How an edge looks from one face that has it: what is drawn there, and which face goes on.
struct Across {
    truth::LineClass line_class =
        truth::LineClass::none;     ///< contour and boundary: nothing goes on
    std::uint32_t face = kNothing;  ///< the face that goes on
};

/// How near a point must lie to a face for the surface to go on there, world units.
struct Closeness {
    double height = 0;  ///< above or below its plane
    double slack = 0;   ///< and, beside that, beyond its border
};

/// The mesh before one eye, in the cross-check's own arithmetic: clip space (x, y in px times w),
/// plain double.
class ClipMesh {
  public:
    /// Borrows the topology.
    ClipMesh(const scene::Topology& topology,
             const scene::View& view,
             const SamplingOptions& options);

    [[nodiscard]] const scene::Topology& topology() const { return topology_; }
    [[nodiscard]] const scene::Projection& projection() const { return projection_; }
    [[nodiscard]] const scene::View& view() const { return view_; }
    [[nodiscard]] const std::vector<glm::dvec3>& p_clip() const { return p_clip_; }
    /// Where a world point is on the image.
    [[nodiscard]] glm::dvec2 px(const glm::dvec3& p_world) const {
        const glm::dvec3 p = projection_.to_clip(p_world);
        return {p.x / p.z, p.y / p.z};
    }
    /// Per edge: whether a line may be drawn there, whichever way it is looked at.
    [[nodiscard]] bool is_feature(std::uint32_t edge) const {
        return kinds_[edge] != truth::LineClass::none;
    }

    [[nodiscard]] LocalFace local_face(std::uint32_t face, const glm::dvec2& p_px) const;
    /// The distance along the view direction at which the face is met from the point it is local
    /// to, made to lie within the face where the point misses it a little. Nothing (0) if it is
    /// behind.
    [[nodiscard]] static double depth(const LocalFace& face);
    /// The same of the face's whole plane; 0 or less where that is behind the eye or seen edge-on.
    [[nodiscard]] static double plane_depth(const LocalFace& face);
    /// Whether the point it is local to misses the face by at most `reach_px`.
    [[nodiscard]] static bool holds(const LocalFace& face, double reach_px);

    /// Whether the line through edge `side` passes within `reach_px` of that point.
    [[nodiscard]] static bool is_edge_near(const LocalFace& face,
                                           std::size_t side,
                                           double reach_px);

    /// What comes behind edge `side` (0..2) of `face`.
    [[nodiscard]] Across across(std::uint32_t face, std::size_t side) const;

    /// How far the surface bends where one face goes on from another, both turned to the eye.
    [[nodiscard]] double deviation_between(std::uint32_t face0, std::uint32_t face1) const;

    /// Whether a point lies as close to a face as that.
    [[nodiscard]] bool is_near(std::uint32_t face,
                               const glm::dvec3& p_world,
                               const Closeness& close) const;
    /// Whether `face` goes on, as close as that and flatter than a crease, where `from` ends at a
    /// point of its border.
    [[nodiscard]] bool goes_on(std::uint32_t from,
                               std::uint32_t face,
                               const glm::dvec3& p_world,
                               const Closeness& close) const;
    /// Whether two faces lie in one plane, as far as the rounding of their vertices can tell.
    [[nodiscard]] bool is_level(std::uint32_t face0, std::uint32_t face1) const;
    [[nodiscard]] bool is_seam(std::uint32_t face0, std::uint32_t face1) const;
    [[nodiscard]] double crease_rad() const { return crease_rad_; }
    /// By how much a surface may gape or overlap and still go on, at this distance along the view
    /// direction: the weld tolerance of the face's object, 1e-6 of the diagonal of the box round
    /// it, and no more than 1/64 px on the image; world units.
    [[nodiscard]] double tolerance(std::uint32_t face, double w) const;
    /// How far rounding to float may have moved any vertex of a face, world units.
    [[nodiscard]] double rounding(std::uint32_t face) const { return topology_.rounding_of(face); }

  private:
    /// Edges of two faces are judged once; those of more (nothing) where they are met.
    using EdgeKind = std::optional<truth::LineClass>;
    [[nodiscard]] EdgeKind kind_of(const scene::Edge& edge) const;
    /// Which side of the plane through eye and edge a face lies on: 1, -1, 0 in it.
    [[nodiscard]] int side_of(const scene::Edge& edge, std::uint32_t face) const;
    [[nodiscard]] truth::LineClass class_between(const scene::Edge& edge,
                                                 std::uint32_t face0,
                                                 std::uint32_t face1) const;
    /// Of the edge's faces on a side the one nearest the eye; kNothing if there is none.
    [[nodiscard]] std::uint32_t nearest_on(const scene::Edge& edge, int side) const;

    const scene::Topology& topology_;
    const scene::View& view_;
    scene::Projection projection_;
    double crease_rad_;
    scene::CreaseSource creases_;
    std::vector<double> tolerances_;  ///< per object
    std::vector<glm::dvec3> p_clip_;
    std::vector<std::int8_t> orientation_;  ///< per face, as LocalFace has it; exact
    std::vector<EdgeKind> kinds_;
};

}  // namespace ink::crosscheck
