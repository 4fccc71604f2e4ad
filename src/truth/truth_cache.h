#pragma once

#include <filesystem>
#include <string>

#include "truth/scene_model.h"
#include "truth/truth.h"

namespace ink::truth {

/// The name under which a truth is kept: a hash of all it depends on: the scene's geometry, the
/// camera, the size, the options that change a result, and the sources that trace it.
[[nodiscard]] std::string truth_key(const scene::Scene& scene,
                                    const scene::View& view,
                                    const TruthOptions& options);

/// `trace_truth`, or the same result read back from `cache_dir` if it was traced before.
///
/// Keeps one file a view, `<truth_key>.truth`, written beside and renamed, so that no other process
/// sees half of one. A file that is damaged, cut off or not ours is traced anew and replaced. An
/// empty `cache_dir` keeps nothing, and one that cannot be written costs the caching only: no
/// error.
[[nodiscard]] Truth cached_truth(SceneModel& scene,
                                 const scene::View& view,
                                 const std::filesystem::path& cache_dir);

}  // namespace ink::truth
