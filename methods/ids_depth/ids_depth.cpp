// Surface ids and depth together, as outline passes of engines and of three.js draw lines where
// they have an id buffer: a border between two neighbours is another id, or within one
//
//     |q1 - q0| > depth_step max(q0, q1),    q = 1 / distance

#include <algorithm>
#include <cmath>

#include "buffers/each_tile.h"
#include "buffers/id_pass.h"
#include "buffers/packed_sink.h"

namespace ink::methods {
namespace {

/// The least step of q = 1/distance that is a border: of_q q + constant.
struct DepthStep {
    bool is_asked;
    float of_q, constant;
};

/// A sample and how to reach those beside it.
struct Sample {
    const std::uint32_t* id;
    const float* q;  ///< 1 / distance, 0 for the sky

    /// Whether a border runs between this sample and that `step` away: another id, or a step of
    /// depth of more than `depth_step` of the nearer's 1 / distance.
    [[nodiscard]] bool has_border(std::ptrdiff_t step, const DepthStep& least) const {
        if (id[0] != id[step]) return true;
        return least.is_asked &&
               std::abs(q[step] - q[0]) > least.of_q * std::max(q[0], q[step]) + least.constant;
    }
    /// Whether this sample owns such a border: the nearer does, the lower id if they are as near.
    [[nodiscard]] bool owns_border(std::ptrdiff_t step, const DepthStep& least) const {
        if (!has_border(step, least)) return false;
        return q[0] > q[step] || (q[0] == q[step] && id[0] < id[step]);
    }
};

class IdsDepth : public buffers::IdMethod {
  public:
    struct Params : buffers::IdParams {
        buffers::BorderSide side = buffers::BorderSide::nearer;
        double depth_step = 0.05;  // found: see the page
        int threshold = 128;       ///< it draws 0 and 255 alone
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        buffers::add_side_param(buffers::add_id_params(table))
            .number(
                &Params::depth_step,
                "depth_step",
                {0, 1},
                "",
                "Step of 1/distance within one id that is a border, over the nearer's; 0: none.");
        return method::add_threshold_of_two(table);
    }
    explicit IdsDepth(const Params& params) : IdMethod(params, 1), params_(params) {}

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override {
        buffers::EachTile sink([&](const raster::Tile& tile) { draw_borders(tile, out); });
        return pass().draw_lines(frame, sink, out);
    }
    void draw_borders(const raster::Tile& drawn, edge::EdgeImage& out) const {
        if (drawn.is_empty) return buffers::clear_tile(drawn, out);
        const scene::DepthSlope slope =
            params_.depth_step * scene::Projection(pass().inputs().view()).q_per_distance();
        const DepthStep least{params_.depth_step > 0,
                              static_cast<float>(slope.of_q),
                              static_cast<float>(slope.constant)};
        const raster::Tile tile = buffers::output_tile(drawn, out.width_px(), out.height_px());
        for (int y = 0; y < tile.height_px; ++y) {
            const auto* id = tile.row<std::uint32_t>(0, y);
            const auto* q = tile.depth_row<float>(y);
            std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
            for (int x = 0; x < tile.width_px; ++x)
                to[x] = is_line({id + x, q + x}, tile.stride, least) ? 255 : 0;
        }
    }
    [[nodiscard]] bool is_line(const Sample& at,
                               std::ptrdiff_t down,
                               const DepthStep& least) const {
        if (params_.samples == buffers::Samples::corner) {
            const Sample across{at.id + 1 + down, at.q + 1 + down};
            return at.has_border(1, least) || at.has_border(down, least) ||
                   across.has_border(-1, least) || across.has_border(-down, least);
        }
        const auto asks = [&](std::ptrdiff_t step) {
            return params_.side == buffers::BorderSide::both ? at.has_border(step, least)
                                                             : at.owns_border(step, least);
        };
        return asks(1) || asks(-1) || asks(down) || asks(-down);
    }
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        return {params_.depth_step > 0 ? 8.0 : 4.0, 1};
    }

    Params params_;
};

}  // namespace

method::MethodInfo ids_depth_method() {
    return method::method_info<IdsDepth>("ids_depth");
}

}  // namespace ink::methods
