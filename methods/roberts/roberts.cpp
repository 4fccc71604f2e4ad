// Roberts' cross (1963) over a depth and a normal buffer, as outline passes of game engines have
// it.

#include "methods/roberts/roberts.h"

#include <algorithm>

#include "buffers/packed_sink.h"
#include "buffers/surface_cross.h"

namespace ink::methods {
namespace {

class RobertsSink : public raster::TileSink {
  public:
    RobertsSink(const Roberts::Params& params,
                const method::DepthCarrier& carrier,
                const raster::DepthRange& range,
                const scene::View& view,
                edge::EdgeImage& out)
        : params_(params), carrier_(carrier), range_(range), rays_(view), out_(out) {}

    void finish(const raster::Tile& tile) override;

  private:
    [[nodiscard]] float guarded(float step, float facing) const;

    const Roberts::Params& params_;
    const method::DepthCarrier& carrier_;
    const raster::DepthRange& range_;
    buffers::PixelRays rays_;
    edge::EdgeImage& out_;
};

/// A step of depth as a share of what the guard asks of it. The cosine takes a plane's own step
/// off: with f the focal length in px, r the ray and v its direction, 1/w changes by |n_x| / (f
/// n.r) of itself from one pixel to the next, which times n.v is at most 1 / f.
float RobertsSink::guarded(float step, float facing) const {
    switch (params_.guard) {
        case Roberts::Guard::none:
            return step;
        case Roberts::Guard::ramp: {
            const auto start = static_cast<float>(params_.guard_start);
            const float grazing = std::clamp((1 - facing - start) / (1 - start), 0.0F, 1.0F);
            return step / (1 + static_cast<float>(params_.guard_scale) * grazing);
        }
        case Roberts::Guard::cosine:
            break;
    }
    return step * facing - rays_.per_px();
}

void RobertsSink::finish(const raster::Tile& tile) {
    if (tile.is_empty) return buffers::clear_tile(tile, out_);
    buffers::TileFloats q_buffer;
    std::array<buffers::TileFloats, 3> normal_buffers;
    buffers::TileFloats facing;
    buffers::TileFloats depth_cross;
    buffers::TileFloats turn;
    const buffers::TilePlane q = buffers::inverse_distance(tile, carrier_, range_, q_buffer);
    const std::array<buffers::TilePlane, 3> normals =
        buffers::view_normals(tile, params_.renormalise, normal_buffers);
    buffers::facing_ratio(tile, normals, rays_, facing);
    buffers::half_cross(tile, q, depth_cross);
    buffers::normal_cross(tile, normals, turn);
    const float per_depth = 1 / static_cast<float>(params_.depth_step);
    const float per_turn = 1 / static_cast<float>(params_.normal_step);
    for (int y = 0; y < tile.height_px; ++y) {
        std::uint8_t* to = out_.row(tile.y0_px + y) + tile.x0_px;
        for (int x = 0; x < tile.width_px; ++x) {
            const buffers::CrossRange near = buffers::cross_range(q.row(y) + x, q.row(y + 1) + x);
            if (near.least == 0) {  // against the sky, which is at no distance
                to[x] = near.most > 0 ? 255 : 0;
                continue;
            }
            const float open = buffers::cross_range(facing.row(y) + x, facing.row(y + 1) + x).most;
            const float step = guarded(depth_cross.row(y)[x] / near.most, open);
            to[x] =
                buffers::strength_of_ratio(std::max(step * per_depth, turn.row(y)[x] * per_turn));
        }
    }
}

/// Depth as the interpolation carries it is 1/w or w: both tell the distance.
Roberts::Params with_distances(Roberts::Params params) {
    params.depth_encoding = params.interpolation == raster::Interpolation::affine
                                ? raster::DepthEncoding::inverse
                                : raster::DepthEncoding::linear;
    return params;
}

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        {},
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // No guard: what it is good for.
        {{"guard", "none"}, {"depth_step", "0.04"}, {"threshold", "72"}},
        // The guard of the tutorials.
        {{"guard", "ramp"}, {"depth_step", "0.01"}, {"threshold", "72"}},
        // Lines at smaller steps of depth.
        {{"depth_step", "0.001"}, {"threshold", "102"}},
        // Lines at larger ones only.
        {{"depth_step", "0.02"}, {"threshold", "64"}},
        // Sharper creases only.
        {{"normal_step", "0.4"}},
        // No smooth normals: what adjacency buys.
        {{"normals", "facet"}},
        // Normals and depth exact on the surface, at the price of a division.
        {{"interpolation", "perspective"}, {"renormalise", "true"}},
    };
}

}  // namespace

core::ParamTable<Roberts::Params> Roberts::table() {
    core::ParamTable<Params> table;
    table
        .number(&Params::depth_step,
                "depth_step",
                {1e-4, 1},
                "",
                "Least step of 1/distance that is a line, as a share of the nearer's.")
        .number(&Params::normal_step,
                "normal_step",
                {1e-3, 2},
                "",
                "Least change of the normal that is a line: 2 sin(a/2) for a crease of angle a.")
        .choice(&Params::guard,
                "guard",
                {"none", "ramp", "cosine"},
                "How the threshold on depth grows at grazing angles: not, by a ramp, by 1/|n.v|.")
        .number(&Params::guard_start,
                "guard_start",
                {0, 0.99},
                "",
                "1 - |n.v| from which on the ramp rises (guard = ramp).")
        .number(&Params::guard_scale,
                "guard_scale",
                {0, 100},
                "",
                "How many times more the ramp asks on edge (guard = ramp).");
    return buffers::add_surface_params(table).number(
        &Params::threshold, "threshold", {1, 255}, "", "Strength from which on a pixel is a line.");
}

Roberts::Roberts(const Params& params) : params_(with_distances(params)), buffers_(params_, 1) {}

void Roberts::draw(const method::Frame& frame, edge::EdgeImage& out) {
    skip_counts_ = {};
    if (buffers_.is_empty()) return out.fill(0);
    const method::DepthCarrier carrier = buffers_.see(frame);
    RobertsSink sink(params_, carrier, buffers_.range(), frame.view, out);
    skip_counts_ = buffers_.draw(frame, carrier, method::kNothingDrawn, sink, out);
}

method::Cost Roberts::cost() const {
    constexpr double kFloat_bytes = sizeof(float);
    method::Cost cost = buffers_.cost();
    method::PixelWork distance{
        kFloat_bytes, kFloat_bytes, 2 + 1 + 1};  // scaled, at least, sky told
    if (params_.interpolation == raster::Interpolation::perspective)
        distance.operations += method::kSlowOperations;
    method::PixelWork normals;
    if (params_.renormalise)
        normals = method::renormalise_work() + 3 * method::PixelWork{kFloat_bytes, kFloat_bytes, 0};
    method::PixelWork facing;
    if (params_.guard != Guard::none) {
        // n . r two products, two sums; |r| two squares, two sums, a root; a division. The largest
        // of four: a column's serves two pixels.
        facing = {3 * kFloat_bytes, kFloat_bytes, 4 + 1 + 4 + 2 * method::kSlowOperations + 2};
    }
    if (params_.guard == Guard::ramp) facing.operations += 6 + method::kSlowOperations;
    if (params_.guard == Guard::cosine) facing.operations += 2;
    const method::PixelWork cross{kFloat_bytes, 0, 2 + 2 + 1 + 1};
    // Squares, sums and a root; two steps against their thresholds, the larger; to a byte.
    const method::PixelWork join{
        0, 1, 3 + 2 + method::kSlowOperations + method::kSlowOperations + 2 + 3 + 1 + 4};
    cost.filter = distance + normals + facing + 4 * cross + join;
    return cost;
}

method::MethodInfo roberts() {
    method::MethodInfo info = method::method_info<Roberts>(
        "roberts",
        "Roberts 1963, as outline passes of engines run it on depth and normals today",
        "diagonal differences of depth and normal, with a guard against grazing angles");
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
