#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/score/images.h"
#include "truth/curve.h"

/// True lines made by hand, and images drawn from them.
using Curves = std::vector<ink::truth::Curve>;

inline ink::truth::Curve curve(double x0,
                               double y0,
                               double x1,
                               double y1,
                               ink::truth::LineClass line_class = ink::truth::LineClass::crease) {
    return {.line_class = line_class, .begin = {x0, y0, 1}, .end = {x1, y1, 1}};
}

/// A circle as a polygon, clockwise on the image (y down), its outside empty.
inline Curves circle(double x, double y, double radius, int sides) {
    Curves curves;
    const auto corner = [&](int i) {
        const double turn = 2 * std::numbers::pi * i / sides;
        return ink::truth::CurvePoint{x + radius * std::cos(turn), y + radius * std::sin(turn), 1};
    };
    for (int i = 0; i < sides; ++i) {
        ink::truth::Curve c = curve(0, 0, 0, 0, ink::truth::LineClass::contour);
        c.begin = corner(i);
        c.end = corner(i + 1);
        c.empty_side = -1;
        curves.push_back(c);
    }
    return curves;
}

/// Every pixel for which `is_on(x, y)` holds at its centre.
template <class IsOn>
Image drawn_where(int width_px, int height_px, IsOn is_on) {
    Image image(width_px, height_px);
    for (int y = 0; y < height_px; ++y) {
        for (int x = 0; x < width_px; ++x)
            image.at(x, y) = is_on(x + 0.5, y + 0.5) ? 1 : 0;
    }
    return image;
}
