#include "linear_code/channel_planes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "edge/laplacian.h"
#include "harness/truths/truth_code.h"

namespace ink::linear_code {
namespace {

/// The code's inputs with every weight 1 and no offset.
method::LinearCode unit_code(const method::LinearCode& code) {
    method::LinearCode unit;
    unit.encoding = code.encoding;
    unit.inputs = code.inputs;
    unit.depth_weight = 1;
    std::fill(std::begin(unit.normal_weight), std::end(unit.normal_weight), 1.0);
    return unit;
}

/// A sum as a code: in floats throughout, so that the loop goes through vector registers.
template <bool kWraps>
void round_row(const float* sums, std::uint16_t* codes, int width, int bits) {
    const int max = (1 << bits) - 1;
    for (int x = 0; x < width; ++x) {
        if constexpr (kWraps) {
            const auto rounded = static_cast<long>(std::floor(sums[x]));
            codes[x] = static_cast<std::uint16_t>(rounded & max);
        } else {
            const float limited = std::min(std::max(sums[x], 0.0F), static_cast<float>(max));
            codes[x] = static_cast<std::uint16_t>(static_cast<int>(limited));
        }
    }
}

}  // namespace

ChannelSource::ChannelSource(const scene::Scene& scene, const method::LinearCode& code)
    : unit_code_(unit_code(code)),
      surface_(scene::flatten(scene, code.inputs.normals, code.inputs.crease_rad)),
      bounds_(scene::bounding_sphere(scene)) {}

ChannelPlanes ChannelSource::planes(const scene::View& view,
                                    const core::Image<std::uint32_t>& triangle) const {
    assert(triangle.width_px() == view.width_px && triangle.height_px() == view.height_px);
    const harness::TruthCode code(surface_, bounds_, view, unit_code_);
    ChannelPlanes planes;
    for (core::Image<float>& channel : planes.channels)
        channel = {view.width_px, view.height_px};
    planes.is_sky = edge::Mask(view.width_px, view.height_px);
    for (int y = 0; y < view.height_px; ++y) {
        for (int x = 0; x < view.width_px; ++x) {
            const std::uint32_t seen = triangle.at(x, y);
            planes.is_sky.at(x, y) = seen == truth::kNoTriangle;
            if (seen == truth::kNoTriangle) continue;
            const harness::PixelCode pixel = code.at(x, y, seen);
            for (std::size_t k = 0; k < pixel.channels.size(); ++k)
                planes.channels[k].at(x, y) = static_cast<float>(pixel.channels[k]);
        }
    }
    return planes;
}

core::Image<std::uint16_t> codes_of(const ChannelPlanes& planes, const method::LinearCode& code) {
    const int width = planes.width_px();
    core::Image<std::uint16_t> codes(width, planes.height_px());
    std::vector<float> sums(static_cast<std::size_t>(width));
    const std::array<float, 4> w = {static_cast<float>(code.depth_weight),
                                    static_cast<float>(code.normal_weight[0]),
                                    static_cast<float>(code.normal_weight[1]),
                                    static_cast<float>(code.normal_weight[2])};
    const auto base = static_cast<float>(code.offset + 0.5);
    for (int y = 0; y < planes.height_px(); ++y) {
        const float* c0 = planes.channels[0].row(y);
        const float* c1 = planes.channels[1].row(y);
        const float* c2 = planes.channels[2].row(y);
        const float* c3 = planes.channels[3].row(y);
        for (int x = 0; x < width; ++x)
            sums[static_cast<std::size_t>(x)] =
                base + w[0] * c0[x] + w[1] * c1[x] + w[2] * c2[x] + w[3] * c3[x];
        const auto round = code.wraps ? round_row<true> : round_row<false>;
        round(sums.data(), codes.row(y), width, code.bits);
        const std::uint8_t* is_sky = planes.is_sky.row(y);
        const auto sky = static_cast<std::uint16_t>(code.sky_code);
        for (int x = 0; x < width; ++x)
            codes.row(y)[x] = is_sky[x] != 0 ? sky : codes.row(y)[x];
    }
    return codes;
}

edge::EdgeImage responses_of(const ChannelPlanes& planes, const method::LinearCode& code) {
    const core::Image<std::uint16_t> codes = codes_of(planes, code);
    edge::EdgeImage edge_responses(codes.width_px(), codes.height_px());
    const int width = codes.width_px() - 2;
    const int height = codes.height_px() - 2;
    if (width <= 0 || height <= 0) return edge_responses;
    const core::ImageView<const std::uint16_t> inner{
        codes.row(1) + 1, width, height, codes.width_px()};
    const core::ImageView<std::uint8_t> out{
        edge_responses.row(1) + 1, width, height, edge_responses.width_px()};
    edge::laplacian(inner, out, code.response, 1);
    return edge_responses;
}

}  // namespace ink::linear_code
