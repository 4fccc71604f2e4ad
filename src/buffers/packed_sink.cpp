#include "buffers/packed_sink.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "buffers/sample_grid.h"
#include "buffers/tile_buffer.h"
#include "edge/binomial_blur.h"
#include "edge/laplacian.h"

namespace ink::buffers {
namespace {

/// Columns and rows of a tile with `halo_px` round it.
struct Area {
    int left_px;
    int top_px;
    int right_px;  ///< exclusive
    int bottom_px;

    Area(const raster::Tile& tile, int halo_px)
        : left_px(-halo_px),
          top_px(-halo_px),
          right_px(tile.width_px + halo_px),
          bottom_px(tile.height_px + halo_px) {}
    [[nodiscard]] int width_px() const { return right_px - left_px; }
};

struct PixelSource {
    const Packer& packer;
    const method::DepthCarrier& carrier;
    const PackedFilter& filter;
};

template <class T>
void pack_tile(const PixelSource& source, const raster::Tile& tile, int plane, TileBuffer<T>& to) {
    const Area area(tile, tile.halo_px);
    std::array<float, TileBuffer<T>::kSpan> encoded;
    for (int y = area.top_px; y < area.bottom_px; ++y) {
        const float* carried = tile.row<float>(0, y) + area.left_px;
        if (!source.carrier.is_encoded()) {
            source.carrier.encode_row(
                carried, method::kNothingDrawn, encoded.data(), area.width_px());
        }
        source.packer.pack_row(plane,
                               {.depth = source.carrier.is_encoded() ? carried : encoded.data(),
                                .nx = tile.row<float>(1, y) + area.left_px,
                                .ny = tile.row<float>(2, y) + area.left_px,
                                .nz = tile.row<float>(3, y) + area.left_px,
                                .count = area.width_px(),
                                .renormalise = source.filter.renormalise,
                                .sky = source.filter.sky},
                               to.row(y) + area.left_px);
    }
}

template <class T>
void extract_field(const TileRows<T>& codes,
                   const Field& field,
                   const Area& area,
                   TileBuffer<T>& to) {
    const int mask = (1 << field.bits) - 1;
    for (int y = area.top_px; y < area.bottom_px; ++y) {
        const T* from = codes.row(y);
        T* out = to.row(y);
        for (int x = area.left_px; x < area.right_px; ++x) {
            out[x] = static_cast<T>((from[x] >> field.shift) & mask);
        }
    }
}

template <class T>
void blur_tile(const TileRows<T>& codes, int code_bits, const Area& area, TileBuffer<T>& to) {
    const int height_px = area.bottom_px - area.top_px;
    const core::ImageView<const T> from{
        codes.row(area.top_px) + area.left_px, area.width_px(), height_px, codes.stride};
    const core::ImageView<T> blurred{
        to.row(area.top_px) + area.left_px, area.width_px(), height_px, TileBuffer<T>::kSpan};
    edge::binomial_blur(from, blurred, code_bits);
}

template <class T>
void copy_tile(const TileRows<T>& codes, const raster::Tile& tile, core::Image<std::uint16_t>& to) {
    for (int y = 0; y < tile.height_px; ++y)
        std::copy_n(codes.row(y), tile.width_px, to.row(tile.y0_px + y) + tile.x0_px);
}

template <class T>
void filter_codes(const TileRows<T>& codes,
                  const edge::LaplacianResponse& response,
                  const core::ImageView<std::uint8_t>& to) {
    edge::laplacian(core::ImageView<const T>{codes.row(0), to.width_px, to.height_px, codes.stride},
                    to,
                    response);
}

/// Writes a tile's edge responses; joins them with what an earlier field left by their maximum.
template <class T>
void filter_tile(const TileRows<T>& codes,
                 const edge::LaplacianResponse& response,
                 const raster::Tile& tile,
                 bool is_first,
                 edge::EdgeImage& out) {
    const core::ImageView<std::uint8_t> to{
        out.row(tile.y0_px) + tile.x0_px, tile.width_px, tile.height_px, out.width_px()};
    if (is_first) return filter_codes(codes, response, to);
    std::array<std::uint8_t, raster::kTileSize_px * raster::kTileSize_px> buffer;
    const core::ImageView<std::uint8_t> edge_responses{
        buffer.data(), tile.width_px, tile.height_px, raster::kTileSize_px};
    filter_codes(codes, response, edge_responses);
    for (int y = 0; y < tile.height_px; ++y) {
        const std::uint8_t* mine = edge_responses.row(y);
        std::uint8_t* joined = to.row(y);
        for (int x = 0; x < tile.width_px; ++x)
            joined[x] = std::max(joined[x], mine[x]);
    }
}

}  // namespace

void clear_tile(const raster::Tile& tile, edge::EdgeImage& out) {
    const raster::Tile output = output_tile(tile, out.width_px(), out.height_px());
    if (output.width_px == 0 || output.height_px == 0) return;
    const core::ImageView<std::uint8_t> to{
        out.row(tile.y0_px) + tile.x0_px, output.width_px, output.height_px, out.width_px()};
    for (int y = 0; y < to.height_px; ++y) {
        if (to.width_px == raster::kTileSize_px) {  // known to the compiler: a few stores, no call
            std::memset(to.row(y), 0, raster::kTileSize_px);
        } else {
            std::memset(to.row(y), 0, static_cast<std::size_t>(to.width_px));
        }
    }
}

PackedSink::PackedSink(const Packer& packer,
                       const method::DepthCarrier& carrier,
                       const PackedFilter& filter,
                       edge::EdgeImage& out)
    : packer_(packer), carrier_(carrier), filter_(filter), out_(out) {}

/// Edge responses of narrow fields are scaled up to the store's, so that one threshold means one
/// share of the range. Under a packing at vertices, what is interpolated is the whole number, and
/// the bits below a field's own carry into it: a lower field is then known modulo its size only.
edge::LaplacianResponse PackedSink::response_of(const Field& field) const {
    edge::LaplacianResponse response = filter_.response;
    const int store_bits = packer_.layout().bits();
    const bool is_top = field.shift + field.bits == store_bits;
    response.code_bits = field.bits;
    response.code_wraps = filter_.wraps || (filter_.packing == Packing::vertex && !is_top);
    response.scale_bits = std::min(response.scale_bits + store_bits - field.bits, 15);
    return response;
}

template <class T>
void PackedSink::finish_as(const raster::Tile& tile) const {
    TileBuffer<T> packed;
    TileBuffer<T> extracted;
    TileBuffer<T> blurred;
    const CodeLayout& layout = packer_.layout();
    TileRows<T> plane_codes;
    int plane = -1;
    for (const Field& field : layout.fields) {
        if (field.plane != plane) {
            plane = field.plane;
            if (filter_.packing == Packing::pixel) {
                pack_tile(PixelSource{packer_, carrier_, filter_}, tile, plane, packed);
                plane_codes = TileRows<T>(packed);
            } else {
                plane_codes = {tile.row<T>(plane, 0), tile.stride};
            }
            if (kept_) copy_tile(plane_codes, tile, (*kept_)[static_cast<std::size_t>(plane)]);
        }
        TileRows<T> codes = plane_codes;
        if (layout.has_bit_fields()) {
            extract_field(codes, field, Area(tile, tile.halo_px), extracted);
            codes = TileRows<T>(extracted);
        }
        const edge::LaplacianResponse response = response_of(field);
        if (filter_.fatten) {
            blur_tile(codes, response.code_wraps ? field.bits : 0, Area(tile, 1), blurred);
            codes = TileRows<T>(blurred);
        }
        filter_tile(codes, response, tile, &field == &layout.fields.front(), out_);
    }
}

void PackedSink::finish(const raster::Tile& tile) {
    if (tile.is_empty) return clear_tile(tile, out_);
    if (packer_.layout().store == raster::Store::u8) return finish_as<std::uint8_t>(tile);
    finish_as<std::uint16_t>(tile);
}

}  // namespace ink::buffers
