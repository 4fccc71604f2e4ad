#pragma once

#include "buffers/filled_lines.h"

namespace ink::methods {

/// Ink by polygon offset: a fat black wireframe, and fills moved towards the eye over it.
class PolygonOffsetInk : public buffers::FilledLinesMethod {
  public:
    enum class Faces {
        both,   ///< nothing is culled
        front,  ///< back faces are neither filled nor drawn as lines
    };
    struct Params {
        double width_px = 2;
        double factor = -0.5;
        double units = -1;
        buffers::WireEdges edges = buffers::WireEdges::all;
        Faces faces = Faces::both;
        raster::DepthFormat depth_format = raster::DepthFormat::z24;
        int threshold = 128;  // it draws 0 and 255 only
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit PolygonOffsetInk(const Params& params);

  private:
    void choose(const method::Frame& frame,
                buffers::TriangleEdges& scene,
                raster::MeshInput& fills,
                raster::LineInput& lines) const override;

    Params params_;
};

[[nodiscard]] method::MethodInfo polygon_offset();

}  // namespace ink::methods
