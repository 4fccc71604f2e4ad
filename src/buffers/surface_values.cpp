#include "buffers/surface_values.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace ink::buffers {
namespace {

std::uint8_t byte_of(int code, const Field& field) {
    const int most = (1 << field.bits) - 1;
    return static_cast<std::uint8_t>((code >> field.shift & most) * 255 / most);
}

}  // namespace

raster::LinearValue linear_code(const LinearChannels& channels,
                                const Ranges& ranges,
                                DepthSign sign) {
    const bool is_near_high = sign == DepthSign::near_high;
    const double per_depth = is_near_high ? ranges.depth : -ranges.depth;
    raster::LinearValue code;
    code.base =
        0.5 + ranges.offset + (is_near_high ? 0 : ranges.depth) + per_depth * channels.depth.base;
    code.per_q = per_depth * channels.depth.per_q;
    for (int i = 0; i < 3; ++i) {
        const double half = ranges.normal[i] / 2;
        code.base += half;
        for (int axis = 0; axis < 3; ++axis) {
            code.per_normal[axis] += static_cast<float>(half * channels.normal[i].per_normal[axis]);
        }
    }
    return code;
}

LinearValues::LinearValues(std::vector<raster::LinearValue> values, bool reads_all)
    : values_(std::move(values)), reads_all_(reads_all) {}

void LinearValues::compute(const raster::CornerBatch& in, const raster::CornerPlanes& out) const {
    raster::compute_linear(values_.data(), static_cast<int>(values_.size()), reads_all_, in, out);
}

std::uint64_t LinearValues::unread_channels() const {
    bool reads_depth = false;
    bool reads_normal = false;
    for (const raster::LinearValue& value : values_) {
        reads_depth = reads_depth || value.per_q != 0;
        for (const float weight : value.per_normal)
            reads_normal = reads_normal || weight != 0;
    }
    return (reads_depth ? 0U : 1U) + (reads_normal ? 0U : 3U);
}

ChannelValues::ChannelValues(const SurfaceInputs& inputs, const method::DepthCarrier& carrier)
    : carrier_(carrier) {
    const LinearChannels channels = inputs.linear_channels();
    linear_[0] = channels.depth;
    for (std::size_t i = 0; i < 3; ++i)
        linear_[i + 1] = channels.normal[i];
}

void ChannelValues::compute(const raster::CornerBatch& in, const raster::CornerPlanes& out) const {
    raster::compute_linear(linear_, 4, false, in, out);
    if (carrier_.is_affine()) return;  // 1/w is what an affine carrier carries
    for (std::size_t i = 0; i < in.count; ++i) {
        const float depth = carrier_.at_vertex(in.w[i]);
        out.front[0][i] = depth;
        if (out.back[0] != nullptr) out.back[0][i] = depth;
    }
}

CodeValues::CodeValues(const SurfaceInputs& inputs,
                       const Packer& packer,
                       raster::DepthEncoding encoding)
    : packer_(packer),
      encoding_(encoding),
      range_(inputs.range()),
      view_from_world_(inputs.view_from_world()) {}

void CodeValues::compute(const raster::CornerBatch& in, const raster::CornerPlanes& out) const {
    for (std::size_t i = 0; i < in.count; ++i) {
        const double depth = method::encode_limited(encoding_, in.w[i], range_);
        const glm::dvec3 n =
            view_from_world_ * glm::vec3(in.n_world[0][i], in.n_world[1][i], in.n_world[2][i]);
        for (int plane = 0; plane < packer_.layout().planes; ++plane) {
            out.front[plane][i] = static_cast<float>(packer_.at_vertex(plane, depth, n));
            if (out.back[plane] != nullptr)
                out.back[plane][i] = static_cast<float>(packer_.at_vertex(plane, depth, -n));
        }
    }
}

core::Image<glm::u8vec3> code_image(const FrameCodes& codes, const CodeLayout& layout) {
    assert(static_cast<int>(codes.size()) == layout.planes);
    const std::vector<Field>& fields = layout.fields;
    const std::size_t first = fields.size() > 3 ? fields.size() - 3 : 0;
    core::Image<glm::u8vec3> image(codes[0].width_px(), codes[0].height_px());
    for (std::size_t i = first; i < fields.size(); ++i) {
        const auto& plane = codes[static_cast<std::size_t>(fields[i].plane)];
        const auto channel = static_cast<int>(i - first);
        for (std::size_t at = 0; at < image.size(); ++at)
            image.data()[at][channel] = byte_of(plane.data()[at], fields[i]);
    }
    if (fields.size() == 1) {
        for (std::size_t at = 0; at < image.size(); ++at)
            image.data()[at] = glm::u8vec3(image.data()[at].x);
    }
    return image;
}

core::Image<glm::u8vec3> response_image(const edge::EdgeImage& edge_responses, int threshold) {
    assert(threshold >= 1 && threshold <= 255);
    return core::mapped<glm::u8vec3>(edge_responses, [&](int edge_response) {
        return glm::u8vec3(
            static_cast<std::uint8_t>(std::min(edge_response * 128 / threshold, 255)));
    });
}

}  // namespace ink::buffers
