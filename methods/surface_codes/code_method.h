#pragma once

#include <cstdint>
#include <glm/trigonometric.hpp>
#include <vector>

#include "buffers/constant_pass.h"
#include "buffers/surface_method.h"
#include "edge/side_differences.h"
#include "methods/surface_codes/surface_codes.h"

namespace ink::methods {

/// Where the length comes from that a step of a code must cover.
enum class Footprint {
    none,    ///< nowhere: the surface's turning alone makes steps
    object,  ///< the largest object, as if it filled the height of 720 px
    view,    ///< every triangle's distance in the frame: codes are made again for each view
};

/// The parameters of whatever draws one code a triangle.
struct CodeParams {
    double crease_deg = 40;
    double weld_epsilon = 1e-4;  // as `ids` has it
    buffers::Samples samples = buffers::Samples::corner;
    raster::DepthFormat depth_format = raster::DepthFormat::q32;
    int threshold = 128;
};

/// Appends the rows of CodeParams but `threshold` to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_code_params(core::ParamTable<P>& table) {
    return buffers::add_depth_format_param(
        buffers::add_samples_param(buffers::add_patch_params(table, "codes")));
}

/// How codes are made and looked at.
struct CodeSetup : CodeOptions {
    Footprint footprint = Footprint::none;
    double length_px = 0;      ///< that a step covers at least, by the footprint
    bool is_repaired = false;  ///< see repaired_codes(); such codes follow no view
    int gain_bits = 0;         ///< of the response, see edge::side_differences
    int halo_px = 1;           ///< that whoever adds lines reads
};

/// How the labels of label8 are made and looked at.
[[nodiscard]] inline CodeSetup label_setup() {
    CodeSetup setup;
    setup.range = {.lowest = 1, .highest = 255, .least_difference = 1};  // sky is 0
    setup.gain_bits = 8;                                                 // any difference is a line
    return setup;
}

/// What SurfaceCodes::object_codes is to take for a setup: no length if steps follow no object.
[[nodiscard]] inline double object_length_px(const CodeSetup& setup) {
    return setup.footprint == Footprint::object ? setup.length_px : 0;
}

/// How the codes of a method are made.
[[nodiscard]] CodeOptions code_options(const CodeParams& params, const CodeSetup& setup);

/// A scene drawn as surface codes, u8 in plane 0, 0 where nothing is.
class CodePass : public buffers::ConstantPass {
  public:
    CodePass(const CodeParams& params, const CodeSetup& setup);

  protected:
    [[nodiscard]] std::vector<std::uint32_t> constants_of(
        const scene::PreparedScene& scene) override;
    void follow_view(const method::Frame& frame) override;

  private:
    CodeParams params_;
    CodeSetup setup_;
    SurfaceCodes surface_codes_;
    std::vector<float> lengths_world_;  ///< of the last view, per triangle
};

/// A byte a triangle, nothing interpolated: a line wherever the codes of neighbouring samples
/// differ.
///
/// What label8, surface8 and surface8_depth share.
class CodeMethod : public buffers::SurfaceMethod<CodePass> {
  public:
    CodeMethod(const CodeParams& params, const CodeSetup& setup)
        : SurfaceMethod(params, setup), samples_(params.samples), gain_bits_(setup.gain_bits) {}

    /// `codes`: black where nothing is, dark to white.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;

  protected:
    [[nodiscard]] method::PixelBytes filter_bytes() const override { return {1, 1}; }
    /// Adds to a tile's edge responses what other than its codes tells lines.
    virtual void add_lines(const raster::Tile& /*tile*/,
                           edge::Sides /*sides*/,
                           const core::ImageView<std::uint8_t>& /*out*/) const {}

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override;
    void draw_tile(const raster::Tile& drawn, edge::EdgeImage& out) const;

    buffers::Samples samples_;
    int gain_bits_;
};

/// The parameters of whatever draws codes of surface distance.
struct SurfaceCodeParams : CodeParams {
    double turn_deg = 5;
    Footprint footprint = Footprint::object;
    double length_px = 2;
    int rounds = 10;
};

/// Appends the rows of SurfaceCodeParams to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_surface_code_params(core::ParamTable<P>& table) {
    table
        .number(&P::turn_deg,
                "turn_deg",
                {0.1, 180},
                "deg",
                "Turning of the normal from one triangle to the next that makes a whole step.")
        .choice(&P::footprint,
                "footprint",
                {"none", "object", "view"},
                "What limits steps by length: nothing, the largest object's size, or the view.")
        .number(&P::length_px,
                "length_px",
                {0, 100},
                "px",
                "Least length of a step on the image, by the footprint; 0: no limit.")
        .number(&P::rounds,
                "rounds",
                {0, 100},
                "",
                "Rounds of parting the two sides of creases that end inside a patch.");
    return method::add_threshold(
        add_code_params(table),
        "Least edge response of a line pixel: 64 for each step between codes.");
}

/// How codes of surface distance are made and looked at.
[[nodiscard]] inline CodeSetup surface_setup(const SurfaceCodeParams& params) {
    CodeSetup setup;
    setup.turn_rad = glm::radians(params.turn_deg);
    setup.rounds = params.rounds;
    setup.range = {.lowest = 2, .highest = 255, .least_difference = 2};  // sky is 0
    setup.footprint = params.footprint;
    setup.length_px = params.length_px;
    setup.gain_bits = 6;  // a difference of 2, the least that is a line, is 128
    return setup;
}

}  // namespace ink::methods
