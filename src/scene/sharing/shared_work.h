#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <type_traits>

#include "scene/scene.h"
#include "scene/surface.h"

namespace ink::scene {

/// What was worked out of one scene, for all who ask for the same of it: many methods prepare
/// themselves by welding, flattening and clustering one scene alike.
///
/// While a Use of it lives, flatten(), weld(), make_clusters(), bounding_sphere(), scene_hash() and
/// what else calls shared() on that thread give copies of what they made before: the same results
/// in memory of their own. The scene is borrowed and must not change meanwhile. For one thread at a
/// time.
class SharedWork {
  public:
    /// Keeps the `most` results that were asked for last.
    SharedWork(const Scene& scene, std::size_t most) : scene_(scene), most_(most) {}
    SharedWork(const SharedWork&) = delete;
    SharedWork& operator=(const SharedWork&) = delete;

    /// Lets this thread share, until its end.
    class Use {
      public:
        explicit Use(SharedWork& work);
        ~Use();
        Use(const Use&) = delete;
        Use& operator=(const Use&) = delete;

      private:
        SharedWork* before_;
    };

    /// The shared work of this thread; null if it shares none.
    [[nodiscard]] static SharedWork* current();
    /// Nanoseconds that copies have saved this thread so far: who times a stage adds what it grew
    /// by, and has the time of a stage that works all out itself. 0 if it shares nothing.
    [[nodiscard]] static std::int64_t saved_ns();

    /// A copy of the result of that name; `make` makes it if it is not there.
    template <class Make>
    [[nodiscard]] auto get(const std::string& name, Make make) {
        using Result = std::decay_t<decltype(make())>;
        const auto start = Clock::now();
        if (const Kept* kept = find(name)) {
            Result copy = *static_cast<const Result*>(kept->result.get());
            saved_ns_ += kept->made_ns - ns_since(start);
            return copy;
        }
        const std::int64_t saved_before_ns = saved_ns_;
        Result made = make();
        const std::int64_t made_ns = ns_since(start) + saved_ns_ - saved_before_ns;
        const auto kept = Clock::now();
        keep({name, std::make_shared<const Result>(made), made_ns});
        saved_ns_ -= ns_since(kept);
        return made;
    }

    /// The name under which a surface with these very corners is kept; "" if none is.
    [[nodiscard]] std::string name_of(const Surface& surface) const;

    [[nodiscard]] const Scene& scene() const { return scene_; }

  private:
    using Clock = std::chrono::steady_clock;
    struct Kept {
        std::string name;
        std::shared_ptr<const void> result;
        std::int64_t made_ns = 0;
    };

    [[nodiscard]] static std::int64_t ns_since(Clock::time_point start) {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start).count();
    }
    [[nodiscard]] const Kept* find(const std::string& name);
    void keep(Kept kept);

    const Scene& scene_;
    std::size_t most_;
    std::list<Kept> kept_;  ///< the last asked for first
    std::int64_t saved_ns_ = 0;
};

/// What `make` makes of a scene; a copy where the thread shares work on it.
template <class Make>
[[nodiscard]] auto shared(const Scene& scene, const std::string& name, Make make) {
    SharedWork* work = SharedWork::current();
    return work != nullptr && &work->scene() == &scene ? work->get(name, make) : make();
}

/// Surfaces are kept under names that begin so.
inline constexpr const char* kSurfaceName = "surface";

}  // namespace ink::scene
