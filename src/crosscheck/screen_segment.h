#pragma once

#include <glm/vec2.hpp>

#include "crosscheck/clip_mesh.h"

namespace ink::crosscheck {

/// A line on the image with q = 1/w at its ends; between them q is linear in px.
struct ScreenSegment {
    glm::dvec2 a{0}, b{0};
    double q_a = 0, q_b = 0;

    [[nodiscard]] glm::dvec2 at(double s) const { return a + s * (b - a); }
    [[nodiscard]] double q_at(double s) const { return q_a + s * (q_b - q_a); }
};

/// The part of a mesh edge that lies beyond the near plane and inside the image; false if there is
/// none.
[[nodiscard]] bool project_edge(const ClipMesh& mesh,
                                const scene::Edge& edge,
                                ScreenSegment& segment);

}  // namespace ink::crosscheck
