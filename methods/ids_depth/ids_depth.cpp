// Surface ids and depth together, as outline passes that have both draw lines.

#include "methods/ids_depth/ids_depth.h"

#include <algorithm>
#include <cmath>

#include "buffers/packed_sink.h"
#include "buffers/sample_grid.h"

namespace ink::methods {
namespace {

/// A sample and how to reach those beside it.
struct Sample {
    const std::uint32_t* id;
    const float* q;  ///< 1 / distance, 0 for the sky

    /// Whether a border runs between this sample and that `step` away: another id, or a step of
    /// depth of more than `depth_step` of the nearer's 1 / distance.
    [[nodiscard]] bool has_border(std::ptrdiff_t step, float depth_step) const {
        if (id[0] != id[step]) return true;
        return depth_step > 0 && std::abs(q[step] - q[0]) > depth_step * std::max(q[0], q[step]);
    }
    /// Whether this sample owns such a border: the nearer does, the lower id if they are as near.
    [[nodiscard]] bool owns_border(std::ptrdiff_t step, float depth_step) const {
        if (!has_border(step, depth_step)) return false;
        return q[0] > q[step] || (q[0] == q[step] && id[0] < id[step]);
    }
};

class BorderSink : public raster::TileSink {
  public:
    BorderSink(const IdsDepth::Params& params, edge::EdgeImage& out)
        : params_(params), depth_step_(static_cast<float>(params.depth_step)), out_(out) {}

    void finish(const raster::Tile& drawn) override {
        if (drawn.is_empty) return buffers::clear_tile(drawn, out_);
        const raster::Tile tile = buffers::output_tile(drawn, out_.width_px(), out_.height_px());
        for (int y = 0; y < tile.height_px; ++y) {
            const auto* id = tile.row<std::uint32_t>(0, y);
            const auto* q = tile.depth_row<float>(y);
            std::uint8_t* to = out_.row(tile.y0_px + y) + tile.x0_px;
            for (int x = 0; x < tile.width_px; ++x)
                to[x] = is_line({id + x, q + x}, tile.stride) ? 255 : 0;
        }
    }

  private:
    [[nodiscard]] bool is_line(const Sample& at, std::ptrdiff_t down) const {
        if (params_.samples == buffers::Samples::corner) {
            const Sample across{at.id + 1 + down, at.q + 1 + down};
            return at.has_border(1, depth_step_) || at.has_border(down, depth_step_) ||
                   across.has_border(-1, depth_step_) || across.has_border(-down, depth_step_);
        }
        const auto asks = [&](std::ptrdiff_t step) {
            return params_.side == buffers::BorderSide::both ? at.has_border(step, depth_step_)
                                                             : at.owns_border(step, depth_step_);
        };
        return asks(1) || asks(-1) || asks(down) || asks(-down);
    }

    const IdsDepth::Params& params_;
    float depth_step_;
    edge::EdgeImage& out_;
};

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        // Objects and depth: no creases.
        {{"of", "object"}},
        // What lies coplanar side by side in two objects is one.
        {{"of", "patch"}},
        // Ids alone.
        {{"depth_step", "0"}},
        // Both sides of a border.
        {{"side", "both"}},
        // Blunter creases only.
        {{"crease_deg", "60"}},
        // Steps of depth at smaller and at larger ones.
        {{"depth_step", "0.03"}},
        {{"depth_step", "0.1"}},
        {{"depth_step", "0.2"}},
        // The line in the pixel that it runs in.
        {{"samples", "corner"}},
        {},
    };
}

}  // namespace

core::ParamTable<IdsDepth::Params> IdsDepth::table() {
    core::ParamTable<Params> table;
    return buffers::add_side_param(buffers::add_id_params(table))
        .number(&Params::depth_step,
                "depth_step",
                {0, 1},
                "",
                "Step of 1/distance within one id that is a border, over the nearer's; 0: none.")
        .number(&Params::threshold,
                "threshold",
                {1, 255},
                "",
                "Least edge response of a line pixel; it draws only 0 and 255.");
}

IdsDepth::IdsDepth(const Params& params) : buffers::IdMethod(params, 1), params_(params) {}

raster::SkipCounts IdsDepth::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    BorderSink sink(params_, out);
    return pass().draw_lines(frame, sink, out);
}

method::Cost IdsDepth::cost() const {
    method::Cost cost = pass().cost();
    // Four borders: ids compared and joined; a difference, its size, the larger q, a product and a
    // comparison where depth is asked.
    cost.filter = {sizeof(std::uint32_t), 1, 4 + 3};
    if (params_.depth_step > 0) cost.filter = cost.filter + method::PixelWork{4, 0, 4 * 5};
    return cost;
}

method::MethodInfo ids_depth() {
    method::MethodInfo info = method::method_info<IdsDepth>(
        "ids_depth",
        "id and depth buffers together, as outline passes of three.js and of engines have them",
        "a line wherever neighbours have other ids, or depth steps within one id");
    info.family = method::Family::ids;
    info.marker = method::Marker::right;
    info.tunables = {{"depth_step", {{0.001, 0.2}}}};
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
