#include "raster/lines/line_pass.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "raster/lines/line_stage.h"
#include "raster/lines/line_steps.h"

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

}  // namespace

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
LinePass::LinePass(LinePass&&) noexcept = default;
LinePass& LinePass::operator=(LinePass&&) noexcept = default;

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
