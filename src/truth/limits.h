#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>

#include "scene/scene.h"

namespace ink::truth {

/// What the truth of a view may cost, in things that are counted, never in time: so whether a view
/// is too large does not depend on the machine, the load or the number of threads.
///
/// The defaults keep two threads of a machine of 2023 below a minute, and every machine below 4 GB,
/// at 1920 x 1080 (bench/README.md has the measurements). A view that exceeds them is refused as
/// soon as what was done of it makes that sure (pilots.h): far beyond them after a small share.
struct TruthLimits {
    /// Bytes that scene, topology, trees and results are reckoned to take at their peak
    /// (`memory_estimate`).
    std::size_t memory_bytes = 3'600'000'000;
    /// Samples along lines, hidden ones too: most of those take no ray.
    std::size_t samples = 64'000'000;
    /// Rays, counted as they are cast: five a visible sample, more where lines flicker.
    std::size_t rays = 40'000'000;
};

/// One part in so many is done first, spread evenly over the whole, then as many again and so on.
/// As soon as that shows a cost beyond a limit (pilots.h), or of kSureExcess times a limit, the
/// rest is not begun.
inline constexpr std::size_t kPilotShare = 64;
inline constexpr std::size_t kSureExcess = 4;

/// A view that would exceed the limits. `what()` says which and gives the counts; it is the same on
/// every machine and for every thread count.
class TooLarge : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Told of `done` steps of `total` while lines are traced, from one thread at a time, often.
using TruthProgress = std::function<void(std::size_t done, std::size_t total)>;

/// What a scene's truth is reckoned to take at its peak, bytes: measured on smooth surfaces, on
/// rough ones and on soups of triangles, `places` being its distinct vertices.
[[nodiscard]] std::size_t memory_estimate(const scene::Scene& scene, std::size_t places);

/// Throws TooLarge if the scene's `memory_estimate` exceeds the limit. Vertices are counted as
/// distinct, and only if that is too many one by one.
void check_memory(const scene::Scene& scene, const TruthLimits& limits);

}  // namespace ink::truth
