// Rong and Tan, "Jump flooding in GPU", I3D 2006; as wide outlines are drawn with it since.

#include "methods/jump_flood/jump_flood.h"

#include <algorithm>
#include <cmath>

namespace ink::methods {
namespace {

/// One pixel of a tile with two neighbours in line on either side of the border that is asked for.
struct Run {
    const std::uint32_t* id;
    const float* q;
    std::ptrdiff_t step;  ///< to the next pixel in line

    /// Whether a border runs between pixel 0 and the next: another id, or a jump of depth that is
    /// more than either side's slope by `depth_step` of the nearer.
    [[nodiscard]] bool has_border(float depth_step) const {
        if (id[0] != id[step]) return true;
        if (depth_step == 0 || id[0] == buffers::kNoId) return false;
        const float jump = std::abs(q[step] - q[0]);
        if (!(jump > depth_step * std::max(q[0], q[step]))) return false;
        // A slope is known only where the same surface goes on.
        const bool goes_back = id[-step] == id[0];
        const bool goes_on = id[2 * step] == id[0];
        if (!goes_back && !goes_on) return false;
        const float before = goes_back ? std::abs(q[0] - q[-step]) : 0;
        const float after = goes_on ? std::abs(q[2 * step] - q[step]) : 0;
        return jump - std::max(before, after) > depth_step * std::max(q[0], q[step]);
    }
};

class SeedSink : public raster::TileSink {
  public:
    SeedSink(double depth_step, buffers::Samples samples, core::Image<edge::NearestSeed>& seeds)
        : depth_step_(static_cast<float>(depth_step)), samples_(samples), seeds_(seeds) {}

    void finish(const raster::Tile& drawn) override {
        const raster::Tile tile =
            buffers::output_tile(drawn, seeds_.width_px(), seeds_.height_px());
        for (int y = 0; y < tile.height_px; ++y) {
            edge::NearestSeed* to = seeds_.row(tile.y0_px + y) + tile.x0_px;
            if (tile.is_empty) {
                std::fill_n(to, tile.width_px, edge::NearestSeed{});
            } else {
                finish_row(tile, y, to);
            }
        }
    }

  private:
    void finish_row(const raster::Tile& tile, int y, edge::NearestSeed* to) const {
        const std::uint32_t* id = tile.row<std::uint32_t>(0, y);
        const float* q = tile.depth_row<float>(y);
        const std::ptrdiff_t down = tile.stride;
        // The other two of the four borders that are asked: those to the pixels before, or the
        // sides of the square of corners that end at its lower right.
        const bool has_corners = samples_ == buffers::Samples::corner;
        const std::ptrdiff_t beside = has_corners ? down : -1;
        const std::ptrdiff_t above = has_corners ? 1 : -down;
        for (int x = 0; x < tile.width_px; ++x) {
            const bool is_seed = Run{id + x, q + x, 1}.has_border(depth_step_) ||
                                 Run{id + x + beside, q + x + beside, 1}.has_border(depth_step_) ||
                                 Run{id + x, q + x, down}.has_border(depth_step_) ||
                                 Run{id + x + above, q + x + above, down}.has_border(depth_step_);
            to[x] = {};
            if (is_seed)
                to[x] = {static_cast<std::int16_t>(tile.x0_px + x),
                         static_cast<std::int16_t>(tile.y0_px + y)};
        }
    }

    float depth_step_;
    buffers::Samples samples_;
    core::Image<edge::NearestSeed>& seeds_;
};

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        // Contours of objects alone.
        {{"of", "object"}, {"depth_step", "0"}},
        // What lies coplanar side by side in two objects is one.
        {{"of", "patch"}, {"depth_step", "0"}},
        // Ids alone: no contour within a patch.
        {{"depth_step", "0"}},
        // Contours of objects, and where an object hides part of itself.
        {{"of", "object"}},
        // Half of either pixel: as thin as seeds are.
        {{"width_px", "1"}, {"threshold", "127"}},
        // A pass more: rounder.
        {{"width_px", "4"}},
        // Blunter creases only.
        {{"crease_deg", "60"}},
        // Jumps within a patch at smaller and at larger steps.
        {{"depth_step", "0.05"}},
        {{"depth_step", "0.005"}},
        // Seeds one pixel wide, in the pixel that the border runs in.
        {{"samples", "corner"}},
        {},
    };
}

}  // namespace

core::ParamTable<JumpFlood::Params> JumpFlood::table() {
    core::ParamTable<Params> table;
    table.number(&Params::width_px, "width_px", {1, 64}, "px", "Width of the lines.");
    return buffers::add_id_params(table)
        .number(&Params::depth_step,
                "depth_step",
                {0, 1},
                "",
                "Jump of 1/distance within one id that is a border, over the nearer's; 0: none.")
        .number(
            &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
}

JumpFlood::JumpFlood(const Params& params) : buffers::IdMethod(params, 2), params_(params) {}

int JumpFlood::reach_px() const {
    return static_cast<int>(std::ceil(params_.width_px / 2)) - 1;
}

raster::SkipCounts JumpFlood::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    if (seeds_.width_px() != out.width_px() || seeds_.height_px() != out.height_px())
        seeds_ = core::Image<edge::NearestSeed>(out.width_px(), out.height_px());
    SeedSink sink(params_.depth_step, params_.samples, seeds_);
    // A line reaches into tiles where nothing moved: all are drawn.
    const raster::SkipCounts skips = pass().draw(frame, false, sink).skips;
    edge::jump_flood(seeds_, scratch_, reach_px(), frame.threads);
    edge::draw_round_seeds(seeds_, params_.width_px, out, frame.threads);
    return skips;
}

int JumpFlood::bytes_per_px() const {
    return pass().format().bytes_per_px() + 2 * static_cast<int>(sizeof(edge::NearestSeed));
}

method::Cost JumpFlood::cost() const {
    constexpr double kSeed_bytes = sizeof(edge::NearestSeed);
    method::Cost cost = pass().cost();
    cost.buffer_bytes_per_px = bytes_per_px();
    // Four borders: ids compared and joined; a difference, its size, the larger q, a product and a
    // comparison where depth is asked. Then a choice of seed or none.
    method::PixelWork seeds{2 * 4, kSeed_bytes, 4 + 3 + 1};
    if (params_.depth_step > 0) seeds.operations += 4 * 5;
    // Nine seeds: two differences, two squares, a sum, a comparison, a choice.
    const method::PixelWork pass{kSeed_bytes, kSeed_bytes, 9 * 7};
    // A square distance and its root, from half the width, cut at both ends, scaled, to a byte.
    const method::PixelWork line{kSeed_bytes, 1, 5 + method::kSlowOperations + 1 + 2 + 3};
    cost.filter = seeds + edge::jump_flood_passes(reach_px()) * pass + line;
    return cost;
}

method::MethodInfo jump_flood() {
    method::MethodInfo info = method::method_info<JumpFlood>(
        "jump_flood",
        "Rong and Tan, Jump flooding in GPU, I3D 2006; wide outlines as engines draw them",
        "borders of ids and depth, spread to any width by jump flooding");
    info.family = method::Family::ids;
    info.marker = method::Marker::square;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
