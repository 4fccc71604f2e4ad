#include "truth/screen_line.h"

#include <algorithm>
#include <cmath>

namespace ink::truth {
namespace {

/// Keeps of [t0, t1] the part where the linear function with these end values is not negative.
/// False if nothing is left (Liang and Barsky 1984).
bool clip_to_positive(double at_0, double at_1, double& t0, double& t1) {
    if (at_0 >= 0 && at_1 >= 0) return true;
    if (at_0 < 0 && at_1 < 0) return false;
    const double root = at_0 / (at_0 - at_1);
    if (at_0 < 0) {
        t0 = std::max(t0, root);
    } else {
        t1 = std::min(t1, root);
    }
    return t0 < t1;
}

}  // namespace

double ScreenLine::segment_parameter(double s) const {
    const double along = s * w_begin / ((1 - s) * w_end + s * w_begin);
    return t_begin + along * (t_end - t_begin);
}

LinePoint ScreenLine::line_point(double s) const {
    const double t = segment_parameter(s);
    return {segment.edge,
            segment.a_world + t * (segment.b_world - segment.a_world),
            w_at(s),
            segment.crossing};
}

double ScreenLine::w_at(double s) const {
    return w_begin * w_end / ((1 - s) * w_end + s * w_begin);
}

CurvePoint ScreenLine::point_at(double s) const {
    return {begin_px.x + s * (end_px.x - begin_px.x),
            begin_px.y + s * (end_px.y - begin_px.y),
            w_at(s)};
}

WorldSegment segment_of(const EyeView& eye, std::uint32_t e) {
    const scene::Edge& edge = eye.model.topology.edges[e];
    const auto& p = eye.model.topology.p_world;
    return {e, nullptr, p[edge.a], p[edge.b], eye.p_clip[edge.a], eye.p_clip[edge.b]};
}

WorldSegment segment_of(const EyeView& eye, const Crossing& crossing) {
    const glm::dvec3 &a = crossing.begin_world, &b = crossing.end_world;
    return {kNoEdge, &crossing, a, b, eye.projection.to_clip(a), eye.projection.to_clip(b)};
}

std::optional<ScreenLine> clip_to_image(const EyeView& eye,
                                        const WorldSegment& segment,
                                        const ClassStretch& stretch) {
    const glm::dvec3& a = segment.a_clip;
    const glm::dvec3& b = segment.b_clip;
    double t0 = stretch.t_begin, t1 = stretch.t_end;
    const double width = eye.width_px, height = eye.height_px;
    if (!clip_to_positive(a.z - eye.near, b.z - eye.near, t0, t1) ||
        !clip_to_positive(a.x, b.x, t0, t1) ||
        !clip_to_positive(width * a.z - a.x, width * b.z - b.x, t0, t1) ||
        !clip_to_positive(a.y, b.y, t0, t1) ||
        !clip_to_positive(height * a.z - a.y, height * b.z - b.y, t0, t1)) {
        return std::nullopt;
    }
    const glm::dvec3 begin = t0 == 0 ? a : a + t0 * (b - a);
    const glm::dvec3 end = t1 == 1 ? b : a + t1 * (b - a);
    ScreenLine line{
        .segment = segment, .line_class = stretch.line_class, .t_begin = t0, .t_end = t1};
    line.w_begin = begin.z;
    line.w_end = end.z;
    line.begin_px = glm::dvec2(begin) / begin.z;
    line.end_px = glm::dvec2(end) / end.z;
    line.length_px = std::hypot(line.end_px.x - line.begin_px.x, line.end_px.y - line.begin_px.y);
    return line;
}

}  // namespace ink::truth
