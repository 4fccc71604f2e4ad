#pragma once

#include <glm/vec3.hpp>
#include <string_view>

#include "truth/line_class.h"

namespace ink::lab {

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
inline constexpr Colour kMissingColour = kVermilion;
inline constexpr Colour kFalseColour = kBlue;
inline constexpr Colour kIgnoredColour = kMist;

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

}  // namespace ink::lab
