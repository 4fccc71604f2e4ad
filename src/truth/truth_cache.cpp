#include "truth/truth_cache.h"

#include <optional>

#include "core/hash.h"
#include "core/kept_file.h"
#include "core/whole_file.h"
#include "truth/truth_file.h"
#include "truth/truth_sources.h"

namespace ink::truth {
namespace {

namespace fs = std::filesystem;

std::optional<Truth> load(const fs::path& path, const std::string& key, const scene::View& view) {
    const auto bytes = core::read_whole_file(path);
    if (!bytes) return std::nullopt;
    auto truth = decode_truth(*bytes, key);
    const bool fits = truth && truth->labels.width_px() == view.width_px &&
                      truth->labels.height_px() == view.height_px;
    return fits ? std::move(truth) : std::nullopt;
}

}  // namespace

std::string truth_key(const scene::Scene& scene,
                      const scene::View& view,
                      const TruthOptions& options) {
    const scene::Camera& camera = view.camera;
    core::Hasher hasher;
    hasher.text(kSourcesHash).value(scene::scene_hash(scene));
    hasher.value(camera.eye_world).value(camera.view_from_world);
    hasher.value(camera.fov_y_rad).value(camera.near);
    hasher.value(view.width_px).value(view.height_px);
    hasher.value(options.crease_rad).value(options.layers);
    hasher.value(options.weld_epsilon);
    return hasher.hex();
}

Truth cached_truth(SceneModel& scene,
                   const scene::View& view,
                   const std::filesystem::path& cache_dir) {
    const TruthOptions& options = scene.options();
    const TruthTrace trace{options.threads, options.layers, options.limits, options.progress};
    if (cache_dir.empty()) return trace_truth(scene.model(), view, trace);
    const std::string key = truth_key(scene.scene(), view, options);
    const fs::path path = cache_dir / (key + ".truth");
    if (auto truth = load(path, key, view)) return std::move(*truth);
    Truth truth = trace_truth(scene.model(), view, trace);
    core::keep_file(path, encode_truth(truth, key));
    return truth;
}

}  // namespace ink::truth
