#pragma once

#include <cstdint>

#include "core/image.h"
#include "edge/edge_image.h"

namespace ink::edge {

/// The pixel that a pixel knows as its nearest seed.
struct NearestSeed {
    static constexpr std::int16_t kNone = -1;

    std::int16_t x = kNone;
    std::int16_t y = kNone;

    [[nodiscard]] bool is_none() const { return x == kNone; }
    friend bool operator==(const NearestSeed&, const NearestSeed&) = default;
};

/// Spreads seeds: afterwards every pixel within `reach_px` of one knows its nearest, as jump
/// flooding finds it.
///
/// Seeds are the pixels that hold themselves; all others hold none. Passes with steps of powers of
/// two, down to 1, each looking at nine pixels; the first of equally near ones in rows wins. A seed
/// that is not the nearest may be kept where several cells meet, as is the algorithm's way: what is
/// found is a seed, and never nearer than the nearest. Sides at most 32767 px. `scratch` gets the
/// size of `nearest`; reach 0 does nothing. Rows are shared among `threads`; the same seeds for
/// every number of them.
///
/// Source: G. Rong and T.-S. Tan, "Jump flooding in GPU with applications to Voronoi diagram and
/// distance transform", I3D 2006.
void jump_flood(core::Image<NearestSeed>& nearest,
                core::Image<NearestSeed>& scratch,
                int reach_px,
                int threads = 1);

/// The number of passes that `reach_px` takes.
[[nodiscard]] int jump_flood_passes(int reach_px);

/// A line of `width_px` round the seeds, which are the pixels on either side of it: how much of it
/// a pixel at distance d from its nearest seed lies in, min(1, max(0, width / 2 - d)) times 255,
/// rounded. 0 where no seed is known.
///
/// Two pixels side by side are the seeds of a line between them: 2 px fill both, 1 px half of each.
void draw_round_seeds(const core::Image<NearestSeed>& nearest,
                      double width_px,
                      EdgeImage& out,
                      int threads = 1);

}  // namespace ink::edge
