#include "methods/packed_buffer.h"

#include <glm/trigonometric.hpp>

namespace ink::methods {
namespace {

constexpr int kChannels = 4;  // depth, nx, ny, nz

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
    : params_(params),
      packer_(std::move(layout), params.depth_sign, params.quantise, params.overflow),
      format_(pass_format(params, packer_.layout())),
      inputs_(params) {}

std::optional<LinearCode> PackedBuffer::code() const {
    const CodeLayout& layout = packer_.layout();
    const bool is_one_sum = layout.fields.size() == 1 && params_.quantise == Quantise::sum;
    if (!is_one_sum || params_.fatten) return std::nullopt;
    const Ranges& ranges = layout.fields.front().ranges;
    LinearCode code;
    code.encoding = params_.depth_encoding;
    const bool is_near_high = params_.depth_sign == DepthSign::near_high;
    code.depth_weight = is_near_high ? ranges.depth : -ranges.depth;
    code.offset = is_near_high ? 0 : ranges.depth;
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

void PackedBuffer::pack_vertices(int threads) {
    const auto n_view = inputs_.n_view();
    const auto planes = static_cast<std::size_t>(packer_.layout().planes);
    values_.resize(inputs_.corner_count() * planes);
    values_back_.resize(values_.size());
    for_runs(inputs_.corner_count(), threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const double d = encode_limited(params_.depth_encoding, inputs_.w(i), inputs_.range());
            const glm::dvec3 n = n_view[i];
            for (std::size_t plane = 0; plane < planes; ++plane) {
                const int at = static_cast<int>(plane);
                values_[i * planes + plane] = static_cast<float>(packer_.at_vertex(at, d, n));
                values_back_[i * planes + plane] = static_cast<float>(packer_.at_vertex(at, d, -n));
            }
        }
    });
}

raster::PassInput PackedBuffer::pass_input() const {
    raster::PassInput input = inputs_.pass_input();
    input.values = values_;
    input.values_back = values_back_;
    input.sky_code.fill(static_cast<std::uint32_t>(params_.sky));
    input.sky_f32 = {kNothingDrawn, 0, 0, 0};
    return input;
}

void PackedBuffer::draw(const Frame& frame, edge::EdgeImage& out) {
    if (inputs_.is_empty()) return out.fill(0);
    inputs_.see(frame);
    const DepthCarrier carrier(params_.depth_encoding, params_.interpolation, inputs_.range());
    if (params_.packing == Packing::vertex) {
        pack_vertices(frame.threads);
    } else {
        inputs_.gather_channels(carrier, frame.threads, values_, values_back_);
    }
    const PackedFilter filter{.packing = params_.packing,
                              .renormalise = params_.renormalise,
                              .fatten = params_.fatten,
                              .wraps = params_.overflow == raster::Overflow::wrap,
                              .sky = params_.sky,
                              .response = {.response = params_.response,
                                           .clip_bits = params_.clip_bits,
                                           .scale_bits = params_.scale_bits}};
    PackedSink sink(packer_, carrier, filter, out);
    raster::draw_pass(
        format_, pass_input(), frame.view.width_px, frame.view.height_px, frame.threads, sink);
}

}  // namespace ink::methods
