#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "method/method.h"

namespace ink::studies {

/// The normals of the two faces at a crease, as a camera that has not rolled yet sees them: view
/// space, unit, towards the eye.
struct CreaseNormals {
    glm::dvec3 n0_view{0};
    glm::dvec3 n1_view{0};
};

/// What a linear code makes of a crease while its camera rolls about its view direction, by
/// scene::PathKind::roll.
///
/// Faces are flat to the code (their corners have the faces' own normals), and depth is the same on
/// both sides of a crease, so from one side to the other the code changes by
///
///     step(r) = A cos r + B sin r + C,    A = (wx dx + wy dy) / 2
///                                         B = (wx dy - wy dx) / 2
///                                         C = wz dz / 2
///
/// with w the code's weights and d the change of the normal at r = 0. Where the step is 0 (or a
/// whole turn of a code that wraps) nothing but depth's kink is left of the crease: a threshold
/// above that must lose it.
class RollPrediction {
  public:
    RollPrediction(const method::LinearCode& code, const CreaseNormals& normals);

    /// The change of the code across the crease, code units; of a code that wraps the nearest to 0
    /// of those it may be.
    [[nodiscard]] double step(double roll_rad) const;

    /// The angles in [0, 2 pi) at which the step is 0, ascending: none where the weights of x and y
    /// are too small, two as a rule; more for codes that wrap. None either for a code that does not
    /// change at all.
    [[nodiscard]] std::vector<double> vanishing_rad() const;

    /// Whether no pixel along a straight crease can reach `threshold`: such a line has one or two
    /// of a pixel's four neighbours on its other side, so the filter sees the step once or twice.
    /// What depth's kink and rounding add, up to a few code units, is left out.
    [[nodiscard]] bool is_blind(double roll_rad, int threshold) const;

  private:
    double cosine_;      ///< A
    double sine_;        ///< B
    double constant_;    ///< C
    double period_ = 0;  ///< of a code that wraps, else 0
    edge::LaplacianResponse response_;
};

}  // namespace ink::studies
