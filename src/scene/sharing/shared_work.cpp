#include "scene/sharing/shared_work.h"

#include <algorithm>
#include <utility>

namespace ink::scene {
namespace {

/// The one of this thread. Methods reach the functions that share through interfaces that know
/// nothing of it, so it cannot be an argument.
SharedWork*& current_work() {
    static thread_local SharedWork* work = nullptr;
    return work;
}

bool is_same(const Surface& a, const Surface& b) {
    return a.triangles == b.triangles && a.object == b.object && a.p_world == b.p_world &&
           a.n_world == b.n_world;
}

}  // namespace

SharedWork::Use::Use(SharedWork& work) : before_(std::exchange(current_work(), &work)) {}

SharedWork::Use::~Use() {
    current_work() = before_;
}

SharedWork* SharedWork::current() {
    return current_work();
}

std::int64_t SharedWork::saved_ns() {
    return current_work() == nullptr ? 0 : current_work()->saved_ns_;
}

const SharedWork::Kept* SharedWork::find(const std::string& name) {
    const auto found = std::ranges::find(kept_, name, &Kept::name);
    if (found == kept_.end()) return nullptr;
    kept_.splice(kept_.begin(), kept_, found);
    return &kept_.front();
}

void SharedWork::keep(Kept kept) {
    kept_.push_front(std::move(kept));
    if (kept_.size() > most_) kept_.pop_back();
}

std::string SharedWork::name_of(const Surface& surface) const {
    for (const Kept& kept : kept_) {
        const bool is_surface = kept.name.rfind(kSurfaceName, 0) == 0;
        if (is_surface && is_same(*static_cast<const Surface*>(kept.result.get()), surface))
            return kept.name;
    }
    return "";
}

}  // namespace ink::scene
