#include "buffers/packed_buffer.h"

#include <glm/trigonometric.hpp>

#include "buffers/surface_values.h"

namespace ink::buffers {
namespace {

raster::PassFormat pass_format(const PackParams& params, const CodeLayout& layout) {
    raster::PassFormat format;
    const bool at_vertices = params.packing == Packing::vertex;
    format.interpolants = at_vertices ? layout.planes : kChannels;
    format.store = at_vertices ? layout.store : raster::Store::f32;
    format.overflow = params.overflow;
    format.interpolation = params.interpolation;
    format.depth = params.depth_format;
    format.halo_px = params.fatten ? 2 : 1;
    return format;
}

}  // namespace

PackedBuffer::PackedBuffer(const PackParams& params, CodeLayout layout)
    : SurfaceMethod(params, pass_format(params, layout)),
      params_(params),
      packer_(std::move(layout), params.depth_sign, params.quantise, params.overflow) {}

std::optional<method::LinearCode> PackedBuffer::code() const {
    const CodeLayout& layout = packer_.layout();
    const bool is_one_sum = layout.fields.size() == 1 && params_.quantise == Quantise::sum;
    if (!is_one_sum || params_.fatten) return std::nullopt;
    const Ranges& ranges = layout.fields.front().ranges;
    method::LinearCode code;
    code.encoding = params_.depth_encoding;
    const bool is_near_high = params_.depth_sign == DepthSign::near_high;
    code.depth_weight = is_near_high ? ranges.depth : -ranges.depth;
    code.offset = ranges.offset + (is_near_high ? 0 : ranges.depth);
    for (int i = 0; i < 3; ++i)
        code.normal_weight[i] = ranges.normal[i];
    code.bits = layout.bits();
    code.wraps = params_.overflow == raster::Overflow::wrap;
    code.sky_code = params_.sky;
    code.inputs = {.normals = params_.normals,
                   .crease_rad = glm::radians(params_.crease_deg),
                   .depth_range = params_.depth_range,
                   .interpolation = params_.interpolation,
                   .at_vertices = params_.packing == Packing::vertex,
                   .renormalise = params_.renormalise};
    code.response = {.response = params_.response,
                     .clip_bits = params_.clip_bits,
                     .scale_bits = params_.scale_bits,
                     .code_bits = layout.bits(),
                     .code_wraps = code.wraps};
    return code;
}

/// Whether every plane is one sum of depth and normal that nothing rounds before the pass does.
bool PackedBuffer::has_linear_codes() const {
    return params_.packing == Packing::vertex && !packer_.layout().has_bit_fields() &&
           params_.quantise == Quantise::sum &&
           params_.depth_encoding == raster::DepthEncoding::inverse;
}

/// |L| <= 2 on a plane: two clipped bits leave nothing of it. A wrapped L of -1 is a strong line,
/// and a blur of codes is no longer a code rounded once.
bool PackedBuffer::flat_gives_zero() const {
    return params_.packing == Packing::vertex && !packer_.layout().has_bit_fields() &&
           params_.interpolation == raster::Interpolation::affine && !params_.fatten &&
           params_.response != edge::Response::wrap && params_.clip_bits >= 2;
}

/// What the pass asks at vertices; `unread` becomes the number of channels that need not be read.
std::unique_ptr<raster::CornerValues> PackedBuffer::corner_values(bool reads_all,
                                                                  std::uint64_t& unread) const {
    const CodeLayout& layout = packer_.layout();
    if (params_.packing == Packing::pixel) {
        const method::DepthCarrier carrier(
            params_.depth_encoding, params_.interpolation, pass().inputs().range());
        return std::make_unique<ChannelValues>(pass().inputs(), carrier);
    }
    if (!has_linear_codes()) {
        return std::make_unique<CodeValues>(pass().inputs(), packer_, params_.depth_encoding);
    }
    std::vector<raster::LinearValue> values;
    const LinearChannels channels = pass().inputs().linear_channels();
    for (const Field& field : layout.fields)
        values.push_back(linear_code(channels, field.ranges, params_.depth_sign));
    auto result = std::make_unique<LinearValues>(std::move(values), reads_all);
    unread = result->unread_channels();
    return result;
}

raster::SkipCounts PackedBuffer::draw_buffer(const method::Frame& frame,
                                             edge::EdgeImage& out,
                                             FrameCodes* codes) {
    SurfaceInputs& inputs = pass().inputs();
    inputs.see(frame);
    const method::DepthCarrier carrier(
        params_.depth_encoding, params_.interpolation, inputs.range());
    const PackedFilter filter{.packing = params_.packing,
                              .renormalise = params_.renormalise,
                              .fatten = params_.fatten,
                              .wraps = params_.overflow == raster::Overflow::wrap,
                              .sky = params_.sky,
                              .response = {.response = params_.response,
                                           .clip_bits = params_.clip_bits,
                                           .scale_bits = params_.scale_bits}};
    const bool skips_attributes = frame.skips.has(raster::Skip::attributes);
    std::uint64_t unread = 0;
    const auto values = corner_values(!skips_attributes, unread);
    raster::MeshInput input = inputs.mesh_input(frame);
    input.values = values.get();
    input.sky_code.fill(static_cast<std::uint32_t>(params_.sky));
    input.sky_f32 = {method::kNothingDrawn, 0, 0, 0};
    input.flat_gives_zero = flat_gives_zero();
    PackedSink sink(packer_, carrier, filter, out);
    if (codes) {
        input.flat_gives_zero = false;
        input.may_keep_still = false;
        sink.keep_codes(*codes);
    }
    const raster::MeshResult result = pass().draw(input, sink);
    inputs.finish(result, out);
    raster::SkipCounts counts = result.skips;
    raster::SkipCount& attributes = raster::count_of(counts, raster::Skip::attributes);
    attributes.of = kChannels;
    if (skips_attributes) attributes.skipped = unread;
    return counts;
}

std::vector<method::Layer> PackedBuffer::layers(const method::Frame& frame) {
    const int width_px = frame.view.width_px;
    const int height_px = frame.view.height_px;
    const auto planes = static_cast<std::size_t>(packer_.layout().planes);
    FrameCodes codes(planes, {width_px, height_px, static_cast<std::uint16_t>(params_.sky)});
    edge::EdgeImage edge_responses(width_px, height_px);
    if (!pass().is_empty()) (void)draw_buffer(frame, edge_responses, &codes);
    return {{"packed", code_image(codes, packer_.layout()), std::move(codes)},
            {"filtered", response_image(edge_responses, params_.threshold)}};
}

/// Four floats a pixel to codes, where these are packed; then the Laplacian of each field, whose
/// edge response joins what is there.
method::PixelBytes PackedBuffer::filter_bytes() const {
    const CodeLayout& layout = packer_.layout();
    const double code = layout.bits() / 8.0;
    const auto fields = static_cast<double>(layout.fields.size());
    const double copies = (layout.has_bit_fields() ? 1 : 0) + (params_.fatten ? 1 : 0);
    method::PixelBytes bytes = fields * method::PixelBytes{(1 + copies) * code, copies * code + 1};
    bytes.read += fields - 1;
    if (params_.packing == Packing::pixel)
        bytes = bytes + method::PixelBytes{4 * sizeof(float), layout.planes * code};
    return bytes;
}

}  // namespace ink::buffers
