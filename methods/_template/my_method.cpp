// Who described it, and where.

#include "buffers/full_buffer_method.h"

namespace ink::methods {
namespace {

/// A cross over neighbours: a line where the normal turns by more than `limit`, or the surface
/// ends. Depth and normals come from the base.
class MyMethod : public buffers::FullBufferMethod {
  public:
    struct Params : buffers::InputParams {
        double limit = 0.2;
        int threshold = 128;  ///< every method has one: the edge response of a line pixel
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table.number(
            &Params::limit, "limit", {0, 2}, "", "1 - cos of the normal's turn that is a line.");
        return method::add_threshold(buffers::add_surface_params(table));
    }
    /// The 1: how many pixels beyond its tile the filter looks.
    explicit MyMethod(const Params& params) : FullBufferMethod(params, 1), params_(params) {}

  private:
    /// Of two pixels' normals; that of the sky is 0.
    [[nodiscard]] bool is_step(const glm::vec3& a, const glm::vec3& b) const {
        const bool is_sky_a = a == glm::vec3(0), is_sky_b = b == glm::vec3(0);
        if (is_sky_a || is_sky_b) return is_sky_a != is_sky_b;
        return 1 - glm::dot(a, b) > params_.limit;
    }
    /// Writes the edge responses of one tile; row(y)[x] is relative to the tile.
    void filter(const buffers::FullBufferFrame& /*frame*/,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override {
        std::array<buffers::TileFloats, 3> scratch;
        const auto normals = buffers::view_normals(tile, params_.renormalise, scratch);
        const auto normal = [&](int x, int y) {
            return glm::vec3(normals[0].row(y)[x], normals[1].row(y)[x], normals[2].row(y)[x]);
        };
        for (int y = 0; y < tile.height_px; ++y) {
            for (int x = 0; x < tile.width_px; ++x) {
                const bool is_line = is_step(normal(x, y), normal(x + 1, y + 1)) ||
                                     is_step(normal(x + 1, y), normal(x, y + 1));
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
