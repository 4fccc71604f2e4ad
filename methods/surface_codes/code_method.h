#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "buffers/constant_pass.h"
#include "buffers/surface_method.h"
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
    double length_px = 0;  ///< that a step covers at least, by the footprint
    int gain_bits = 0;     ///< of the response, see edge::side_differences
};

/// A scene drawn as surface codes, u8 or u16 in plane 0, 0 where nothing is.
class CodePass : public buffers::ConstantPass {
  public:
    CodePass(const CodeParams& params, const CodeSetup& setup);

  protected:
    [[nodiscard]] std::vector<std::uint32_t> constants_of(
        const scene::PreparedScene& scene) override;
    void follow_view(const method::Frame& frame) override;

  private:
    [[nodiscard]] std::string name_of_codes() const;

    CodeParams params_;
    CodeSetup setup_;
    SurfaceCodes surface_codes_;
    std::vector<float> lengths_world_;  ///< of the last view, per triangle
};

/// A byte or two a triangle, nothing interpolated: a line wherever the codes of neighbouring
/// samples differ.
///
/// What surface8, surface16 and label8 share: they differ in their codes alone.
class CodeMethod : public buffers::SurfaceMethod<CodePass> {
  public:
    CodeMethod(const CodeParams& params, const CodeSetup& setup)
        : SurfaceMethod(params, setup), samples_(params.samples), setup_(setup) {}

    /// `codes`: black where nothing is, dark to white; of two bytes, in red and green.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override;
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        return {static_cast<double>(setup_.bytes), 1};
    }

    buffers::Samples samples_;
    CodeSetup setup_;
};

}  // namespace ink::methods
