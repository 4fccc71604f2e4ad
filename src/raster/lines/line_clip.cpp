#include "raster/lines/line_clip.h"

#include <algorithm>
#include <tuple>

#include "raster/pass/clip.h"
#include "raster/pass/screen_vertex.h"

namespace ink::raster {

bool clip_line(glm::dvec3& a, glm::dvec3& b, double near) {
    if (std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z)) return clip_line(b, a, near);
    double first = 0;
    double last = 1;
    bool is_cut_near[2] = {};
    for (int plane = 0; plane < kClipPlanes; ++plane) {
        const double from = inside_by(plane, a, near, kGuardBand_px);
        const double to = inside_by(plane, b, near, kGuardBand_px);
        if (from < 0 && to < 0) return false;
        if (from >= 0 && to >= 0) continue;
        const double t = from / (from - to);
        if (from < 0) first = std::max(first, t);
        if (to < 0) last = std::min(last, t);
        if (plane == 0) is_cut_near[from < 0 ? 0 : 1] = true;
    }
    if (!(first <= last)) return false;
    const glm::dvec3 way = b - a;
    const glm::dvec3 from = a;
    if (first > 0) a = from + first * way;
    if (last < 1) b = from + last * way;
    // Rounding must not leave a cut before the plane.
    if (is_cut_near[0]) a.z = std::max(a.z, near);
    if (is_cut_near[1]) b.z = std::max(b.z, near);
    return true;
}

}  // namespace ink::raster
