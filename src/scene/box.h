#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

namespace ink::scene {

/// A box along the axes; the default one is empty.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    void add(const Box& box) {
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
    }
    [[nodiscard]] bool is_empty() const { return !(low.x <= high.x); }
    [[nodiscard]] glm::dvec3 center() const { return low * 0.5 + high * 0.5; }
    /// Length; 0 of an empty box.
    [[nodiscard]] double diagonal() const { return is_empty() ? 0 : glm::length(high - low); }
    [[nodiscard]] bool touches(const Box& o) const {
        return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y &&
               low.z <= o.high.z && o.low.z <= high.z;
    }
};

/// The box round some points.
[[nodiscard]] inline Box box_of(std::span<const glm::dvec3> points) {
    Box box;
    for (const glm::dvec3& p : points)
        box.add(p);
    return box;
}

[[nodiscard]] inline glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

/// How far along the way from `a` to `b` its nearest point to `p` lies, 0..1.
[[nodiscard]] inline double nearest_share(const glm::dvec3& p,
                                          const glm::dvec3& a,
                                          const glm::dvec3& b) {
    const glm::dvec3 along = b - a;
    return std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
}

[[nodiscard]] inline double distance_to_segment(const glm::dvec3& p,
                                                const glm::dvec3& a,
                                                const glm::dvec3& b) {
    return glm::length(p - (a + nearest_share(p, a, b) * (b - a)));
}

[[nodiscard]] inline bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace ink::scene
