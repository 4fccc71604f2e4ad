#include "raster/pass/clip.h"

#include <algorithm>
#include <tuple>

#include "raster/pass/screen_vertex.h"

namespace ink::raster {
namespace {

bool comes_first(const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// The point of the edge on the plane; the same bits for (a, b) and (b, a).
ClipVertex cut(const ClipVertex& a, const ClipVertex& b, int plane, double near) {
    if (comes_first(b.p_clip, a.p_clip)) return cut(b, a, plane, near);
    const double from = inside_by(plane, a.p_clip, near, kGuardBand_px);
    const double t = from / (from - inside_by(plane, b.p_clip, near, kGuardBand_px));
    ClipVertex result;
    result.p_clip = a.p_clip + t * (b.p_clip - a.p_clip);
    // Exactly: rounding must not leave it before the plane. Nor must it at the other planes, where
    // an end may be so far away that the difference to the other has no digit of that one's w.
    result.p_clip.z = plane == 0 ? near : std::max(result.p_clip.z, near);
    for (std::size_t i = 0; i < kMaxPlanes; ++i)
        result.values[i] = a.values[i] + t * (b.values[i] - a.values[i]);
    return result;
}

ClipPolygon clip_at(const ClipPolygon& polygon, int plane, double near) {
    ClipPolygon result;
    const auto add = [&](const ClipVertex& v) {
        // Rounding could make a polygon slightly concave and cross a plane four times; the corner
        // too many lies within that rounding of another.
        if (result.count < ClipPolygon::kMaxCorners)
            result.corners[static_cast<std::size_t>(result.count++)] = v;
    };
    for (int i = 0; i < polygon.count; ++i) {
        const ClipVertex& from = polygon.corners[static_cast<std::size_t>(i)];
        const ClipVertex& to = polygon.corners[static_cast<std::size_t>((i + 1) % polygon.count)];
        const bool from_inside = inside_by(plane, from.p_clip, near, kGuardBand_px) >= 0;
        const bool to_inside = inside_by(plane, to.p_clip, near, kGuardBand_px) >= 0;
        if (from_inside) add(from);
        if (from_inside != to_inside) add(cut(from, to, plane, near));
    }
    if (result.count < 3) result.count = 0;
    return result;
}

}  // namespace

double inside_by(int plane, const glm::dvec3& p_clip, double near, double band_px) {
    if (plane == 0) return p_clip.z - near;
    const double along = plane <= 2 ? p_clip.x : p_clip.y;
    return band_px * p_clip.z + (plane % 2 == 1 ? along : -along);
}

ClipPolygon clip_triangle(const std::array<ClipVertex, 3>& triangle, double near) {
    ClipPolygon polygon;
    for (std::size_t i = 0; i < 3; ++i)
        polygon.corners[i] = triangle[i];
    polygon.count = 3;
    for (int plane = 0; plane < kClipPlanes && polygon.count > 0; ++plane)
        polygon = clip_at(polygon, plane, near);
    return polygon;
}

}  // namespace ink::raster
