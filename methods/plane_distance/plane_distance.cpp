// Practice since deferred shading: Roberts' cross on the distance of each pixel's plane from the
// eye, n . p, and on the normal. Nothing changes within a face, however it is seen.

#include "buffers/full_buffer_method.h"

namespace ink::methods {
namespace {

/// n . p, which is w (n . r) with r the pixel's ray in perspective; 0 where nothing is.
void plane_distances(const raster::Tile& tile,
                     const buffers::FullBufferFrame& frame,
                     const buffers::TilePlane& q,
                     const std::array<buffers::TilePlane, 3>& normals,
                     buffers::TileFloats& to) {
    const buffers::PixelPlaces& places = frame.places;
    const int halo = tile.halo_px;
    for (int y = -halo; y < tile.height_px + halo; ++y) {
        const float py = places.y(tile.y0_px + y);
        const float* nx = normals[0].row(y);
        const float* ny = normals[1].row(y);
        const float* nz = normals[2].row(y);
        const float* q_row = q.row(y);
        float* out = to.row(y);
        if (frame.projection.is_parallel()) {
            for (int x = -halo; x < tile.width_px + halo; ++x) {
                const auto depth = static_cast<float>(frame.projection.depth_of(1 / q_row[x]));
                const float beside = nx[x] * places.x(tile.x0_px + x) + ny[x] * py;
                out[x] = q_row[x] > 0 ? beside - nz[x] * depth : 0;
            }
            continue;
        }
        for (int x = -halo; x < tile.width_px + halo; ++x) {
            const float along = nx[x] * places.x(tile.x0_px + x) + ny[x] * py - nz[x];
            out[x] = q_row[x] > 0 ? along / q_row[x] : 0;
        }
    }
}

class PlaneDistance : public buffers::FullBufferMethod {
  public:
    struct Params : buffers::InputParams {
        // found: experiments/thresholds.py, over the training scenes at 1280x720; see the page
        double plane_step = 0.16;
        double normal_step = 0.2;
        int threshold = 82;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table.number(&Params::plane_step,
                     "plane_step",
                     {1e-4, 10},
                     "",
                     "Least step of the planes' distance that is a line, as a share of the nearer "
                     "pixel's "
                     "distance.");
        return method::add_threshold(
            buffers::add_surface_params(buffers::add_normal_step_param(table)));
    }
    explicit PlaneDistance(const Params& params)
        : FullBufferMethod(buffers::with_distances(params), 1), params_(params) {}

  private:
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override {
        const buffers::CrossPlanes planes(tile, frame, params_.renormalise);
        buffers::TileFloats plane;
        buffers::TileFloats plane_cross;
        plane_distances(tile, frame, planes.q, planes.normals, plane);
        buffers::half_cross(tile, buffers::TilePlane(plane), plane_cross);
        const float per_plane = 1 / static_cast<float>(params_.plane_step);
        const bool is_parallel = frame.projection.is_parallel();
        const float alike =
            is_parallel ? 1 / static_cast<float>(frame.projection.parallel_distance()) : 0;
        const auto step_ratio = [&](int x, int y, const buffers::CrossRange& near) {
            return plane_cross.row(y)[x] * (is_parallel ? alike : near.most) * per_plane;
        };
        buffers::write_cross(tile, planes, params_.normal_step, step_ratio, out);
    }
    /// 1/w from depth; n . p from that and the normal; a cross over each of four planes.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        return buffers::view_normals_bytes(params_.renormalise) +
               method::PixelBytes{4 + 16 + 4 * 4, 4 + 4 + 1};
    }

    Params params_;
};

}  // namespace

method::MethodInfo plane_distance_method() {
    return method::method_info<PlaneDistance>("plane_distance");
}

}  // namespace ink::methods
