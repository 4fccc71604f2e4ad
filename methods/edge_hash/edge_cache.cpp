#include "methods/edge_hash/edge_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "core/hash.h"
#include "scene/sharing/shared_work.h"

namespace ink::methods {
namespace {

/// The edges of a soup whose points have this hash: a copy where several methods on a scene share
/// their work.
SoupEdges shared_edges(const Soup& soup, double epsilon, std::uint64_t hash) {
    const auto make = [&] { return find_edges(soup, epsilon); };
    scene::SharedWork* work = scene::SharedWork::current();
    if (work == nullptr) return make();
    const std::uint64_t triangles = core::Hasher().items(soup.triangles).result();
    return work->get(fmt::format("soup edges {} {} {}", hash, triangles, epsilon), make);
}

}  // namespace

void EdgeCache::reset(std::size_t models) {
    models_.assign(models, {});
    counts_ = {};
}

void EdgeCache::make_room(Model& model) {
    if (model.size() < most_frames_) return;
    const auto oldest =
        std::min_element(model.begin(), model.end(), [](const auto& a, const auto& b) {
            return a.second.last_asked < b.second.last_asked;
        });
    model.erase(oldest);
    ++counts_.dropped;
}

std::shared_ptr<const SoupEdges> EdgeCache::edges_of(std::size_t model, const Soup& soup) {
    assert(model < models_.size());
    const std::uint64_t frame = core::Hasher().items(soup.points).result();
    Model& frames = models_[model];
    ++asked_;
    const auto known = frames.find(frame);
    if (known != frames.end()) {
        ++counts_.found;
        known->second.last_asked = asked_;
        return known->second.edges;
    }
    make_room(frames);
    ++counts_.built;
    auto edges = std::make_shared<const SoupEdges>(shared_edges(soup, epsilon_, frame));
    frames[frame] = {edges, asked_};
    return edges;
}

}  // namespace ink::methods
