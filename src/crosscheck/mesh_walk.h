#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "crosscheck/clip_mesh.h"
#include "crosscheck/sight_rays.h"

namespace ink::crosscheck {

/// A point of the image and what is seen there.
struct Sample {
    glm::dvec2 p_px{0};
    Sight sight;
};

/// A straight way across the image.
struct Way {
    Sample from, to;
};

/// Looks at the places of all samples and sets what is seen there.
void look_at_all(const SightRays& rays, std::span<Sample> samples);

/// Ways over the mesh, as the cross-check goes them.
namespace walking {

/// |cos| + |sin| of the direction of a line with this normal; 1 without one.
[[nodiscard]] double slant_of(const glm::dvec2& normal);

/// An edge of a face, met on a way across the image.
struct MetEdge {
    truth::LineClass line_class = truth::LineClass::none;
    std::uint32_t face = kNothing;  ///< it was left through `side`
    std::size_t side = 0;
    double w = 0;
    glm::dvec3 p_world{0};
    glm::dvec2 outward{0};  ///< unit, on the image, away from the face
    [[nodiscard]] double slant() const { return slant_of(outward); }
};

/// Where a walk came to.
struct Walk {
    bool has_arrived = false;  ///< else it ended at `met`, behind which nothing goes on
    std::uint32_t face = kNothing;
    MetEdge met;  ///< the end, or the first feature that was passed
};

/// Whether a walk ends at the first feature edge, or only where nothing goes on.
enum class Stop { at_feature, at_end };

/// Follows the surface from the face that is seen at `from` towards `to`: to the first feature edge
/// of any kind, or only to where nothing goes on.
[[nodiscard]] Walk walk(const ClipMesh& mesh,
                        const Sample& from,
                        const glm::dvec2& to_px,
                        Stop stop);

/// A walk that arrived where another surface is seen, though its own holds the point by a hair:
/// where it ends within reach, that hair is the rounding of what looked (SightRays::reach_px), and
/// the walk ended there.
[[nodiscard]] Walk ended_round(
    const ClipMesh& mesh, const Walk& walk, const Sample& to, const glm::dvec2& d, double reach_px);

/// Whether a walk came to the surface that is seen at `to`, or to within its reach.
[[nodiscard]] bool arrives_at(const ClipMesh& mesh, const Walk& walk, const Sample& to);

}  // namespace walking

/// Whether a walk over the mesh from one sample to the other meets no feature edge.
[[nodiscard]] bool is_joined(const ClipMesh& mesh, const Sample& from, const Sample& to);

}  // namespace ink::crosscheck
