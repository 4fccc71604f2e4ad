#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/image.h"

namespace ink::shade {

/// Pixels of a line in order, as points of the image (px, pixel centres at +0.5).
struct LineChain {
    std::vector<glm::dvec2> points_px;  ///< two or more; a ring does not repeat its first
    bool is_closed = false;
};

/// The lines of a thinned mask (0 or 1 a pixel): from each end or fork to the next, then the rings.
///
/// Pixels are joined to their neighbours at the sides, and at the corners where no pixel at a side
/// joins the two already. Single pixels are no line. Each joint belongs to exactly one chain; the
/// order is that of rows.
[[nodiscard]] std::vector<LineChain> trace_chains(const core::Image<std::uint8_t>& thinned);

/// The chains cut where they turn by more than `corner_rad` within about `reach_px` points, so that
/// each piece can be drawn in one stroke. Pieces share the point they were cut at.
[[nodiscard]] std::vector<LineChain> cut_at_corners(const std::vector<LineChain>& chains,
                                                    double corner_rad,
                                                    int reach_px);

/// Points drawn towards the mean of their neighbours so often that the steps of a raster are gone:
/// as by a Gaussian of `sigma_px` points. Ends stay.
void smooth(LineChain& chain, double sigma_px);

}  // namespace ink::shade
