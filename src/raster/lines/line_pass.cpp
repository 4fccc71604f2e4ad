#include "raster/lines/line_pass.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>
#include <tuple>
#include <vector>

#include "core/parallel.h"
#include "raster/depth/coarse_depth.h"
#include "raster/lines/line_steps.h"
#include "raster/lines/line_vertices.h"
#include "raster/pass/clip.h"
#include "raster/pass/screen_vertex.h"
#include "raster/pass/view_transform.h"

namespace ink::raster {
namespace {

/// Lines that are set up before they are drawn on one thread: they stay in the second-level cache.
constexpr std::size_t kChunkLines = 2048;
constexpr int kMostWidth_px = 64;

/// Rows [y0, y1) of the image.
struct Band {
    int y0 = 0;
    int y1 = 0;
};

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

/// A line on the screen, and the rows that it may touch.
struct ScreenLine {
    ScreenVertex a;
    ScreenVertex b;
    bool is_both_ways = false;
    int y0 = 0;
    int y1 = 0;
};

/// The vertices of lines, put on the screen once a frame.
struct LineVertices {
    std::vector<glm::dvec3> p_clip;
    std::vector<ScreenVertex> screen;  ///< of those with outcode kInside
    std::vector<std::uint8_t> outcodes;

    void project(const LineInput& input);
};

/// Puts lines on the screen; those that cannot be seen are dropped.
class LineStage {
  public:
    /// All borrowed. `blocks` null: no line is looked up there.
    LineStage(const LineInput& input,
              const LineVertices& vertices,
              const DepthImage& depth,
              const DepthBlocks* blocks);

    /// How many are hidden, as the blocks tell.
    [[nodiscard]] std::uint64_t run(std::span<const Line> lines,
                                    std::vector<ScreenLine>& out) const;

  private:
    /// Whether the line is on the screen; its rows are not told yet.
    [[nodiscard]] bool place(const Line& line, ScreenLine& placed) const;
    [[nodiscard]] bool is_hidden(const ScreenLine& line, const PixelRect& touched) const;

    const LineInput& input_;
    const LineVertices& vertices_;
    bool has_steps_;
    StepBits steps_;
    FloatBits floats_;
    const DepthBlocks* blocks_;
    OffsetRule rule_;
    int margin_px_;
};

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

struct LinePass::Scratch {
    struct Run {
        std::vector<ScreenLine> lines;
        std::uint64_t hidden = 0;
    };
    LineVertices vertices;
    DepthBlocks blocks;
    std::vector<Run> runs;
};

namespace {

/// Draws lines that are on the screen.
template <class Bits>
class LineFill {
  public:
    LineFill(const LineInput& input, const DepthImage& depth, core::Image<std::uint8_t>& out)
        : bits_(depth),
          rule_(input.offset, depth.format(), depth.near(), depth.far()),
          is_offset_(input.offset.is_any()),
          width_px_(line_width_px(input.width_px)),
          depth_(depth.bits()),
          out_(out) {}

    void draw(const ScreenLine& line, const Band& band) const {
        LineSteps steps(line.a, line.b, width_px_, line.is_both_ways);
        const bool is_x_major = steps.is_x_major();
        const int begin = std::max(steps.begin(), is_x_major ? 0 : band.y0);
        const int end = std::min(steps.end(), is_x_major ? out_.width_px() : band.y1);
        if (begin >= end) return;
        const Slope slope = slope_of(line, is_x_major);
        steps.start(begin);
        for (int step = begin; step < end; ++step, steps.advance()) {
            const double q = slope.q + slope.dq * (step + 0.5 - slope.from);
            const std::uint32_t bits = bits_.of(q);
            if (is_x_major) {
                fill_column(step, steps.first(), band, bits);
            } else {
                fill_row(step, steps.first(), bits);
            }
        }
    }

  private:
    /// q along the steps.
    struct Slope {
        double from;  ///< in px
        double q;     ///< there
        double dq;
    };

    [[nodiscard]] Slope slope_of(const ScreenLine& line, bool is_x_major) const {
        const double from = is_x_major ? line.a.x_px : line.a.y_px;
        const double to = is_x_major ? line.b.x_px : line.b.y_px;
        const double dq = (line.b.q - line.a.q) / (to - from);
        Slope slope{from, line.a.q, std::isfinite(dq) ? dq : 0};
        if (is_offset_)
            slope.q += rule_.depth_bias(std::abs(slope.dq), std::max(line.a.q, line.b.q));
        return slope;
    }

    void fill_column(int x, int first, const Band& band, std::uint32_t bits) const {
        const int y1 = std::min(first + width_px_, band.y1);
        for (int y = std::max(first, band.y0); y < y1; ++y)
            write(depth_.row(y)[x], out_.row(y)[x], bits);
    }
    void fill_row(int y, int first, std::uint32_t bits) const {
        const std::uint32_t* const depth = depth_.row(y);
        std::uint8_t* const out = out_.row(y);
        const int x1 = std::min(first + width_px_, out_.width_px());
        for (int x = std::max(first, 0); x < x1; ++x)
            write(depth[x], out[x], bits);
    }
    /// OpenGL's GL_LEQUAL.
    static void write(std::uint32_t depth, std::uint8_t& out, std::uint32_t bits) {
        if (bits >= depth) out = 255;
    }

    Bits bits_;
    OffsetRule rule_;
    bool is_offset_;
    int width_px_;
    const core::Image<std::uint32_t>& depth_;
    core::Image<std::uint8_t>& out_;
};

/// Draws all lines of all runs, in order, in bands of rows: each pixel belongs to one thread.
template <class Bits, class Runs>
void fill_bands(const LineInput& input,
                const Runs& runs,
                const DepthImage& depth,
                core::Image<std::uint8_t>& out) {
    const LineFill<Bits> fill(input, depth, out);
    const int height_px = out.height_px();
    const int bands = input.threads == 1 ? 1 : std::min(4 * input.threads, height_px);
    core::parallel_for(static_cast<std::size_t>(bands), input.threads, [&](std::size_t i) {
        const auto at = static_cast<int>(i);
        const Band band{at * height_px / bands, (at + 1) * height_px / bands};
        for (const auto& run : runs) {
            for (const ScreenLine& line : run.lines) {
                if (line.y0 < band.y1 && line.y1 > band.y0) fill.draw(line, band);
            }
        }
    });
}

}  // namespace

int line_width_px(double width_px) {
    const double nearest = std::floor(width_px + 0.5);
    return static_cast<int>(std::clamp(nearest, 1.0, static_cast<double>(kMostWidth_px)));
}

LinePass::LinePass() : scratch_(std::make_unique<Scratch>()) {}
LinePass::~LinePass() = default;

LineCounts LinePass::draw(const LineInput& input,
                          const DepthImage& depth,
                          core::Image<std::uint8_t>& out) {
    assert(depth.bits().width_px() == input.view.width_px);
    assert(depth.bits().height_px() == input.view.height_px);
    assert(out.width_px() == input.view.width_px && out.height_px() == input.view.height_px);
    assert(input.threads >= 1);
    LineCounts total{input.lines.size()};
    if (out.is_empty()) return total;

    Scratch& s = *scratch_;
    s.vertices.project(input);
    if (input.skips_hidden) s.blocks.find(depth.bits(), input.threads);
    const LineStage stage(input, s.vertices, depth, input.skips_hidden ? &s.blocks : nullptr);
    const std::size_t lines = input.lines.size();
    const std::size_t chunk = input.threads == 1 ? kChunkLines : std::max<std::size_t>(lines, 1);
    s.runs.resize(input.threads == 1 ? 1 : 4 * static_cast<std::size_t>(input.threads));
    for (std::size_t first = 0; first < lines; first += chunk) {
        const std::span<const Line> part =
            input.lines.subspan(first, std::min(chunk, lines - first));
        const std::size_t runs = s.runs.size();
        core::parallel_for(runs, input.threads, [&](std::size_t i) {
            Scratch::Run& run = s.runs[i];
            run.lines.clear();
            const std::size_t from = i * part.size() / runs;
            const std::size_t to = (i + 1) * part.size() / runs;
            run.hidden = stage.run(part.subspan(from, to - from), run.lines);
        });
        for (const Scratch::Run& run : s.runs)
            total.hidden += run.hidden;
        if (depth.format() == DepthFormat::q32) {
            fill_bands<FloatBits>(input, s.runs, depth, out);
        } else {
            fill_bands<StepBits>(input, s.runs, depth, out);
        }
    }
    return total;
}

}  // namespace ink::raster
