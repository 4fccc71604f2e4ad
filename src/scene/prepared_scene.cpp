#include "scene/prepared_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <set>

#include "scene/surface.h"
#include "scene/topology.h"

namespace ink::scene {
namespace {

/// The worth of what takes no room worth mentioning: it stays.
constexpr std::int64_t kSmall = std::numeric_limits<std::int64_t>::max();

}  // namespace

/// Which results go when there are too many: GreedyDual (N. Young, "The k-server dual and loose
/// competitiveness for paging", 1994). What goes takes its worth from all that stay, by raising the
/// level from which those asked for later count.
struct PreparedScene::Results {
    struct Kept {
        std::shared_ptr<const void> result;
        std::int64_t made_ns = 0;
        std::int64_t worth_ns = 0;  ///< the least goes first
    };

    std::size_t most = 0;
    std::mutex mutex;
    std::condition_variable is_made;
    std::map<std::string, Kept> kept;
    std::set<std::string> being_made;
    std::int64_t level_ns = 0;
};

PreparedScene::PreparedScene(const Scene& scene, std::size_t most)
    : scene_(scene), results_(std::make_shared<Results>()) {
    results_->most = most;
}

Sphere PreparedScene::bounds() const {
    return *get("bounds", [&] { return bounding_sphere(scene_); });
}

std::uint64_t PreparedScene::hash() const {
    return *get("hash", [&] { return scene_hash(scene_); });
}

std::shared_ptr<const Topology> PreparedScene::topology(double epsilon) const {
    return get(fmt::format("topology {}", epsilon),
               [&] { return weld(scene_, {.epsilon = epsilon}); });
}

std::shared_ptr<const Surface> PreparedScene::surface() const {
    return get("surface", [&] { return flatten(scene_); });
}

std::shared_ptr<const Surface> PreparedScene::surface(NormalSource source,
                                                      double crease_rad) const {
    return get(fmt::format("surface {} {}", static_cast<int>(source), crease_rad),
               [&] { return flatten(*this, source, crease_rad); });
}

std::shared_ptr<const void> PreparedScene::find(const std::string& name) const {
    Results& results = *results_;
    std::unique_lock lock(results.mutex);
    results.is_made.wait(lock, [&] { return results.being_made.count(name) == 0; });
    const auto found = results.kept.find(name);
    if (found == results.kept.end()) {
        results.being_made.insert(name);
        return nullptr;
    }
    Results::Kept& kept = found->second;
    saved_ns_ += kept.made_ns;
    kept.worth_ns = std::max(kept.worth_ns, results.level_ns + kept.made_ns);
    return kept.result;
}

void PreparedScene::keep(const std::string& name,
                         std::shared_ptr<const void> result,
                         std::int64_t made_ns,
                         bool is_small) const {
    Results& results = *results_;
    const std::lock_guard lock(results.mutex);
    while (!results.kept.empty() && results.kept.size() >= results.most) {
        const auto least = std::ranges::min_element(results.kept, [](const auto& a, const auto& b) {
            return a.second.worth_ns < b.second.worth_ns;
        });
        if (least->second.worth_ns == kSmall) break;
        results.level_ns = least->second.worth_ns;
        results.kept.erase(least);
    }
    const std::int64_t worth_ns = is_small ? kSmall : results.level_ns + made_ns;
    results.kept[name] = {std::move(result), made_ns, worth_ns};
}

void PreparedScene::stop_making(const std::string& name) const {
    const std::lock_guard lock(results_->mutex);
    results_->being_made.erase(name);
    results_->is_made.notify_all();
}

}  // namespace ink::scene
