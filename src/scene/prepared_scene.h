#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "core/work_clock.h"
#include "scene/scene.h"

namespace ink::scene {

enum class NormalSource;
struct Surface;
struct Topology;

/// A scene, and what was worked out of it: welded, flattened, cut into clusters, each made when it
/// is first asked for and kept for who asks next.
///
/// The scene is borrowed and must not change meanwhile. A scene stands for itself with nothing made
/// yet, so that whoever takes a PreparedScene takes a Scene, too. For one thread at a time; others
/// have one of their own that shares the results (shared()).
class PreparedScene {
  public:
    /// Keeps the `most` results that are worth most: those that took long to make, and were asked
    /// for last. Who holds another may keep it longer.
    PreparedScene(const Scene& scene, std::size_t most = std::numeric_limits<std::size_t>::max());
    PreparedScene(const PreparedScene&) = delete;
    PreparedScene& operator=(const PreparedScene&) = delete;

    /// The same scene and results, for another thread. What one of them makes the others wait for.
    [[nodiscard]] PreparedScene shared() const { return {scene_, results_}; }

    operator const Scene&() const { return scene_; }
    const Scene* operator->() const { return &scene_; }

    /// bounding_sphere() and scene_hash().
    [[nodiscard]] Sphere bounds() const;
    [[nodiscard]] std::uint64_t hash() const;
    /// weld() with this epsilon.
    [[nodiscard]] std::shared_ptr<const Topology> topology(double epsilon = 0) const;
    /// flatten(), without normals and with them.
    [[nodiscard]] std::shared_ptr<const Surface> surface() const;
    [[nodiscard]] std::shared_ptr<const Surface> surface(NormalSource source,
                                                         double crease_rad) const;

    /// The result of that name; `make` makes it if it is not there. A name says all that the result
    /// depends on beside the scene, its type included.
    template <class Make>
    [[nodiscard]] auto get(const std::string& name, Make make) const {
        using Result = std::decay_t<decltype(make())>;
        if (const auto known = find(name)) return std::static_pointer_cast<const Result>(known);
        const Making making(*this, name);
        const std::int64_t saved_before_ns = saved_ns_;
        std::shared_ptr<const Result> made;
        const core::Spent spent =
            core::spent_on([&] { made = std::make_shared<const Result>(make()); });
        keep(name,
             made,
             spent.cpu_ns + saved_ns_ - saved_before_ns,
             std::is_trivially_copyable_v<Result>);
        return made;
    }

    /// Nanoseconds of its thread that it took to make what was there already when it was asked for.
    /// Who times a stage adds what this grew by, and has the time of a stage that makes all by
    /// itself.
    [[nodiscard]] std::int64_t saved_ns() const { return saved_ns_; }

  private:
    struct Results;

    /// While a result is made, others wait for it; if it throws, the next of them makes it.
    class Making {
      public:
        Making(const PreparedScene& scene, const std::string& name) : scene_(scene), name_(name) {}
        ~Making() { scene_.stop_making(name_); }
        Making(const Making&) = delete;
        Making& operator=(const Making&) = delete;

      private:
        const PreparedScene& scene_;
        const std::string& name_;
    };

    PreparedScene(const Scene& scene, std::shared_ptr<Results> results)
        : scene_(scene), results_(std::move(results)) {}

    /// The result, once nobody is making it; null if the caller is to make it.
    [[nodiscard]] std::shared_ptr<const void> find(const std::string& name) const;
    void keep(const std::string& name,
              std::shared_ptr<const void> result,
              std::int64_t made_ns,
              bool is_small) const;
    void stop_making(const std::string& name) const;

    const Scene& scene_;
    std::shared_ptr<Results> results_;
    mutable std::int64_t saved_ns_ = 0;
};

/// flatten() by the topology that is kept.
[[nodiscard]] Surface flatten(const PreparedScene& scene, NormalSource source, double crease_rad);

}  // namespace ink::scene
