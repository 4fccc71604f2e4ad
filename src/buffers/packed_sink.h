#pragma once

#include <cstdint>
#include <vector>

#include "buffers/code_layout.h"
#include "core/image.h"
#include "edge/edge_image.h"
#include "raster/pass/pass.h"

namespace ink::buffers {

/// Where the codes of a packed buffer come to be.
enum class Packing {
    vertex,  ///< packed at the vertices and interpolated as one number
    pixel,   ///< depth and normal interpolated apart, packed at every pixel
};

/// What happens to a tile of codes.
struct PackedFilter {
    Packing packing = Packing::vertex;
    bool renormalise = false;
    bool fatten = false;
    bool wraps = false;  ///< the planes hold codes modulo their bits
    int sky = 0;
    edge::LaplacianResponse response;  ///< for a field as wide as the store
};

/// A whole frame's codes as they were packed, an image a plane of the layout.
using FrameCodes = std::vector<core::Image<std::uint16_t>>;

/// Packs (packing = pixel), blurs (fatten) and filters each finished tile into an image.
class PackedSink : public raster::TileSink {
  public:
    PackedSink(const Packer& packer,
               const method::DepthCarrier& carrier,
               const PackedFilter& filter,
               edge::EdgeImage& out);

    /// Copies the codes of every tile that is not empty; `codes` has the image's size.
    void keep_codes(FrameCodes& codes) { kept_ = &codes; }

    void finish(const raster::Tile& tile) override;

  private:
    template <class T>
    void finish_as(const raster::Tile& tile) const;
    [[nodiscard]] edge::LaplacianResponse response_of(const Field& field) const;

    const Packer& packer_;
    const method::DepthCarrier& carrier_;
    PackedFilter filter_;
    edge::EdgeImage& out_;
    FrameCodes* kept_ = nullptr;
};

/// Writes an edge response of 0 to every pixel of a tile, as far as the image goes.
void clear_tile(const raster::Tile& tile, edge::EdgeImage& out);

}  // namespace ink::buffers
