#include "shade/compose.h"

#include <cassert>
#include <utility>

namespace ink::shade {
namespace {

std::uint8_t to_8_bit(float brightness) {
    if (!(brightness > 0)) return 0;
    return brightness >= 1 ? 255 : static_cast<std::uint8_t>(brightness * 255 + 0.5F);
}

}  // namespace

core::Image<Rgb> to_8_bit(const core::Image<glm::vec3>& picture) {
    core::Image<Rgb> result(picture.width_px(), picture.height_px());
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const glm::vec3& from = picture.data()[i];
        result.data()[i] = {to_8_bit(from.r), to_8_bit(from.g), to_8_bit(from.b)};
    }
    return result;
}

core::Image<Rgb> compose(const core::Image<std::uint8_t>& strengths,
                         core::Image<Rgb> picture,
                         const Ink& ink) {
    assert(strengths.width_px() == picture.width_px());
    assert(strengths.height_px() == picture.height_px());
    for (std::size_t i = 0; i < strengths.size(); ++i) {
        if (strengths.data()[i] >= ink.threshold) picture.data()[i] = ink.color;
    }
    return picture;
}

core::Image<Rgb> compose(const core::Image<std::uint8_t>& strengths,
                         const Rgb& paper,
                         const Ink& ink) {
    return compose(
        strengths, core::Image<Rgb>(strengths.width_px(), strengths.height_px(), paper), ink);
}

}  // namespace ink::shade
