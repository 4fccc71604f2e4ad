#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "core/image.h"
#include "raster/depth/depth_image.h"
#include "raster/depth/polygon_offset.h"
#include "scene/camera.h"

namespace ink::raster {

/// A line from one vertex to another.
struct Line {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    /// Drawn there and back, as the edge between two triangles is: OpenGL leaves out the last pixel
    /// of each way only.
    bool is_both_ways = false;
};

/// Lines to draw over a frame. Borrowed for the length of the draw.
struct LineInput {
    std::span<const glm::dvec3> p_world;
    std::span<const Line> lines;  ///< into p_world
    scene::View view;
    double width_px = 1;  ///< drawn as line_width_px() of it
    /// Of the lines' own depth; its slope is the line's own, per step along its longer axis.
    PolygonOffset offset;
    int threads = 1;
    /// Lines behind all that is drawn where they run may be passed over; the image is the same.
    bool skips_hidden = true;
};

/// What a draw met.
struct LineCounts {
    std::uint64_t lines = 0;
    std::uint64_t hidden = 0;  ///< passed over: behind all that is there
};

/// The width that an aliased line is drawn with: to the nearest whole number (halves up), at least
/// 1, as OpenGL has it; at most 64.
[[nodiscard]] int line_width_px(double width_px);

/// Draws lines of any width as OpenGL does without antialiasing: see LineSteps for which pixels.
///
/// Depth is linear along the line's longer axis on the screen, taken at the centre of each step and
/// the same all across the width: so a line of width w lies at most (w/2) max(|dz/dx|, |dz/dy|)
/// deep in a plane that it runs in. The centre of the first and last step may lie beyond the line's
/// end by half a pixel, and its depth then does, too, as in OpenGL: a line that is short on the
/// screen and long in depth can stand out a good deal.
///
/// Kept from frame to frame, so that no frame allocates what an earlier one had.
class LinePass {
  public:
    LinePass();
    ~LinePass();

    /// Where a line is not behind `depth` (which says what the test's format is), `out` becomes
    /// 255; both have the view's size. The same image for every thread count. Vertices that are not
    /// finite take their lines with them.
    LineCounts draw(const LineInput& input,
                    const DepthImage& depth,
                    core::Image<std::uint8_t>& out);

  private:
    struct Scratch;
    std::unique_ptr<Scratch> scratch_;
};

}  // namespace ink::raster
