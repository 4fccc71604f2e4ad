#pragma once

#include <glm/vec2.hpp>

namespace ink::methods {

/// A straight piece of a line in samples: sample (x, y) lies at
/// (x, y). A round pen draws it, whose radius runs evenly from the one end to the other.
struct Piece {
    glm::dvec2 a{0};
    glm::dvec2 b{0};
    float half_a_px = 0;
    float half_b_px = 0;

    Piece() = default;
    Piece(const glm::dvec2& from, const glm::dvec2& to, float half_from_px, float half_to_px)
        : a(from), b(to), half_a_px(half_from_px), half_b_px(half_to_px) {}
};

}  // namespace ink::methods
