#include "methods/plane_distance/plane_distance.h"

namespace ink::methods {
namespace {

/// n . p = w (n . r), r the pixel's ray; 0 where nothing is.
void plane_distances(const raster::Tile& tile,
                     const buffers::PixelRays& rays,
                     const buffers::TilePlane& q,
                     const std::array<buffers::TilePlane, 3>& normals,
                     buffers::TileFloats& to) {
    const int halo = tile.halo_px;
    for (int y = -halo; y < tile.height_px + halo; ++y) {
        const float ry = rays.y(tile.y0_px + y);
        const float* nx = normals[0].row(y);
        const float* ny = normals[1].row(y);
        const float* nz = normals[2].row(y);
        const float* q_row = q.row(y);
        float* out = to.row(y);
        for (int x = -halo; x < tile.width_px + halo; ++x) {
            const float along = nx[x] * rays.x(tile.x0_px + x) + ny[x] * ry - nz[x];
            out[x] = q_row[x] > 0 ? along / q_row[x] : 0;
        }
    }
}

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        {},
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // Lines at smaller steps between planes.
        {{"plane_step", "0.04"}, {"threshold", "225"}},
        // Lines at larger ones only.
        {{"plane_step", "0.64"}, {"threshold", "72"}},
        // Blunter creases too.
        {{"normal_step", "0.1"}},
        // Sharper ones only.
        {{"normal_step", "0.4"}},
        // No smooth normals: planes are planes, and curved surfaces show their facets.
        {{"normals", "facet"}},
        // Normals and depth exact on the surface, at the price of a division.
        {{"interpolation", "perspective"}},
        {{"interpolation", "perspective"}, {"renormalise", "true"}},
    };
}

}  // namespace

core::ParamTable<PlaneDistance::Params> PlaneDistance::table() {
    core::ParamTable<Params> table;
    table
        .number(
            &Params::plane_step,
            "plane_step",
            {1e-4, 10},
            "",
            "Least step of the planes' distance that is a line, as a share of the nearer pixel's "
            "distance.")
        .number(&Params::normal_step,
                "normal_step",
                {1e-3, 2},
                "",
                "Least change of the normal that is a line: 2 sin(a/2) for a crease of angle a.");
    return buffers::add_surface_params(table).number(
        &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
}

PlaneDistance::PlaneDistance(const Params& params)
    : buffers::FullBufferMethod(buffers::with_distances(params), 1), params_(params) {}

void PlaneDistance::filter(const buffers::FullBufferFrame& frame,
                           const raster::Tile& tile,
                           edge::EdgeImage& out) const {
    buffers::TileFloats q_buffer;
    std::array<buffers::TileFloats, 3> normal_buffers;
    buffers::TileFloats plane;
    buffers::TileFloats plane_cross;
    buffers::TileFloats turn;
    const buffers::TilePlane q =
        buffers::inverse_distance(tile, frame.carrier, frame.range, q_buffer);
    const std::array<buffers::TilePlane, 3> normals =
        buffers::view_normals(tile, params_.renormalise, normal_buffers);
    plane_distances(tile, frame.rays, q, normals, plane);
    buffers::half_cross(tile, buffers::TilePlane(plane), plane_cross);
    buffers::normal_cross(tile, normals, turn);
    const float per_plane = 1 / static_cast<float>(params_.plane_step);
    const auto step_ratio = [&](int x, int y, const buffers::CrossRange& near) {
        return plane_cross.row(y)[x] * near.most * per_plane;
    };
    buffers::write_cross(tile, q, turn, params_.normal_step, step_ratio, out);
}

method::PixelWork PlaneDistance::filter_work() const {
    constexpr double kFloat_bytes = sizeof(float);
    // Two products, two sums, a division, sky told.
    const method::PixelWork plane{4 * kFloat_bytes, kFloat_bytes, 4 + method::kSlowOperations + 1};
    // Squares, sums and a root; two steps against their thresholds, the larger; to a byte.
    const method::PixelWork join{0, 1, 3 + 2 + method::kSlowOperations + 2 + 3 + 1 + 4};
    return buffers::inverse_distance_work(params_.interpolation) +
           buffers::view_normals_work(params_.renormalise) + plane +
           4 * buffers::half_cross_work() + join;
}

method::MethodInfo plane_distance() {
    method::MethodInfo info = method::method_info<PlaneDistance>(
        "plane_distance",
        "practice since deferred shading: n . p in place of depth",
        "diagonal differences of the plane's distance n . p and of the normal");
    info.family = method::Family::full_buffers;
    info.marker = method::Marker::up;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
