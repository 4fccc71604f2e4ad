#pragma once

#include <array>

#include "buffers/surface_pass.h"
#include "buffers/tile_buffer.h"

namespace ink::buffers {

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
