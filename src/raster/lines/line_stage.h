#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "raster/depth/coarse_depth.h"
#include "raster/lines/line_pass.h"
#include "raster/pass/screen_vertex.h"

namespace ink::raster {

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

}  // namespace ink::raster
