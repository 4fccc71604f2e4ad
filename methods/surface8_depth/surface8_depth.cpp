// New here: the codes of surface8, and the depth that lies beside them. Of four samples in line, j
// is the step of q = 1/distance between the middle two, s0 and s1 are those before and after. A
// line is where surface8 has one, and where both
//
//     max(j - max(s0, s1), min(s0, s1) - j) > jump_px * (larger q of the middle two) / focal_px
//     |j| > ratio * max(|s0|, |s1|) (edge/side_differences.h)

#include "buffers/tile_buffer.h"
#include "edge/side_differences.h"
#include "methods/surface_codes/code_method.h"

namespace ink::methods {
namespace {

struct Surface8DepthParams : SurfaceCodeParams {
    double jump_px = 8;  // from 1, 4, 8 and 16; `ratio` from 2 and 3: see the page
    double ratio = 2;
};

CodeSetup setup(const SurfaceCodeParams& params) {
    CodeSetup setup = surface_setup(params);
    setup.halo_px = 2;
    return setup;
}

class Surface8Depth : public CodeMethod {
  public:
    using Params = Surface8DepthParams;
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table
            .number(&Params::jump_px,
                    "jump_px",
                    {0.1, 1000},
                    "px",
                    "Least jump of depth that is a line: how far it leads along the view, as that "
                    "many pixels lie across.")
            .number(&Params::ratio,
                    "ratio",
                    {0, 100},
                    "",
                    "Over the steps of depth on either side that such a jump is, at least.");
        return add_surface_code_params(table);
    }
    explicit Surface8Depth(const Params& params)
        : CodeMethod(params, setup(params)), params_(params) {}

  private:
    void add_lines(const raster::Tile& tile,
                   edge::Sides sides,
                   const core::ImageView<std::uint8_t>& out) const override {
        const scene::View& view = pass().inputs().view();
        const scene::DepthSlope least = params_.jump_px * scene::Projection(view).q_per_px();
        edge::DepthJump jump{.least_share = static_cast<float>(least.of_q),
                             .slack = static_cast<float>(least.constant),
                             .ratio = static_cast<float>(params_.ratio)};
        if (params_.depth_format == raster::DepthFormat::q32) {
            const core::ImageView<const float> q{
                tile.depth_row<float>(0), tile.width_px, tile.height_px, tile.stride};
            return edge::add_depth_jumps(q, out, sides, jump);
        }
        const raster::QuantisedDepth depth(params_.depth_format, view.camera.near, view.camera.far);
        buffers::TileFloats q;
        for (int y = -1; y < tile.height_px + 2; ++y) {
            const auto* steps = tile.depth_row<std::uint32_t>(y);
            for (int x = -1; x < tile.width_px + 2; ++x)
                q.row(y)[x] = steps[x] == 0 ? 0 : static_cast<float>(depth.q_of(steps[x]));
        }
        jump.slack += static_cast<float>(2 / depth.scale());  // four samples, half a step each
        const core::ImageView<const float> rows{
            q.row(0), tile.width_px, tile.height_px, buffers::TileFloats::kSpan};
        edge::add_depth_jumps(rows, out, sides, jump);
    }
    /// Codes and depth.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        return {static_cast<double>(bytes_per_px()), 1};
    }

    Params params_;
};

}  // namespace

method::MethodInfo surface8_depth_method() {
    return method::method_info<Surface8Depth>("surface8_depth");
}

}  // namespace ink::methods
