#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "truth/curve.h"
#include "truth/eye_view.h"
#include "truth/visibility.h"

namespace ink::truth {

/// A segment in the world: a mesh edge, or a crossing of two faces.
struct WorldSegment {
    std::uint32_t edge = kNoEdge;        ///< kNoEdge for a crossing
    const Crossing* crossing = nullptr;  ///< null for an edge
    double noise_world = 0;              ///< as LinePoint has them
    double doubt_world = 0;
    glm::dvec3 a_world{0}, b_world{0};
    glm::dvec4 a_clip{0}, b_clip{0};  ///< as Projection::to_homogeneous has them
};

/// A stretch of a segment inside the image, parameterised by s in 0..1, uniform on the screen.
struct ScreenLine {
    WorldSegment segment;
    LineClass line_class = LineClass::none;
    double t_begin = 0, t_end = 1;          ///< parameters on the segment
    double h_begin = 0, h_end = 0;          ///< of Projection::to_homogeneous
    double depth_begin = 0, depth_end = 0;  ///< along the view direction
    glm::dvec2 begin_px{0}, end_px{0};
    double length_px = 0;

    /// The parameter on the segment s of the way along on the screen.
    [[nodiscard]] double segment_parameter(double s) const;
    /// What the eye is asked about at s.
    [[nodiscard]] LinePoint line_point(double s) const;
    [[nodiscard]] double depth_at(double s) const;
    [[nodiscard]] CurvePoint point_at(double s) const;
};

/// The edge as a segment.
[[nodiscard]] WorldSegment segment_of(const EyeView& eye, std::uint32_t edge);

/// The crossing as a segment, which borrows it.
[[nodiscard]] WorldSegment segment_of(const EyeView& eye, const Crossing& crossing);

/// The part of a stretch of `segment` beyond the near plane and inside the image; nothing if
/// there is none.
[[nodiscard]] std::optional<ScreenLine> clip_to_image(const EyeView& eye,
                                                      const WorldSegment& segment,
                                                      const ClassStretch& stretch);

}  // namespace ink::truth
