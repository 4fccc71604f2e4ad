#pragma once

#include <array>
#include <cstddef>

#include "buffers/surface_pass.h"

namespace ink::buffers {

/// A tile of floats with its halo, on the stack of the tile's thread; row(y)[x] in tile-local
/// coordinates.
class TileFloats {
  public:
    static constexpr int kSpan = raster::kTileSize_px + 2 * raster::kMaxHalo_px;

    [[nodiscard]] float* row(int y) {
        return pixels_.data() + (y + raster::kMaxHalo_px) * kSpan + raster::kMaxHalo_px;
    }

  private:
    std::array<float, static_cast<std::size_t>(kSpan) * kSpan> pixels_;
};

/// A plane of floats of a tile, wherever it lies.
struct TilePlane {
    const float* origin = nullptr;  ///< local (0, 0)
    std::ptrdiff_t stride = 0;      ///< floats from one row to the next

    TilePlane() = default;
    TilePlane(const float* origin_in, std::ptrdiff_t stride_in)
        : origin(origin_in), stride(stride_in) {}
    explicit TilePlane(TileFloats& buffer) : origin(buffer.row(0)), stride(TileFloats::kSpan) {}
    [[nodiscard]] const float* row(int y) const { return origin + y * stride; }
};

/// The four planes of a full buffer: depth as it was carried, and the view-space normal.
class FullBuffers : public SurfacePass {
  public:
    FullBuffers(const InputParams& params, int halo_px);

    /// How this frame's depth is carried. Before draw(), for the sink.
    [[nodiscard]] method::DepthCarrier see(const method::Frame& frame);
    /// Draws the frame that was seen. Where nothing is, normals are null and depth is `sky`, or
    /// kNothingDrawn where the carrier's depth is yet to be encoded.
    [[nodiscard]] raster::SkipCounts draw(const method::Frame& frame,
                                          const method::DepthCarrier& carrier,
                                          float sky,
                                          raster::TileSink& sink,
                                          edge::EdgeImage& out);

    /// `depth`: its codes 0..1 from black to white, sky black; `normal`: (n + 1) / 2 of x, y, z as
    /// red, green, blue, sky black. Drawn anew.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame);

  private:
    InputParams params_;
};

/// Encoded depth of a tile, halo included: its own plane if that holds it, else made in `buffer`.
[[nodiscard]] TilePlane encoded_depth(const raster::Tile& tile,
                                      const method::DepthCarrier& carrier,
                                      DepthSign sign,
                                      float sky,
                                      TileFloats& buffer);

/// 1 / distance of a tile whose sky is kNothingDrawn, halo included; 0 there. `carrier` carries
/// what is encoded as it stands, over `range`.
[[nodiscard]] TilePlane inverse_distance(const raster::Tile& tile,
                                         const method::DepthCarrier& carrier,
                                         const raster::DepthRange& range,
                                         TileFloats& buffer);

/// The view-space normals of a tile, halo included: its own planes, or scaled to length 1 in
/// `buffers`; a null normal stays null.
[[nodiscard]] std::array<TilePlane, 3> view_normals(const raster::Tile& tile,
                                                    bool renormalise,
                                                    std::array<TileFloats, 3>& buffers);

}  // namespace ink::buffers
