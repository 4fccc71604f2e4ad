#include "scene/prepared_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/surface.h"
#include "scene/topology.h"

namespace ink::scene {

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

const PreparedScene::Kept* PreparedScene::find(const std::string& name) const {
    const auto found = std::find_if(
        kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.name == name; });
    if (found == kept_.end()) return nullptr;
    kept_.splice(kept_.begin(), kept_, found);
    return &kept_.front();
}

void PreparedScene::keep(Kept kept) const {
    kept_.push_front(std::move(kept));
    if (kept_.size() > most_) kept_.pop_back();
}

}  // namespace ink::scene
