#pragma once

#include <glm/vec3.hpp>
#include <string_view>

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
inline constexpr Colour kSky{{86, 180, 233}, "#56b4e9"};
inline constexpr Colour kGreen{{0, 158, 115}, "#009e73"};
inline constexpr Colour kBlue{{0, 114, 178}, "#0072b2"};
inline constexpr Colour kVermilion{{213, 94, 0}, "#d55e00"};
inline constexpr Colour kPurple{{204, 121, 167}, "#cc79a7"};

// What a pixel of an error picture is.
inline constexpr Colour kHitColour = kInk;
inline constexpr Colour kIgnoredColour = kMist;

/// The colour of a cause: missing lines warm, false ones cool.
///
/// Chosen so that those that can stand in one picture stay at least 14 apart in CIE L*a*b*, also
/// with each other, hits, ignored pixels and paper, for normal and for all three kinds of
/// dichromatic sight (Machado, Oliveira and Fernandes 2009). A method has either a declared code or
/// `undeclared` misses, so that colour may come close to `cancelled`.
[[nodiscard]] constexpr Colour colour_of(score::Cause cause) {
    switch (cause) {
        case score::Cause::one_triangle:
            return kBlue;
        case score::Cause::one_patch:
            return {{116, 185, 242}, "#74b9f2"};
        case score::Cause::crack:
            return {{44, 207, 150}, "#2ccf96"};
        case score::Cause::frame:
            return {{42, 31, 176}, "#2a1fb0"};
        case score::Cause::other:
            return {{160, 96, 240}, "#a060f0"};
        case score::Cause::cancelled:
            return kVermilion;
        case score::Cause::below_threshold:
            return {{242, 180, 0}, "#f2b400"};
        case score::Cause::sub_pixel:
            return {{107, 68, 16}, "#6b4410"};
        case score::Cause::thinned:
            return {{238, 51, 119}, "#ee3377"};
        case score::Cause::unexplained:
            return {{138, 21, 96}, "#8a1560"};
        case score::Cause::undeclared:
            return {{217, 138, 58}, "#d98a3a"};
    }
    return kMist;
}

/// The colour of a class in pictures of the truth, in charts and in legends.
[[nodiscard]] constexpr Colour colour_of(truth::LineClass c) {
    switch (c) {
        case truth::LineClass::none:
            return kPaper;
        case truth::LineClass::contour:
            return kInk;
        case truth::LineClass::boundary:
            return kPurple;
        case truth::LineClass::crease:
            return kGreen;
        case truth::LineClass::intersection:
            return kOrange;
        case truth::LineClass::seam:
            return kSky;
        case truth::LineClass::ignore:
            return kMist;
    }
    return kMist;
}

}  // namespace ink::draw
