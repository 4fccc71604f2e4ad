#pragma once

#include <string>

#include "edge/edge_image.h"
#include "raster/mesh/mesh_pass.h"

namespace ink::bench {

/// One value a vertex: what `mote4` interpolates, or nearly so.
class SmoothValue : public raster::CornerValues {
  public:
    explicit SmoothValue(const scene::View& view);
    void compute(const raster::CornerBatch& in, const raster::CornerPlanes& out) const override;

  private:
    raster::LinearValue value_;
};

/// Filters tiles as `mote4` does, or leaves them. Borrows the image.
class LimitSink : public raster::TileSink {
  public:
    LimitSink(bool filters, edge::EdgeImage& out) : filters_(filters), out_(out) {}
    void finish(const raster::Tile& tile) override;

  private:
    bool filters_;
    edge::EdgeImage& out_;
};

/// A byte per pixel, for a filter that reaches one pixel.
[[nodiscard]] raster::PassFormat limit_format();

/// A mesh of bench_scene.h seen from `view`, all of it drawn; values are the caller's to add.
[[nodiscard]] raster::MeshInput limit_input(const std::string& mesh, const scene::View& view);

/// A mesh of bench_scene.h in clusters; made at its first use and kept.
[[nodiscard]] const raster::LaneMesh& lane_mesh(const std::string& name);

}  // namespace ink::bench
