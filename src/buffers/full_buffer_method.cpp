#include "buffers/full_buffer_method.h"

#include <cmath>

#include "buffers/each_tile.h"
#include "buffers/packed_sink.h"
#include "buffers/sample_grid.h"
#include "edge/sobel.h"

namespace ink::buffers {

PixelPlaces::PixelPlaces(const scene::View& view)
    : center_x_px_(static_cast<float>(view.width_px) / 2),
      center_y_px_(static_cast<float>(view.height_px) / 2),
      per_px_(static_cast<float>(1 / scene::Projection(view).px_per_world(1))) {}

InputParams with_distances(InputParams params) {
    params.depth_encoding = params.interpolation == raster::Interpolation::affine
                                ? raster::DepthEncoding::inverse
                                : raster::DepthEncoding::linear;
    return params;
}

void facing_ratio(const raster::Tile& tile,
                  const std::array<TilePlane, 3>& normals,
                  const PixelPlaces& places,
                  bool is_parallel,
                  TileFloats& out) {
    const int halo = tile.halo_px;
    for (int y = -halo; y < tile.height_px + halo; ++y) {
        const float ry = is_parallel ? 0 : places.y(tile.y0_px + y);
        const float* nx = normals[0].row(y);
        const float* ny = normals[1].row(y);
        const float* nz = normals[2].row(y);
        float* to = out.row(y);
        for (int x = -halo; x < tile.width_px + halo; ++x) {
            const float rx = is_parallel ? 0 : places.x(tile.x0_px + x);
            const float along = nx[x] * rx + ny[x] * ry - nz[x];
            to[x] = std::abs(along) / std::sqrt(rx * rx + ry * ry + 1);
        }
    }
}

void half_cross(const raster::Tile& tile, const TilePlane& plane, TileFloats& out) {
    const core::ImageView<const float> from{
        plane.origin, tile.width_px, tile.height_px, plane.stride};
    const core::ImageView<float> to{out.row(0), tile.width_px, tile.height_px, TileFloats::kSpan};
    edge::roberts(from, to);
    for (int y = 0; y < tile.height_px; ++y) {
        float* row = out.row(y);
        for (int x = 0; x < tile.width_px; ++x)
            row[x] *= 0.5F;
    }
}

void normal_cross(const raster::Tile& tile,
                  const std::array<TilePlane, 3>& normals,
                  TileFloats& out) {
    TileFloats cross;
    for (std::size_t i = 0; i < 3; ++i) {
        half_cross(tile, normals[i], cross);
        for (int y = 0; y < tile.height_px; ++y) {
            const float* row = cross.row(y);
            float* to = out.row(y);
            for (int x = 0; x < tile.width_px; ++x)
                to[x] = (i == 0 ? 0 : to[x]) + row[x] * row[x];
        }
    }
    for (int y = 0; y < tile.height_px; ++y) {
        float* to = out.row(y);
        for (int x = 0; x < tile.width_px; ++x)
            to[x] = std::sqrt(to[x]);
    }
}

raster::SkipCounts FullBufferMethod::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    const method::DepthCarrier carrier = pass().see(frame);
    const SurfaceInputs& inputs = pass().inputs();
    const scene::Projection projection(inputs.view());
    const FullBufferFrame seen{carrier,
                               inputs.range(),
                               PixelPlaces(inputs.view()),
                               projection,
                               projection.q_per_distance()};
    EachTile sink([&](const raster::Tile& tile) {
        if (tile.is_empty) return clear_tile(tile, out);
        const raster::Tile output = output_tile(tile, out.width_px(), out.height_px());
        if (output.width_px > 0 && output.height_px > 0) filter(seen, output, out);
    });
    return pass().draw(frame, carrier, sky_, sink, out);
}

method::PixelBytes encoded_depth_bytes(const InputParams& params) {
    const raster::DepthRange any_range{1, 2};
    const method::DepthCarrier carrier(params.depth_encoding, params.interpolation, any_range);
    const bool has_own_plane = carrier.is_encoded() && params.depth_sign == DepthSign::near_high;
    return has_own_plane ? method::PixelBytes{} : method::PixelBytes{4, 4};
}

method::PixelBytes view_normals_bytes(bool renormalise) {
    return renormalise ? method::PixelBytes{12, 12} : method::PixelBytes{};
}

}  // namespace ink::buffers
