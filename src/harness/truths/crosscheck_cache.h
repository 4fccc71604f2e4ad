#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "crosscheck/dense_sampling.h"
#include "harness/truths/compare_truths.h"
#include "truth/model.h"
#include "truth/truth.h"

namespace ink::harness {

/// What the cross-check says of a view's truth.
struct Crosscheck {
    Agreement agreement;
    crosscheck::SamplingCounts counts;
    double look_s = 0;  ///< wall time of looking and comparing (kept when it comes from the cache)
};

/// Looks at the view with the cross-check and holds `truth`, which was traced of it, against that;
/// or reads back from `cache_dir` what came of it before.
///
/// Kept beside the truth, as `<truth_key>.crosscheck`, by the same rules (truth_cache.h).
[[nodiscard]] Crosscheck cached_crosscheck(truth::SceneModel& scene,
                                           const scene::View& view,
                                           const truth::Truth& truth,
                                           const std::filesystem::path& cache_dir);

/// A check as bytes, and back; nothing if they are cut off, changed, of another key, or hold a
/// number that is none of its kind.
[[nodiscard]] std::string encode_check(const Crosscheck& check, const std::string& key);
[[nodiscard]] std::optional<Crosscheck> decode_check(std::string_view bytes,
                                                     const std::string& key);

}  // namespace ink::harness
