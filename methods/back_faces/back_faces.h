#pragma once

#include "buffers/filled_lines.h"

namespace ink::methods {

/// Lander's outlines: back faces as a thick wireframe, front faces filled over it.
class BackFaces : public buffers::FilledLinesMethod {
  public:
    struct Params {
        double width_px = 2;
        double units = 0;
        buffers::WireEdges edges = buffers::WireEdges::all;
        raster::DepthFormat depth_format = raster::DepthFormat::z24;
        int threshold = 128;  // it draws 0 and 255 only
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit BackFaces(const Params& params);

  private:
    void choose(const method::Frame& frame,
                buffers::TriangleEdges& scene,
                raster::MeshInput& fills,
                raster::LineInput& lines) const override;

    Params params_;
};

[[nodiscard]] method::MethodInfo back_faces();

}  // namespace ink::methods
