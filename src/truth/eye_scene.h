#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "scene/camera.h"
#include "scene/topology.h"

namespace ink::truth {

/// A line of sight: begin_world + t * way_world, t_near <= t <= t_far.
///
/// `way_world` need not be of unit length; it is rounded to float once it is.
struct EyeRay : scene::SightLine {
    double t_near = 0;
    double t_far = 0;
};

/// The part of a ray that counts.
struct RayRange {
    double t_near = 0;
    double t_far = 0;
};

/// A welded scene as lines of sight meet it: an Embree tree of float, eye-relative triangles.
///
/// Embree's own answer is never the last word: its hits are *candidates* that the caller confirms.
/// A candidate list may hold triangles that the exact segment misses, and the distance of a hit is
/// good to about 1e-6 of it; what is hit depends neither on threads nor on the order of the
/// triangles. Thread-safe once built. Keeps no reference to the topology.
class EyeScene {
  public:
    EyeScene(const scene::Topology& topology, const scene::Camera& camera, int threads);
    ~EyeScene();
    EyeScene(const EyeScene&) = delete;
    EyeScene& operator=(const EyeScene&) = delete;

    struct Hit {
        std::uint32_t face = 0;  ///< into Topology::faces
        double t = 0;            ///< in units of the ray's way
    };

    /// Offers each face along the ray to `confirm(face)`, in no order, until it says yes. True if
    /// it did. A face may be offered more than once.
    template <class Confirm>
    [[nodiscard]] bool any(const EyeRay& ray, Confirm&& confirm) const {
        return any_of(ray, {&call<Confirm>, address_of(confirm)});
    }

    /// The same along any of four rays, which are followed together: quick where they run close by.
    template <class Confirm>
    [[nodiscard]] bool any_of_four(const std::array<scene::SightLine, 4>& lines,
                                   const RayRange& range,
                                   Confirm&& confirm) const {
        return any_of_packet(lines, range, {&call<Confirm>, address_of(confirm)});
    }

    /// The nearest face along the ray that `confirm(face)` accepts; of equally near ones the
    /// lowest.
    template <class Confirm>
    [[nodiscard]] std::optional<Hit> first(const EyeRay& ray, Confirm&& confirm) const {
        return first_of(ray, {&call<Confirm>, address_of(confirm)});
    }

    /// The nearest face along each of sixteen rays that run close by, of equally near ones the
    /// lowest: what `first` says of each if it accepts every face, only faster. Rays whose bit in
    /// `valid` is 0 are not cast and meet nothing.
    [[nodiscard]] std::array<std::optional<Hit>, 16> first_of_sixteen(
        const std::array<scene::SightLine, 16>& lines,
        const RayRange& range,
        std::uint32_t valid) const;

  private:
    struct Callback {
        bool (*function)(void*, std::uint32_t);
        void* object;
    };
    template <class Confirm>
    static void* address_of(Confirm& confirm) {
        return const_cast<void*>(static_cast<const void*>(&confirm));
    }
    template <class Confirm>
    static bool call(void* object, std::uint32_t face) {
        return (*static_cast<std::remove_reference_t<Confirm>*>(object))(face);
    }
    [[nodiscard]] bool any_of(const EyeRay& ray, Callback confirm) const;
    [[nodiscard]] bool any_of_packet(const std::array<scene::SightLine, 4>& lines,
                                     const RayRange& range,
                                     Callback confirm) const;
    [[nodiscard]] std::optional<Hit> first_of(const EyeRay& ray, Callback confirm) const;

    struct Handles;
    struct Ray;
    friend struct EyeSceneQuery;
    std::unique_ptr<Handles> handles_;
    glm::dvec3 eye_world_;
    bool is_parallel_;
    double scale_ =
        1;  ///< a power of two that brings the scene near 1, so that floats never overflow
};

}  // namespace ink::truth
