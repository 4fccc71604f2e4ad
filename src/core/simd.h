#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Kernels are written once with Highway, compiled for several instruction sets and chosen at run
/// time. The scalar target is the truth; every other gives the same bits.
namespace ink::core {

/// One instruction set that the kernels were compiled for.
struct SimdTarget {
    std::int64_t bit = 0;  ///< Highway's
    std::string name;      ///< "SCALAR" (Highway's fallback), "AVX2", "AVX3" (AVX-512), ...
};

/// Those that kernels were compiled for and this machine can run, the best first, scalar last.
[[nodiscard]] std::vector<SimdTarget> simd_targets();

/// The one that kernels run on now: the best, unless a ForcedSimdTarget lives.
[[nodiscard]] SimdTarget current_simd_target();

/// Highway's version, "1.0.3".
[[nodiscard]] std::string highway_version();

/// Makes all kernels run on one target while it lives; for tests and measurements. Not while
/// anything draws.
class ForcedSimdTarget {
  public:
    explicit ForcedSimdTarget(const SimdTarget& target);
    ForcedSimdTarget(const ForcedSimdTarget&) = delete;
    ForcedSimdTarget& operator=(const ForcedSimdTarget&) = delete;
    ~ForcedSimdTarget();
};

}  // namespace ink::core
