#include "buffers/full_buffer_method.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "buffers/each_tile.h"
#include "buffers/packed_sink.h"
#include "buffers/sample_grid.h"
#include "buffers/surface_values.h"
#include "edge/sobel.h"

namespace ink::buffers {
namespace {

raster::PassFormat pass_format(const InputParams& params, int halo_px) {
    return {.interpolants = kChannels,
            .store = raster::Store::f32,
            .interpolation = params.interpolation,
            .depth = params.depth_format,
            .halo_px = halo_px};
}

/// A number of 0..1 as a byte; others are limited.
std::uint8_t byte_of(float share) {
    return static_cast<std::uint8_t>(std::clamp(share, 0.0F, 1.0F) * 255 + 0.5F);
}

}  // namespace

FullBuffers::FullBuffers(const InputParams& params, int halo_px)
    : SurfacePass(params, pass_format(params, halo_px)), params_(params) {}

method::DepthCarrier FullBuffers::see(const method::Frame& frame) {
    inputs().see(frame);
    return {params_.depth_encoding, params_.interpolation, inputs().range()};
}

raster::SkipCounts FullBuffers::draw(const method::Frame& frame,
                                     const method::DepthCarrier& carrier,
                                     float sky,
                                     raster::TileSink& sink,
                                     edge::EdgeImage& out) {
    const ChannelValues values(inputs(), carrier);
    raster::MeshInput input = inputs().mesh_input(frame);
    input.values = &values;
    input.sky_f32 = {carrier.is_encoded() ? sky : method::kNothingDrawn, 0, 0, 0};
    const raster::MeshResult result = SurfacePass::draw(input, sink);
    inputs().finish(result, out);
    return result.skips;
}

std::vector<method::Layer> FullBuffers::layers(const method::Frame& frame) {
    method::Layer depth{"depth", {frame.view.width_px, frame.view.height_px}};
    method::Layer normal{"normal", {frame.view.width_px, frame.view.height_px}};
    if (!is_empty()) {
        const method::DepthCarrier carrier = see(frame);
        const ChannelValues values(inputs(), carrier);
        raster::MeshInput input = inputs().mesh_input(frame);
        input.values = &values;
        input.sky_f32 = {method::kNothingDrawn, 0, 0, 0};
        input.may_keep_still = false;
        EachTile sink([&](const raster::Tile& drawn) {
            if (drawn.is_empty) return;
            const raster::Tile tile =
                output_tile(drawn, depth.rgb.width_px(), depth.rgb.height_px());
            TileFloats depth_buffer;
            std::array<TileFloats, 3> normal_buffers;
            const TilePlane codes =
                encoded_depth(tile, carrier, params_.depth_sign, 0, depth_buffer);
            const auto normals = view_normals(tile, params_.renormalise, normal_buffers);
            for (int y = 0; y < tile.height_px; ++y) {
                const float* const carried = tile.row<float>(0, y);
                glm::u8vec3* const depth_row = depth.rgb.row(tile.y0_px + y) + tile.x0_px;
                glm::u8vec3* const normal_row = normal.rgb.row(tile.y0_px + y) + tile.x0_px;
                for (int x = 0; x < tile.width_px; ++x) {
                    if (carried[x] == method::kNothingDrawn) continue;
                    depth_row[x] = glm::u8vec3(byte_of(codes.row(y)[x]));
                    for (int i = 0; i < 3; ++i) {
                        const float n = normals[static_cast<std::size_t>(i)].row(y)[x];
                        normal_row[x][i] = byte_of((n + 1) / 2);
                    }
                }
            }
        });
        (void)SurfacePass::draw(input, sink);
        inputs().forget_image();
    }
    return {std::move(depth), std::move(normal)};
}

TilePlane encoded_depth(const raster::Tile& tile,
                        const method::DepthCarrier& carrier,
                        DepthSign sign,
                        float sky,
                        TileFloats& buffer) {
    const bool is_near_high = sign == DepthSign::near_high;
    if (carrier.is_encoded() && is_near_high) return {tile.row<float>(0, 0), tile.stride};
    const int halo = tile.halo_px;
    const int width = tile.width_px + 2 * halo;
    for (int y = -halo; y < tile.height_px + halo; ++y) {
        const float* carried = tile.row<float>(0, y) - halo;
        float* out = buffer.row(y) - halo;
        if (carrier.is_encoded()) {
            std::copy_n(carried, width, out);
        } else {
            carrier.encode_row(carried, sky, out, width);
        }
        for (int x = 0; !is_near_high && x < width; ++x)
            out[x] = 1 - out[x];
    }
    return TilePlane(buffer);
}

TilePlane inverse_distance(const raster::Tile& tile,
                           const method::DepthCarrier& carrier,
                           const raster::DepthRange& range,
                           TileFloats& buffer) {
    const int halo = tile.halo_px;
    const double q_far = 1 / range.far;
    const double q_span = 1 / range.near - q_far;
    const double w_span = range.far - range.near;
    const auto of = [&](double carried) {
        const double q = carrier.is_affine() ? carried * q_span + q_far
                                             : 1 / std::max(range.far - carried * w_span, 1e-30);
        return static_cast<float>(std::max(q, 1e-30));
    };
    for (int y = -halo; y < tile.height_px + halo; ++y) {
        const float* carried = tile.row<float>(0, y);
        float* out = buffer.row(y);
        for (int x = -halo; x < tile.width_px + halo; ++x)
            out[x] = carried[x] == method::kNothingDrawn ? 0 : of(carried[x]);
    }
    return TilePlane(buffer);
}

std::array<TilePlane, 3> view_normals(const raster::Tile& tile,
                                      bool renormalise,
                                      std::array<TileFloats, 3>& buffers) {
    std::array<TilePlane, 3> planes;
    for (std::size_t i = 0; i < 3; ++i) {
        const float* own = tile.row<float>(static_cast<int>(i) + 1, 0);
        planes[i] = renormalise ? TilePlane(buffers[i]) : TilePlane(own, tile.stride);
    }
    if (!renormalise) return planes;
    const int halo = tile.halo_px;
    for (int y = -halo; y < tile.height_px + halo; ++y) {
        for (int x = -halo; x < tile.width_px + halo; ++x) {
            float n[3];
            float square = 0;
            for (int i = 0; i < 3; ++i) {
                n[i] = tile.row<float>(i + 1, y)[x];
                square += n[i] * n[i];
            }
            const float scale = square > 0 ? 1 / std::sqrt(square) : 0;
            for (std::size_t i = 0; i < 3; ++i)
                buffers[i].row(y)[x] = n[i] * scale;
        }
    }
    return planes;
}

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
