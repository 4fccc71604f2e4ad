// "Inked", a page on drawing outlines: a fat black wireframe first, then fills over it, moved
// towards the eye by glPolygonOffset(factor, units).

#include "buffers/filled_lines.h"

namespace ink::methods {
namespace {

enum class Faces {
    both,   ///< nothing is culled
    front,  ///< back faces are neither filled nor drawn as lines
};

class PolygonOffsetInk : public buffers::FilledLinesMethod {
  public:
    struct Params : buffers::WireParams {
        Params() { units = -1; }
        double factor = -0.5;
        Faces faces = Faces::both;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        buffers::add_wire_width_param(table)
            .number(&Params::factor,
                    "factor",
                    {-8, 8},
                    "1/px",
                    "Polygon offset's factor over the width: below 0 moves towards the eye.")
            .number(&Params::units,
                    "units",
                    {-65536, 65536},
                    "steps",
                    "Polygon offset's units: below 0 moves towards the eye.");
        buffers::add_wire_edges_param(table).choice(
            &Params::faces,
            "faces",
            {"both", "front"},
            "Draw faces seen from both sides, or cull those seen from their back.");
        return buffers::add_depth_buffer_params(table);
    }
    explicit PolygonOffsetInk(const Params& params) : FilledLinesMethod(params), params_(params) {}

  private:
    void choose(const method::Frame& frame,
                buffers::TriangleEdges& scene,
                raster::MeshInput& fills,
                raster::LineInput& lines) const override {
        const bool is_culled = params_.faces == Faces::front;
        fills.cull = is_culled ? raster::Cull::back : raster::Cull::none;
        // The page's width is a whole number; a factor of a width that is rounded must not be
        // another.
        fills.offset = {params_.factor * raster::line_width_px(params_.width_px), params_.units};
        lines.lines = is_culled ? scene.lines_of_side(1, frame) : scene.lines();
        lines.width_px = params_.width_px;
    }

    Params params_;
};

}  // namespace

method::MethodInfo polygon_offset_method() {
    return method::method_info<PolygonOffsetInk>("polygon_offset");
}

}  // namespace ink::methods
