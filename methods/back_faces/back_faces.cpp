// Lander, "Under the Shade of the Rendering Tree", Game Developer, February 2000, as CoRgi tells
// it: back faces as a thick wireframe, front faces filled over it.

#include "buffers/filled_lines.h"

namespace ink::methods {
namespace {

class BackFaces : public buffers::FilledLinesMethod {
  public:
    using Params = buffers::WireParams;
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        buffers::add_wire_width_param(table).number(
            &Params::units,
            "units",
            {-65536, 65536},
            "steps",
            "Polygon offset's units on the lines: below 0 moves towards the eye.");
        return buffers::add_depth_buffer_params(buffers::add_wire_edges_param(table));
    }
    explicit BackFaces(const Params& params) : FilledLinesMethod(params), params_(params) {}

  private:
    void choose(const method::Frame& frame,
                buffers::TriangleEdges& scene,
                raster::MeshInput& fills,
                raster::LineInput& lines) const override {
        fills.cull = raster::Cull::back;
        lines.lines = scene.lines_of_side(-1, frame);
        lines.width_px = params_.width_px;
        lines.offset = {0, params_.units};
    }

    Params params_;
};

}  // namespace

method::MethodInfo back_faces_method() {
    return method::method_info<BackFaces>("back_faces");
}

}  // namespace ink::methods
