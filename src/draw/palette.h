#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>

#include "core/vocabulary.h"
#include "score/attribution.h"
#include "truth/line_class.h"

namespace ink::draw {

/// A colour, for pictures (bytes) and for pages ("#rrggbb").
struct Colour {
    glm::u8vec3 rgb{0};
    std::string_view hex;
};

// Okabe and Ito, "Color Universal Design", 2008: eight colours that the colour-blind tell apart.
// Black and yellow give way to softer neighbours on white paper.
inline constexpr Colour kPaper{{255, 255, 255}, "#ffffff"};
inline constexpr Colour kInk{{32, 36, 42}, "#20242a"};
inline constexpr Colour kMist{{205, 209, 214}, "#cdd1d6"};
inline constexpr Colour kOrange{{230, 159, 0}, "#e69f00"};
inline constexpr Colour kBlue{{0, 114, 178}, "#0072b2"};
inline constexpr Colour kVermilion{{213, 94, 0}, "#d55e00"};

// What a pixel of an error picture is.
inline constexpr Colour kHitColour = kInk;
inline constexpr Colour kIgnoredColour = kMist;

/// The colour of a word of core/vocabulary.h, from its "#rrggbb".
[[nodiscard]] constexpr Colour colour_of(const core::Term& term) {
    const auto byte = [&](std::size_t at) {
        int value = 0;
        for (const char digit : term.picture.substr(at, 2))
            value = 16 * value + (digit <= '9' ? digit - '0' : digit - 'a' + 10);
        return static_cast<std::uint8_t>(value);
    };
    return {{byte(1), byte(3), byte(5)}, term.picture};
}

/// The colour of a cause: missing lines warm, false ones cool.
///
/// Chosen so that those that can stand in one picture stay at least 14 apart in CIE L*a*b*, also
/// with each other, hits, ignored pixels and paper, for normal and for all three kinds of
/// dichromatic sight (Machado, Oliveira and Fernandes 2009). A method has either a declared code or
/// `undeclared` misses, so that colour may come close to `cancelled`.
[[nodiscard]] inline Colour colour_of(score::Cause cause) {
    return colour_of(core::vocabulary().causes[static_cast<std::size_t>(cause)]);
}

/// The colour of a class in pictures of the truth; kPaper for no line, kMist for `ignore`.
[[nodiscard]] inline Colour colour_of(truth::LineClass c) {
    if (c == truth::LineClass::none) return kPaper;
    const auto classes = core::vocabulary().classes;
    const std::size_t at = static_cast<std::size_t>(c) - 1;
    return at < classes.size() ? colour_of(classes[at]) : kMist;
}

}  // namespace ink::draw
