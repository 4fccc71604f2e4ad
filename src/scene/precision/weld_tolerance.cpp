#include "scene/precision/weld_tolerance.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace ink::scene {
namespace {

constexpr double kRelativeTolerance = 1e-6;

/// What is known of an object's vertices.
struct Extent {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    double rounding = 0;

    void add(const glm::dvec3& p, double rounding_world) {
        low = glm::min(low, p);
        high = glm::max(high, p);
        rounding = std::max(rounding, rounding_world);
    }
    [[nodiscard]] double diagonal() const {
        return low.x > high.x ? 0 : glm::length(high - low);  // an object without faces is no box
    }
};

}  // namespace

std::vector<double> weld_tolerances(const Topology& topology) {
    std::vector<Extent> extents;
    for (const Face& face : topology.faces) {
        if (face.object >= extents.size()) extents.resize(face.object + 1);
        for (const std::uint32_t v : face.vertices)
            extents[face.object].add(topology.p_world[v], topology.rounding_world[v]);
    }
    std::vector<double> tolerances(extents.size());
    std::transform(extents.begin(), extents.end(), tolerances.begin(), [](const Extent& extent) {
        return std::max(kRelativeTolerance * extent.diagonal(), 2 * extent.rounding);
    });
    return tolerances;
}

}  // namespace ink::scene
