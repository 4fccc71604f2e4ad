// Roberts' cross (1963) over a depth and a normal buffer, as outline passes of game engines have
// it.

#include "methods/roberts/roberts.h"

#include <algorithm>

namespace ink::methods {
namespace {

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
        // The cross over the pixel's own corners.
        {{"samples", "corner"}},
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
                "1 - |n.v| at which the ramp begins to rise (guard = ramp).")
        .number(
            &Params::guard_scale,
            "guard_scale",
            {0, 100},
            "",
            "How much the ramp adds to the threshold's factor at grazing angles (guard = ramp).");
    buffers::add_surface_params(table);
    return buffers::add_samples_param(table).number(
        &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
}

Roberts::Roberts(const Params& params)
    : buffers::FullBufferMethod(buffers::with_distances(params), 1), params_(params) {}

/// A step of depth as a share of what the guard asks of it. The cosine takes a plane's own step
/// off: with f the focal length in px, r the ray and v its direction, 1/w changes by |n_x| / (f
/// n.r) of itself from one pixel to the next, which times n.v is at most 1 / f.
float Roberts::guarded(float step, float facing, float per_px) const {
    switch (params_.guard) {
        case Guard::none:
            return step;
        case Guard::ramp: {
            const auto start = static_cast<float>(params_.guard_start);
            const float grazing = std::clamp((1 - facing - start) / (1 - start), 0.0F, 1.0F);
            return step / (1 + static_cast<float>(params_.guard_scale) * grazing);
        }
        case Guard::cosine:
            break;
    }
    return step * facing - per_px;
}

void Roberts::filter(const buffers::FullBufferFrame& frame,
                     const raster::Tile& tile,
                     edge::EdgeImage& out) const {
    buffers::TileFloats q_buffer;
    std::array<buffers::TileFloats, 3> normal_buffers;
    buffers::TileFloats facing;
    buffers::TileFloats depth_cross;
    buffers::TileFloats turn;
    const buffers::TilePlane q =
        buffers::inverse_distance(tile, frame.carrier, frame.range, q_buffer);
    const std::array<buffers::TilePlane, 3> normals =
        buffers::view_normals(tile, params_.renormalise, normal_buffers);
    buffers::facing_ratio(tile, normals, frame.rays, facing);
    buffers::half_cross(tile, q, depth_cross);
    buffers::normal_cross(tile, normals, turn);
    const float per_depth = 1 / static_cast<float>(params_.depth_step);
    const auto step_ratio = [&](int x, int y, const buffers::CrossRange& near) {
        const float open = buffers::cross_range(facing.row(y) + x, facing.row(y + 1) + x).most;
        const float step = depth_cross.row(y)[x] / near.most;
        return guarded(step, open, frame.rays.per_px()) * per_depth;
    };
    buffers::write_cross(tile, q, turn, params_.normal_step, step_ratio, out);
}

method::PixelWork Roberts::filter_work() const {
    constexpr double kFloat_bytes = sizeof(float);
    method::PixelWork facing;
    if (params_.guard != Guard::none) {
        // n . r two products, two sums; |r| two squares, two sums, a root; a division. The largest
        // of four: a column's serves two pixels.
        facing = {3 * kFloat_bytes, kFloat_bytes, 4 + 1 + 4 + 2 * method::kSlowOperations + 2};
    }
    if (params_.guard == Guard::ramp) facing.operations += 6 + method::kSlowOperations;
    if (params_.guard == Guard::cosine) facing.operations += 2;
    // Squares, sums and a root; two steps against their thresholds, the larger; to a byte.
    const method::PixelWork join{
        0, 1, 3 + 2 + method::kSlowOperations + method::kSlowOperations + 2 + 3 + 1 + 4};
    return buffers::inverse_distance_work(params_.interpolation) +
           buffers::view_normals_work(params_.renormalise) + facing +
           4 * buffers::half_cross_work() + join;
}

method::MethodInfo roberts() {
    method::MethodInfo info = method::method_info<Roberts>(
        "roberts",
        "Roberts 1963, as outline passes of engines run it on depth and normals today",
        "diagonal differences of depth and normal, with a guard against grazing angles");
    info.family = method::Family::full_buffers;
    info.marker = method::Marker::square;
    info.tunables = {
        {"depth_step", {{0.0001, 0.1}}}, {"normal_step", {{0.02, 1}}}, {"threshold", {{64, 255}}}};
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
