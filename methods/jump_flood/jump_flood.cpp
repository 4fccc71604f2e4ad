// Rong and Tan, "Jump flooding in GPU", I3D 2006; as wide outlines are drawn with it since: borders
// of ids and of depth are seeds, and with steps 2^k, ..., 2, 1 each pixel takes the nearest of the
// seeds known at nine pixels. Then
//
//     edge response = 255 min(1, max(0, width_px / 2 - distance to the seed))

#include "edge/jump_flood.h"

#include <algorithm>
#include <cmath>

#include "buffers/each_tile.h"
#include "buffers/id_pass.h"

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

class JumpFlood : public buffers::IdMethod {
  public:
    struct Params : buffers::IdParams {
        double width_px = 2;
        double depth_step = 0.02;
        int threshold = 128;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table.number(&Params::width_px, "width_px", {1, 64}, "px", "Width of the lines.");
        buffers::add_id_params(table).number(
            &Params::depth_step,
            "depth_step",
            {0, 1},
            "",
            "Jump of 1/distance within one id that is a border, over the nearer's; 0: none.");
        return method::add_threshold(table);
    }
    explicit JumpFlood(const Params& params) : IdMethod(params, 2), params_(params) {}

    [[nodiscard]] int bytes_per_px() const override {
        return IdMethod::bytes_per_px() + 2 * static_cast<int>(sizeof(edge::NearestSeed));
    }

  private:
    /// How far from a seed a pixel may be in the line.
    [[nodiscard]] int reach_px() const {
        return static_cast<int>(std::ceil(params_.width_px / 2)) - 1;
    }
    void find_seeds(const raster::Tile& drawn) {
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
    void finish_row(const raster::Tile& tile, int y, edge::NearestSeed* to) const {
        const std::uint32_t* id = tile.row<std::uint32_t>(0, y);
        const float* q = tile.depth_row<float>(y);
        const std::ptrdiff_t down = tile.stride;
        const auto depth_step = static_cast<float>(params_.depth_step);
        // The other two of the four borders that are asked: those to the pixels before, or the
        // sides of the square of corners that end at its lower right.
        const bool has_corners = params_.samples == buffers::Samples::corner;
        const std::ptrdiff_t beside = has_corners ? down : -1;
        const std::ptrdiff_t above = has_corners ? 1 : -down;
        for (int x = 0; x < tile.width_px; ++x) {
            const bool is_seed = Run{id + x, q + x, 1}.has_border(depth_step) ||
                                 Run{id + x + beside, q + x + beside, 1}.has_border(depth_step) ||
                                 Run{id + x, q + x, down}.has_border(depth_step) ||
                                 Run{id + x + above, q + x + above, down}.has_border(depth_step);
            to[x] = {};
            if (is_seed)
                to[x] = {static_cast<std::int16_t>(tile.x0_px + x),
                         static_cast<std::int16_t>(tile.y0_px + y)};
        }
    }
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override {
        if (seeds_.width_px() != out.width_px() || seeds_.height_px() != out.height_px())
            seeds_ = core::Image<edge::NearestSeed>(out.width_px(), out.height_px());
        buffers::EachTile sink([&](const raster::Tile& tile) { find_seeds(tile); });
        // A line reaches into tiles where nothing moved: all are drawn.
        const raster::SkipCounts skips = pass().draw(frame, false, sink).skips;
        edge::jump_flood(seeds_, scratch_, reach_px(), frame.threads);
        edge::draw_round_seeds(seeds_, params_.width_px, out, frame.threads);
        return skips;
    }
    /// Seeds from ids and depth, an image of them for every step, and the line.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        constexpr double kSeed = sizeof(edge::NearestSeed);
        return method::PixelBytes{2 * 4 + kSeed, kSeed + 1} +
               edge::jump_flood_passes(reach_px()) * method::PixelBytes{kSeed, kSeed};
    }

    Params params_;
    core::Image<edge::NearestSeed> seeds_;
    core::Image<edge::NearestSeed> scratch_;
};

}  // namespace

method::MethodInfo jump_flood_method() {
    return method::method_info<JumpFlood>("jump_flood");
}

}  // namespace ink::methods
