#include "buffers/layer_pictures.h"

#include <algorithm>
#include <cassert>

namespace ink::buffers {
namespace {

std::uint8_t byte_of(int code, const Field& field) {
    const int most = (1 << field.bits) - 1;
    return static_cast<std::uint8_t>((code >> field.shift & most) * 255 / most);
}

}  // namespace

core::Image<glm::u8vec3> code_picture(const FrameCodes& codes, const CodeLayout& layout) {
    assert(static_cast<int>(codes.size()) == layout.planes);
    const std::vector<Field>& fields = layout.fields;
    const std::size_t first = fields.size() > 3 ? fields.size() - 3 : 0;
    core::Image<glm::u8vec3> picture(codes[0].width_px(), codes[0].height_px());
    for (std::size_t i = first; i < fields.size(); ++i) {
        const auto& plane = codes[static_cast<std::size_t>(fields[i].plane)];
        const auto channel = static_cast<int>(i - first);
        for (std::size_t at = 0; at < picture.size(); ++at)
            picture.data()[at][channel] = byte_of(plane.data()[at], fields[i]);
    }
    if (fields.size() == 1) {
        for (std::size_t at = 0; at < picture.size(); ++at)
            picture.data()[at] = glm::u8vec3(picture.data()[at].x);
    }
    return picture;
}

core::Image<glm::u8vec3> strength_picture(const edge::EdgeImage& strengths, int threshold) {
    assert(threshold >= 1 && threshold <= 255);
    core::Image<glm::u8vec3> picture(strengths.width_px(), strengths.height_px());
    std::transform(
        strengths.data(), strengths.data() + strengths.size(), picture.data(), [&](int strength) {
            return glm::u8vec3(
                static_cast<std::uint8_t>(std::min(strength * 128 / threshold, 255)));
        });
    return picture;
}

}  // namespace ink::buffers
