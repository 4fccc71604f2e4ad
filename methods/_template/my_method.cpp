// Who described it, and where.

#include "buffers/full_buffer_method.h"

namespace ink::methods {
namespace {

/// A line where |n . v| is below `limit`; depth and normals come from the base.
class MyMethod : public buffers::FullBufferMethod {
  public:
    struct Params : buffers::InputParams {
        double limit = 0.3;
        int threshold = 128;  ///< every method has one: the edge response of a line pixel
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table.number(&Params::limit, "limit", {0, 1}, "", "|n.v| below which a pixel is a line.");
        return method::add_threshold(buffers::add_surface_params(table));
    }
    /// The 0: this filter looks at no neighbour. One that does says how many pixels far.
    explicit MyMethod(const Params& params) : FullBufferMethod(params, 0), params_(params) {}

  private:
    /// Writes the edge responses of one tile; row(y)[x] is relative to the tile.
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override {
        std::array<buffers::TileFloats, 3> scratch;
        const auto normals = buffers::view_normals(tile, params_.renormalise, scratch);
        buffers::TileFloats facing;
        buffers::facing_ratio(tile, normals, frame.rays, facing);
        for (int y = 0; y < tile.height_px; ++y) {
            for (int x = 0; x < tile.width_px; ++x) {
                const bool is_sky = tile.row<float>(0, y)[x] == method::kNothingDrawn;
                const bool is_line = !is_sky && facing.row(y)[x] < params_.limit;
                out.at(tile.x0_px + x, tile.y0_px + y) = is_line ? 255 : 0;
            }
        }
    }
    /// Read and written a pixel, for the predicted time.
    [[nodiscard]] method::PixelBytes filter_bytes() const override { return {12, 1}; }

    Params params_;
};

}  // namespace

method::MethodInfo my_method_method() {
    return method::method_info<MyMethod>("my_method");
}

}  // namespace ink::methods
