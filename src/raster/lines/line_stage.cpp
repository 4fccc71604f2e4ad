#include "raster/lines/line_stage.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/parallel.h"
#include "raster/lines/line_vertices.h"
#include "raster/pass/clip.h"
#include "raster/pass/view_transform.h"

namespace ink::raster {
namespace {

/// What of the segment from a to b, (x, y, w) in clip space, lies inside the near plane (w >= near)
/// and the guard band, in place. False: nothing does. Both must be finite (outcode without
/// kNotANumber). A cut is the same, bit for bit, from whichever end the segment is given. Liang and
/// Barsky 1984, "A new concept and method for line clipping".
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

}  // namespace

void LineVertices::project(const LineInput& input) {
    constexpr std::size_t kRun = 8192;
    const std::size_t count = input.p_world.size();
    p_clip.resize(count);
    screen.resize(count);
    outcodes.resize(count);
    const ViewTransform transform(input.view);
    core::parallel_for((count + kRun - 1) / kRun, input.threads, [&](std::size_t run) {
        const std::size_t first = run * kRun;
        project_vertices(transform,
                         input.view.camera.near,
                         input.p_world.data() + first,
                         std::min(count - first, kRun),
                         {p_clip.data() + first, screen.data() + first, outcodes.data() + first});
    });
}

LineStage::LineStage(const LineInput& input,
                     const LineVertices& vertices,
                     const DepthImage& depth,
                     const DepthBlocks* blocks)
    : input_(input),
      vertices_(vertices),
      has_steps_(depth.format() != DepthFormat::q32),
      steps_(depth),
      floats_(depth),
      blocks_(blocks),
      rule_(input.offset, depth.format(), depth.near(), depth.far()),
      // A pixel more than half the width on every side is enough for any rule.
      margin_px_(line_width_px(input.width_px) / 2 + 2) {}

std::uint64_t LineStage::run(std::span<const Line> lines, std::vector<ScreenLine>& out) const {
    std::uint64_t hidden = 0;
    const auto first = [&](std::int32_t p, std::int32_t q) {
        return std::max((std::min(p, q) >> kSubpixelBits) - margin_px_, 0);
    };
    const auto last = [&](std::int32_t p, std::int32_t q, int size_px) {
        return std::min((std::max(p, q) >> kSubpixelBits) + margin_px_ + 1, size_px);
    };
    for (const Line& line : lines) {
        ScreenLine placed;
        if (!place(line, placed)) continue;
        const ScreenVertex& a = placed.a;
        const ScreenVertex& b = placed.b;
        const PixelRect touched{first(a.x, b.x),
                                first(a.y, b.y),
                                last(a.x, b.x, input_.view.width_px),
                                last(a.y, b.y, input_.view.height_px)};
        if (touched.is_empty()) continue;
        if (blocks_ != nullptr && is_hidden(placed, touched)) {
            ++hidden;
            continue;
        }
        placed.y0 = touched.y0;
        placed.y1 = touched.y1;
        out.push_back(placed);
    }
    return hidden;
}

bool LineStage::place(const Line& line, ScreenLine& placed) const {
    const std::uint8_t a = vertices_.outcodes[line.from];
    const std::uint8_t b = vertices_.outcodes[line.to];
    if ((a & b) != 0 || ((a | b) & kNotANumber) != 0) return false;
    placed.is_both_ways = line.is_both_ways;
    if ((a | b) == kInside) {
        placed.a = vertices_.screen[line.from];
        placed.b = vertices_.screen[line.to];
        return true;
    }
    glm::dvec3 from = vertices_.p_clip[line.from];
    glm::dvec3 to = vertices_.p_clip[line.to];
    if (!clip_line(from, to, input_.view.camera.near)) return false;
    placed.a = to_screen(from);
    placed.b = to_screen(to);
    return true;
}

bool LineStage::is_hidden(const ScreenLine& line, const PixelRect& touched) const {
    const double along =
        std::max(std::abs(line.b.x_px - line.a.x_px), std::abs(line.b.y_px - line.a.y_px));
    // The longer axis of the snapped line may be the shorter one of the line itself by a rounding.
    const double slope = std::abs(line.b.q - line.a.q) / (along - 1.0 / kSubpixels);
    if (!(slope >= 0 && std::isfinite(slope))) return false;
    const double q_most = std::max(line.a.q, line.b.q);
    // Steps reach beyond the ends by half a pixel and what snapping moved.
    double q = q_most + 0.52 * slope;
    if (input_.offset.is_any())
        q += std::max(rule_.depth_bias(0, q_most), rule_.depth_bias(slope, q_most));
    q *= 1 + 1e-12;
    return blocks_->hides(touched, has_steps_ ? steps_.of(q) : floats_.of(q));
}

}  // namespace ink::raster
