// After MOTE's plane of depth: a label of the smooth patch plus a plane of depth, modulo the range
// of one or two bytes,
//
//     code = (floor(range_depth d) + label) mod 2^bits
//
// and a Laplacian of four neighbours, the short way round. Creases and seams change the label,
// occlusions the depth, and a plane is silent whatever it is added to.

#include <cstdint>
#include <glm/trigonometric.hpp>
#include <vector>

#include "buffers/constant_pass.h"
#include "buffers/packed_sink.h"
#include "buffers/surface_method.h"
#include "buffers/surface_values.h"
#include "methods/surface_codes/patch_labels.h"

namespace ink::methods {
namespace {

enum class Bits { eight, sixteen };

struct LabelPlaneParams {
    Bits bits = Bits::eight;
    double range_depth = 255;
    double crease_deg = 40;
    double weld_epsilon = 1e-4;  // as `ids` has it
    method::RangeSource depth_range = method::RangeSource::fit;
    raster::Interpolation interpolation = raster::Interpolation::affine;
    raster::DepthFormat depth_format = raster::DepthFormat::q32;
    edge::Response response = edge::Response::absolute;
    int clip_bits = 2;
    int threshold = 4;
};

buffers::CodeLayout layout(const LabelPlaneParams& params) {
    const bool is_byte = params.bits == Bits::eight;
    return {.store = is_byte ? raster::Store::u8 : raster::Store::u16,
            .planes = 1,
            .fields = {{.ranges = {.depth = params.range_depth}, .bits = is_byte ? 8 : 16}}};
}

raster::PassFormat pass_format(const LabelPlaneParams& params) {
    raster::PassFormat format =
        buffers::constant_format(layout(params).store, params.depth_format, 1);
    format.interpolants = 1;
    format.overflow = raster::Overflow::wrap;
    format.interpolation = params.interpolation;
    return format;
}

buffers::InputParams input_params(const LabelPlaneParams& params) {
    buffers::InputParams inputs = buffers::constant_inputs(params);
    inputs.depth_range = params.depth_range;
    inputs.interpolation = params.interpolation;
    return inputs;
}

/// A scene drawn as labels, to which a plane of depth is added.
class LabelPass : public buffers::ConstantPass {
  public:
    explicit LabelPass(const LabelPlaneParams& params)
        // |L| <= 2 inside a triangle: two clipped bits leave nothing of it.
        : ConstantPass(
              input_params(params),
              pass_format(params),
              0,
              params.interpolation == raster::Interpolation::affine && params.clip_bits >= 2),
          params_(params) {}

    using ConstantPass::see;

  protected:
    /// A label per triangle; those without area have label 0 and cover nothing.
    [[nodiscard]] std::vector<std::uint32_t> constants_of(
        const scene::PreparedScene& scene) override {
        const auto smooth = make_smooth_mesh(
            scene,
            {.crease_rad = glm::radians(params_.crease_deg), .weld_epsilon = params_.weld_epsilon});
        const SmoothMesh& mesh = *smooth;
        const int bits = params_.bits == Bits::eight ? 8 : 16;
        // Apart by the threshold and what rounding may add: |L| <= 2 on a plane.
        const std::vector<std::uint32_t> of_faces =
            patch_labels(mesh, {.bits = bits, .least_difference = params_.threshold + 3});
        const auto faces = faces_of_triangles(scene, mesh, params_.weld_epsilon);
        const std::vector<std::uint32_t>& face_of = *faces;
        std::vector<std::uint32_t> labels(face_of.size(), 0);
        for (std::size_t t = 0; t < labels.size(); ++t) {
            if (face_of[t] != SmoothMesh::kNone) labels[t] = of_faces[face_of[t]];
        }
        return labels;
    }

  private:
    LabelPlaneParams params_;
};

class LabelPlane : public buffers::SurfaceMethod<LabelPass> {
  public:
    using Params = LabelPlaneParams;
    static constexpr bool kDrawsByThreshold = true;

    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table.choice(&Params::bits, "bits", {"8", "16"}, "Bits of a code.")
            .number(&Params::range_depth,
                    "range_depth",
                    {0, 65535},
                    "code",
                    "Codes that depth 0..1 spans, modulo the code's range.");
        buffers::add_depth_range_param(buffers::add_patch_params(table, "patches"));
        buffers::add_depth_format_param(buffers::add_interpolation_param(table))
            .choice(&Params::response,
                    "response",
                    {"absolute", "positive"},
                    "|L|, or its positive half (one pixel wide).")
            .number(&Params::clip_bits,
                    "clip_bits",
                    {0, 7},
                    "bits",
                    "Low bits of the response cleared.");
        return method::add_threshold(table);
    }
    explicit LabelPlane(const Params& params)
        : SurfaceMethod(params),
          params_(params),
          packer_(layout(params),
                  buffers::DepthSign::near_high,
                  buffers::Quantise::sum,
                  raster::Overflow::wrap) {}

    /// `packed`: the codes, black to white over their bits; `filtered`: the response.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        const int width_px = frame.view.width_px;
        const int height_px = frame.view.height_px;
        buffers::FrameCodes codes(1, {width_px, height_px, std::uint16_t{0}});
        edge::EdgeImage edge_responses(width_px, height_px);
        if (!pass().is_empty()) (void)draw_to(frame, edge_responses, &codes);
        return {{"packed", buffers::code_image(codes, packer_.layout()), std::move(codes)},
                {"filtered", buffers::response_image(edge_responses, params_.threshold)}};
    }

  private:
    /// Draws the scene that is there; with `codes` all of it, and keeps them.
    raster::SkipCounts draw_to(const method::Frame& frame,
                               edge::EdgeImage& out,
                               buffers::FrameCodes* codes) {
        raster::MeshInput input = pass().see(frame, codes == nullptr);
        buffers::SurfaceInputs& inputs = pass().inputs();
        const method::DepthCarrier carrier(
            raster::DepthEncoding::inverse, params_.interpolation, inputs.range());
        const buffers::PackedFilter filter{
            .wraps = true,
            .response = {.response = params_.response, .clip_bits = params_.clip_bits}};
        const buffers::LinearValues values(
            {buffers::linear_code(inputs.linear_channels(),
                                  packer_.layout().fields.front().ranges,
                                  buffers::DepthSign::near_high)},
            false);
        input.values = &values;
        buffers::PackedSink sink(packer_, carrier, filter, out);
        if (codes != nullptr) sink.keep_codes(*codes);
        const raster::MeshResult result = pass().SurfacePass::draw(input, sink);
        inputs.finish(result, out);
        return result.skips;
    }
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override {
        return draw_to(frame, out, nullptr);
    }
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        return {params_.bits == Bits::eight ? 1.0 : 2.0, 1};
    }

    Params params_;
    buffers::Packer packer_;
};

}  // namespace

method::MethodInfo label_plane_method() {
    return method::method_info<LabelPlane>("label_plane");
}

}  // namespace ink::methods
