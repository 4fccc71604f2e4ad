#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "buffers/each_tile.h"
#include "buffers/sample_grid.h"
#include "buffers/surface_pass.h"

namespace ink::buffers {

/// A scene drawn with a number a triangle, the pass's constant: an id, a label, a code.
///
/// prepare, pose, then draw for every frame. After a draw that may leave out, inputs().finish()
/// copies what was not drawn.
class ConstantPass : public SurfacePass {
  public:
    void prepare(const scene::PreparedScene& scene);
    void pose(const scene::PreparedScene& scene);

    /// Hands every tile of samples to `sink`, `sky` where nothing is. With `may_leave_out` tiles in
    /// which nothing moved since the last frame may be kept, and what is flat left out.
    [[nodiscard]] raster::MeshResult draw(const method::Frame& frame,
                                          bool may_leave_out,
                                          raster::TileSink& sink);
    /// The frame of a method that draws all its lines from the tiles it is handed. `sink` writes to
    /// `out`. Returns what was skipped. The scene is not empty.
    raster::SkipCounts draw_lines(const method::Frame& frame,
                                  raster::TileSink& sink,
                                  edge::EdgeImage& out);
    /// The constants, of type `Code`, in colours; of pixel corners, that of the upper left one.
    /// Black where nothing is. Drawn anew.
    template <class Code, class ColorOf>
    [[nodiscard]] method::Layer layer(const method::Frame& frame,
                                      std::string name,
                                      ColorOf color_of) {
        method::Layer layer{std::move(name), {frame.view.width_px, frame.view.height_px}};
        if (is_empty()) return layer;
        EachTile sink([&](const raster::Tile& drawn) {
            if (drawn.is_empty) return;
            const raster::Tile tile =
                output_tile(drawn, layer.rgb.width_px(), layer.rgb.height_px());
            for (int y = 0; y < tile.height_px; ++y) {
                const Code* const codes = tile.row<Code>(0, y);
                glm::u8vec3* const to = layer.rgb.row(tile.y0_px + y) + tile.x0_px;
                std::transform(codes, codes + tile.width_px, to, color_of);
            }
        });
        (void)draw(frame, false, sink);
        inputs().forget_image();
        return layer;
    }

  protected:
    /// `flat_gives_zero`: whether a stencil inside one triangle certainly gives 0.
    ConstantPass(const InputParams& params,
                 const raster::PassFormat& format,
                 std::uint32_t sky,
                 bool flat_gives_zero = false)
        : SurfacePass(params, format), sky_(sky), flat_gives_zero_(flat_gives_zero) {}

    /// One per triangle of the scene, by global index.
    [[nodiscard]] virtual std::vector<std::uint32_t> constants_of(
        const scene::PreparedScene& scene) = 0;
    /// Whether a scene that moved has other constants.
    [[nodiscard]] virtual bool follows(const scene::Scene& scene) const { return !scene.animation; }
    /// Makes what depends on the view that was seen.
    virtual void follow_view(const method::Frame& /*frame*/) {}

    void take(std::vector<std::uint32_t> constants);
    /// What draw() draws: of the frame as it is seen now, once.
    [[nodiscard]] raster::MeshInput see(const method::Frame& frame, bool may_leave_out);

  private:
    void order_constants(const raster::LaneMesh& mesh);

    std::uint32_t sky_;
    bool flat_gives_zero_;
    std::vector<std::uint32_t> constants_;
    std::vector<std::uint8_t> in_clusters_;  ///< as bytes; empty: to be put in order again
    std::uint64_t posed_hash_ = 0;           ///< of the scene that they were made from
    bool have_changed_ = false;              ///< since the last draw: then no tile is still
};

/// A format that stores nothing but a constant.
[[nodiscard]] raster::PassFormat constant_format(raster::Store store,
                                                 raster::DepthFormat depth,
                                                 int halo_px);

/// The inputs of a pass that reads no normals; those of patches leave corners shared.
template <class P>
[[nodiscard]] InputParams constant_inputs(const P& params) {
    InputParams inputs;
    inputs.normals = scene::NormalSource::patch;
    inputs.crease_deg = params.crease_deg;
    inputs.depth_format = params.depth_format;
    if constexpr (requires { params.samples; }) inputs.samples = params.samples;
    return inputs;
}

}  // namespace ink::buffers
