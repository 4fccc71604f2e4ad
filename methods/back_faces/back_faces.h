#pragma once

#include "buffers/filled_lines.h"
#include "buffers/triangle_edges.h"
#include "method/method.h"

namespace ink::methods {

/// Lander's outlines: back faces as a thick wireframe, front faces filled over it.
class BackFaces : public method::Method {
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

    void prepare(const scene::Scene& scene) override { scene_.prepare(scene); }
    void pose(const scene::Scene& scene) override { scene_.pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    [[nodiscard]] int bytes_per_px() const override {
        return filled_lines_.format().bytes_per_px();
    }
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    Params params_;
    buffers::TriangleEdges scene_;
    buffers::FilledLines filled_lines_;
    raster::SkipCounts skip_counts_{};
};

[[nodiscard]] method::MethodInfo back_faces();

}  // namespace ink::methods
