#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "truth/curve.h"
#include "truth/eye_scene.h"
#include "truth/eye_view.h"
#include "truth/truth.h"
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

/// The visible lines of a view and what finding them cost.
struct TracedLines {
    std::vector<Curve> curves;  ///< sorted by edge, then along it from a to b; then the crossings
    std::vector<Curve>
        hidden;  ///< what of the same lines is hidden, so sorted, if it was asked for
    std::size_t candidate_edges = 0;  ///< edges with a line inside the image
    std::size_t samples = 0;
    std::size_t rays = 0;
};

enum class Hidden { leave_out, keep };

/// Construction A: clips every feature edge and every crossing of two faces to near plane and
/// image, samples it at most 1/4 px apart and bisects each change of visibility (of a contour
/// also each change of what lies behind it) to 1/512 px. The same for every thread count. Throws
/// TooLarge once samples or rays exceed `trace.limits`, or where too many crossings were to be
/// found.
///
/// Hidden pieces have no kind. With the visible ones they are all of every line that is clipped.
[[nodiscard]] TracedLines trace_lines(const EyeView& eye,
                                      const EyeScene& scene,
                                      const TruthOptions& options,
                                      Hidden hidden = Hidden::leave_out);

}  // namespace ink::truth
