#include "buffers/layer_images.h"

#include <algorithm>
#include <cassert>

namespace ink::buffers {
namespace {

std::uint8_t byte_of(int code, const Field& field) {
    const int most = (1 << field.bits) - 1;
    return static_cast<std::uint8_t>((code >> field.shift & most) * 255 / most);
}

}  // namespace

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
    core::Image<glm::u8vec3> image(edge_responses.width_px(), edge_responses.height_px());
    std::transform(edge_responses.data(),
                   edge_responses.data() + edge_responses.size(),
                   image.data(),
                   [&](int edge_response) {
                       return glm::u8vec3(static_cast<std::uint8_t>(
                           std::min(edge_response * 128 / threshold, 255)));
                   });
    return image;
}

}  // namespace ink::buffers
