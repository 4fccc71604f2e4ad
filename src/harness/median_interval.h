#pragma once

#include <cstdint>
#include <vector>

namespace ink::harness {

/// Whether the median of what `times_ns` are a sample of is known to within `share` of itself: the
/// two times of the sample that have it between them in three cases of four, whatever the
/// distribution, are no further apart. Never of fewer than three times, or if `share` is 0.
[[nodiscard]] bool is_median_known(std::vector<std::int64_t> times_ns, double share);

}  // namespace ink::harness
