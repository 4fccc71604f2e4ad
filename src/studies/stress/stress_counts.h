#pragma once

#include <cstdint>

#include "method/method.h"
#include "scene/scene.h"
#include "studies/axis.h"
#include "truth/truth.h"

namespace ink::studies {

/// What a method is given in one case: numbers that are not finite, and depths outside 0..1,
/// counted over vertices and over the pixels of full buffers in every encoding.
///
/// Normals may be a little longer than 1: where a triangle is thinner than the grid by which pixels
/// are covered, its planes are read beyond its sides.
[[nodiscard]] CaseFaults count_inputs(const scene::Scene& scene, const scene::View& view);

/// Numbers of a truth that are not finite (what lies behind a line may be infinitely far).
[[nodiscard]] std::int64_t count_non_finite(const truth::Truth& truth);

/// Numbers of a row's scores that are not finite or outside 0..1.
[[nodiscard]] std::int64_t count_non_finite(const harness::Row& row);

/// Pixels at which the packed code of `method`, made by `config` and ready for `scene`, overflows:
/// where it comes out otherwise if overflow wraps instead of saturating, or the other way round.
///
/// 0 for methods without packed codes, and for codes whose ranges exceed their bits: those overflow
/// by intent.
[[nodiscard]] std::int64_t count_overflow(method::Method& method,
                                          const method::MethodConfig& config,
                                          const scene::Scene& scene,
                                          const method::Frame& frame);

}  // namespace ink::studies
