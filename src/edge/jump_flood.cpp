#include "edge/jump_flood.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "edge/row_bands.h"

namespace ink::edge {
namespace {

int first_step(int reach_px) {
    int step = 1;
    while (2 * step - 1 < reach_px)  // steps step, step / 2, ..., 1 reach so far together
        step *= 2;
    return step;
}

std::int64_t square_distance(const NearestSeed& seed, int x, int y) {
    if (seed.is_none()) return std::numeric_limits<std::int64_t>::max();
    const std::int64_t dx = seed.x - x;
    const std::int64_t dy = seed.y - y;
    return dx * dx + dy * dy;
}

void flood_row(const core::Image<NearestSeed>& from, int step, int y, NearestSeed* to) {
    const int width_px = from.width_px();
    // Rows beyond the image are its own once more, which adds nothing.
    const std::array<const NearestSeed*, 3> rows = {
        from.row(y >= step ? y - step : y),
        from.row(y),
        from.row(y + step < from.height_px() ? y + step : y)};
    for (int x = 0; x < width_px; ++x) {
        NearestSeed best;
        std::int64_t least = std::numeric_limits<std::int64_t>::max();
        for (const NearestSeed* row : rows) {
            for (const int at : {x - step, x, x + step}) {
                if (at < 0 || at >= width_px || row[at].is_none()) continue;
                const std::int64_t distance = square_distance(row[at], x, y);
                if (distance >= least) continue;
                least = distance;
                best = row[at];
            }
        }
        to[x] = best;
    }
}

}  // namespace

int jump_flood_passes(int reach_px) {
    int passes = 0;
    for (int step = reach_px > 0 ? first_step(reach_px) : 0; step > 0; step /= 2)
        ++passes;
    return passes;
}

void jump_flood(core::Image<NearestSeed>& nearest,
                core::Image<NearestSeed>& scratch,
                int reach_px,
                int threads) {
    assert(nearest.width_px() <= std::numeric_limits<std::int16_t>::max());
    assert(nearest.height_px() <= std::numeric_limits<std::int16_t>::max());
    if (reach_px <= 0 || nearest.is_empty()) return;
    if (scratch.width_px() != nearest.width_px() || scratch.height_px() != nearest.height_px())
        scratch = core::Image<NearestSeed>(nearest.width_px(), nearest.height_px());
    for (int step = first_step(reach_px); step > 0; step /= 2) {
        for_row_bands(nearest.height_px(), threads, [&](int y0, int y1) {
            for (int y = y0; y < y1; ++y)
                flood_row(nearest, step, y, scratch.row(y));
        });
        std::swap(nearest, scratch);
    }
}

void draw_round_seeds(const core::Image<NearestSeed>& nearest,
                      double width_px,
                      EdgeImage& out,
                      int threads) {
    assert(out.width_px() == nearest.width_px() && out.height_px() == nearest.height_px());
    for_row_bands(out.height_px(), threads, [&](int y0, int y1) {
        for (int y = y0; y < y1; ++y) {
            const NearestSeed* from = nearest.row(y);
            std::uint8_t* to = out.row(y);
            for (int x = 0; x < out.width_px(); ++x) {
                to[x] = 0;
                if (from[x].is_none()) continue;
                const double distance_px =
                    std::sqrt(static_cast<double>(square_distance(from[x], x, y)));
                const double inside = std::clamp(width_px / 2 - distance_px, 0.0, 1.0);
                to[x] = static_cast<std::uint8_t>(inside * 255 + 0.5);
            }
        }
    });
}

}  // namespace ink::edge
