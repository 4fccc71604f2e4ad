#include "truth/screen_line.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ink::truth {
namespace {

/// The sine of an angle; those that cross flatter may be moved much, but along both of them.
constexpr double kFlattest = 1.0 / 8;

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

/// How far the rounding of two faces may have moved the line in which they cross: the more, the
/// flatter they do.
double doubt_of(const scene::Topology& topology, const Crossing& crossing) {
    double rounding = 0;
    const auto normal_of = [&](std::uint32_t f) {
        rounding += topology.rounding_of(f);
        return glm::normalize(topology.area_vector(f));
    };
    const glm::dvec3 n0 = normal_of(crossing.face0), n1 = normal_of(crossing.face1);
    const double sine = glm::length(glm::cross(n0, n1));
    return crossing.error + rounding / std::max(sine, kFlattest);
}

}  // namespace

double ScreenLine::segment_parameter(double s) const {
    const double along = s * h_begin / ((1 - s) * h_end + s * h_begin);
    return t_begin + along * (t_end - t_begin);
}

LinePoint ScreenLine::line_point(double s) const {
    const double t = segment_parameter(s);
    return {segment.edge,
            segment.a_world + t * (segment.b_world - segment.a_world),
            depth_at(s),
            segment.crossing,
            segment.noise_world,
            segment.doubt_world};
}

double ScreenLine::depth_at(double s) const {
    // In perspective h is the depth, and 1/h linear on the screen; else the depth is.
    if (h_begin == depth_begin && h_end == depth_end)
        return h_begin * h_end / ((1 - s) * h_end + s * h_begin);
    return depth_begin + s * (depth_end - depth_begin);
}

CurvePoint ScreenLine::point_at(double s) const {
    return {begin_px.x + s * (end_px.x - begin_px.x),
            begin_px.y + s * (end_px.y - begin_px.y),
            depth_at(s)};
}

WorldSegment segment_of(const EyeView& eye, std::uint32_t e) {
    const scene::Edge& edge = eye.model.topology.edges[e];
    const auto& p = eye.model.topology.p_world;
    return {.edge = e,
            .noise_world = rounding_between(p[edge.a], p[edge.b]),
            .a_world = p[edge.a],
            .b_world = p[edge.b],
            .a_clip = eye.p_clip[edge.a],
            .b_clip = eye.p_clip[edge.b]};
}

WorldSegment segment_of(const EyeView& eye, const Crossing& crossing) {
    const glm::dvec3 &a = crossing.begin_world, &b = crossing.end_world;
    return {.crossing = &crossing,
            .noise_world = rounding_between(a, b),
            .doubt_world = doubt_of(eye.model.topology, crossing),
            .a_world = a,
            .b_world = b,
            .a_clip = eye.projection.to_homogeneous(a),
            .b_clip = eye.projection.to_homogeneous(b)};
}

std::optional<ScreenLine> clip_to_image(const EyeView& eye,
                                        const WorldSegment& segment,
                                        const ClassStretch& stretch) {
    const glm::dvec4& a = segment.a_clip;
    const glm::dvec4& b = segment.b_clip;
    double t0 = stretch.t_begin, t1 = stretch.t_end;
    const double width = eye.width_px, height = eye.height_px;
    if (!clip_to_positive(eye.behind_near(a), eye.behind_near(b), t0, t1) ||
        !clip_to_positive(a.x, b.x, t0, t1) ||
        !clip_to_positive(width * a.z - a.x, width * b.z - b.x, t0, t1) ||
        !clip_to_positive(a.y, b.y, t0, t1) ||
        !clip_to_positive(height * a.z - a.y, height * b.z - b.y, t0, t1)) {
        return std::nullopt;
    }
    const glm::dvec4 begin = t0 == 0 ? a : a + t0 * (b - a);
    const glm::dvec4 end = t1 == 1 ? b : a + t1 * (b - a);
    ScreenLine line{
        .segment = segment, .line_class = stretch.line_class, .t_begin = t0, .t_end = t1};
    line.h_begin = begin.z;
    line.h_end = end.z;
    line.depth_begin = eye.projection.depth_of(begin.z / begin.w);
    line.depth_end = eye.projection.depth_of(end.z / end.w);
    line.begin_px = glm::dvec2(begin) / begin.z;
    line.end_px = glm::dvec2(end) / end.z;
    line.length_px = std::hypot(line.end_px.x - line.begin_px.x, line.end_px.y - line.begin_px.y);
    return line;
}

}  // namespace ink::truth
