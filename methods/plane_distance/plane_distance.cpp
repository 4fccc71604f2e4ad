#include "methods/plane_distance/plane_distance.h"

#include <algorithm>

#include "buffers/packed_sink.h"
#include "buffers/surface_cross.h"

namespace ink::methods {
namespace {

class PlaneSink : public raster::TileSink {
  public:
    PlaneSink(const PlaneDistance::Params& params,
              const method::DepthCarrier& carrier,
              const raster::DepthRange& range,
              const scene::View& view,
              edge::EdgeImage& out)
        : params_(params), carrier_(carrier), range_(range), rays_(view), out_(out) {}

    void finish(const raster::Tile& tile) override;

  private:
    void plane_distances(const raster::Tile& tile,
                         const buffers::TilePlane& q,
                         const std::array<buffers::TilePlane, 3>& normals,
                         buffers::TileFloats& to) const;

    const PlaneDistance::Params& params_;
    const method::DepthCarrier& carrier_;
    const raster::DepthRange& range_;
    buffers::PixelRays rays_;
    edge::EdgeImage& out_;
};

/// n . p = w (n . r), r the pixel's ray; 0 where nothing is.
void PlaneSink::plane_distances(const raster::Tile& tile,
                                const buffers::TilePlane& q,
                                const std::array<buffers::TilePlane, 3>& normals,
                                buffers::TileFloats& to) const {
    const int halo = tile.halo_px;
    for (int y = -halo; y < tile.height_px + halo; ++y) {
        const float ry = rays_.y(tile.y0_px + y);
        const float* nx = normals[0].row(y);
        const float* ny = normals[1].row(y);
        const float* nz = normals[2].row(y);
        const float* q_row = q.row(y);
        float* out = to.row(y);
        for (int x = -halo; x < tile.width_px + halo; ++x) {
            const float along = nx[x] * rays_.x(tile.x0_px + x) + ny[x] * ry - nz[x];
            out[x] = q_row[x] > 0 ? along / q_row[x] : 0;
        }
    }
}

void PlaneSink::finish(const raster::Tile& tile) {
    if (tile.is_empty) return buffers::clear_tile(tile, out_);
    buffers::TileFloats q_buffer;
    std::array<buffers::TileFloats, 3> normal_buffers;
    buffers::TileFloats plane;
    buffers::TileFloats plane_cross;
    buffers::TileFloats turn;
    const buffers::TilePlane q = buffers::inverse_distance(tile, carrier_, range_, q_buffer);
    const std::array<buffers::TilePlane, 3> normals =
        buffers::view_normals(tile, params_.renormalise, normal_buffers);
    plane_distances(tile, q, normals, plane);
    buffers::half_cross(tile, buffers::TilePlane(plane), plane_cross);
    buffers::normal_cross(tile, normals, turn);
    const float per_plane = 1 / static_cast<float>(params_.plane_step);
    const float per_turn = 1 / static_cast<float>(params_.normal_step);
    for (int y = 0; y < tile.height_px; ++y) {
        std::uint8_t* to = out_.row(tile.y0_px + y) + tile.x0_px;
        for (int x = 0; x < tile.width_px; ++x) {
            const buffers::CrossRange near = buffers::cross_range(q.row(y) + x, q.row(y + 1) + x);
            if (near.least == 0) {  // against the sky, which has no plane
                to[x] = near.most > 0 ? 255 : 0;
                continue;
            }
            const float step = plane_cross.row(y)[x] * near.most * per_plane;
            to[x] = buffers::strength_of_ratio(std::max(step, turn.row(y)[x] * per_turn));
        }
    }
}

/// Depth as the interpolation carries it is 1/w or w: both tell the distance.
PlaneDistance::Params with_distances(PlaneDistance::Params params) {
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
        &Params::threshold, "threshold", {1, 255}, "", "Strength from which on a pixel is a line.");
}

PlaneDistance::PlaneDistance(const Params& params)
    : params_(with_distances(params)), buffers_(params_, 1) {}

void PlaneDistance::draw(const method::Frame& frame, edge::EdgeImage& out) {
    skip_counts_ = {};
    if (buffers_.is_empty()) return out.fill(0);
    const method::DepthCarrier carrier = buffers_.see(frame);
    PlaneSink sink(params_, carrier, buffers_.range(), frame.view, out);
    skip_counts_ = buffers_.draw(frame, carrier, method::kNothingDrawn, sink, out);
}

method::Cost PlaneDistance::cost() const {
    constexpr double kFloat_bytes = sizeof(float);
    method::Cost cost = buffers_.cost();
    method::PixelWork distance{
        kFloat_bytes, kFloat_bytes, 2 + 1 + 1};  // scaled, at least, sky told
    if (params_.interpolation == raster::Interpolation::perspective)
        distance.operations += method::kSlowOperations;
    method::PixelWork normals;
    if (params_.renormalise)
        normals = method::renormalise_work() + 3 * method::PixelWork{kFloat_bytes, kFloat_bytes, 0};
    // Two products, two sums, a division, sky told.
    const method::PixelWork plane{4 * kFloat_bytes, kFloat_bytes, 4 + method::kSlowOperations + 1};
    const method::PixelWork cross{kFloat_bytes, 0, 2 + 2 + 1 + 1};
    // Squares, sums and a root; two steps against their thresholds, the larger; to a byte.
    const method::PixelWork join{0, 1, 3 + 2 + method::kSlowOperations + 2 + 3 + 1 + 4};
    cost.filter = distance + normals + plane + 4 * cross + join;
    return cost;
}

method::MethodInfo plane_distance() {
    method::MethodInfo info = method::method_info<PlaneDistance>(
        "plane_distance",
        "practice since deferred shading: n . p in place of depth",
        "diagonal differences of the plane's distance n . p and of the normal");
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
