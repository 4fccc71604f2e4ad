#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "methods/mesh_lookup/screen_mesh.h"

namespace ink::methods {

/// What is straight on the image, in samples, with 1/w at its ends, between which that is linear.
struct Segment {
    glm::dvec2 a{0}, b{0};
    double qa = 0, qb = 0;

    [[nodiscard]] glm::dvec2 at(double t) const { return a + t * (b - a); }
    [[nodiscard]] double q_at(double t) const { return qa + t * (qb - qa); }
};

/// What is left of a segment in a cell, as parts of its length.
struct Clipped {
    double from = 0, to = 1;
};

/// An edge between two vertices, not snapped; of one that reaches before the near plane what lies
/// beyond.
[[nodiscard]] std::optional<Segment> edge_segment(const ScreenMesh& screen,
                                                  std::uint32_t a,
                                                  std::uint32_t b);

/// Where two faces are equally far, about as long as two cells, near `at`; nothing if that is
/// nowhere near.
[[nodiscard]] std::optional<Segment> intersection_segment(const ScreenMesh& screen,
                                                          std::uint32_t face,
                                                          std::uint32_t other,
                                                          const glm::dvec2& at);

/// 1/w of a face's plane at a place; 0 of one that is seen edge-on.
[[nodiscard]] double plane_q(const ScreenMesh& screen, std::uint32_t face, const glm::dvec2& at);

/// Nothing if it misses the cell, which is named by its upper left sample.
[[nodiscard]] std::optional<Clipped> clip_to_cell(const Segment& segment, const glm::ivec2& cell);

}  // namespace ink::methods
