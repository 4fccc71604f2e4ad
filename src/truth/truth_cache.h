#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "truth/model.h"
#include "truth/truth.h"

namespace ink::truth {

/// A truth as bytes, sealed with its key (core/kept_file.h).
[[nodiscard]] std::string encode_truth(const Truth& truth, const std::string& key);

/// The truth that `encode_truth` wrote under the same key; nothing if the bytes are no such thing,
/// or images differ in size. Never throws for what is in the bytes, and allocates no more than
/// images of 2^27 px take.
[[nodiscard]] std::optional<Truth> decode_truth(std::string_view bytes, const std::string& key);

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
