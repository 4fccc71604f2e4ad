// The facing ratio under a limit: "rim", "facing ratio" or "fresnel" outlines of shading graphs.
//
//     edge response = 255 (1 - min(1, |n.v| / limit))

#include <algorithm>
#include <cmath>

#include "buffers/full_buffer_method.h"

namespace ink::methods {
namespace {

/// Dark where a surface turns away from the eye: one sample a pixel, no neighbour is looked at.
class Rim : public buffers::FullBufferMethod {
  public:
    struct Params : buffers::InputParams {
        double limit = 0.2;  // found: see the page
        int threshold = 1;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table.number(&Params::limit,
                     "limit",
                     {0.01, 1},
                     "",
                     "|n.v| at which the edge response is 0; it grows to 255 where |n.v| is 0.");
        return method::add_threshold(buffers::add_surface_params(table));
    }
    explicit Rim(const Params& params) : FullBufferMethod(params, 0), params_(params) {}

  private:
    void filter(const buffers::FullBufferFrame& frame,
                const raster::Tile& tile,
                edge::EdgeImage& out) const override {
        std::array<buffers::TileFloats, 3> normals;
        buffers::TileFloats facing;
        buffers::facing_ratio(tile,
                              buffers::view_normals(tile, params_.renormalise, normals),
                              frame.places,
                              frame.projection.is_parallel(),
                              facing);
        const auto limit = static_cast<float>(params_.limit);
        for (int y = 0; y < tile.height_px; ++y) {
            const float* carried = tile.row<float>(0, y);
            const float* ratio = facing.row(y);
            std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
            for (int x = 0; x < tile.width_px; ++x) {
                const float turned = 255 * (1 - std::min(ratio[x] / limit, 1.0F));
                const bool is_surface = carried[x] != method::kNothingDrawn;
                // As std::lround has it, in vectors.
                to[x] =
                    is_surface ? static_cast<std::uint8_t>(static_cast<double>(turned) + 0.5) : 0;
            }
        }
    }
    /// n gives |n.v|, which with depth gives the response.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        return buffers::view_normals_bytes(params_.renormalise) + method::PixelBytes{12 + 8, 4 + 1};
    }

    Params params_;
};

}  // namespace

method::MethodInfo rim_method() {
    return method::method_info<Rim>("rim");
}

}  // namespace ink::methods
