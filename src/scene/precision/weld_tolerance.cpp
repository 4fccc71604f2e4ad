#include "scene/precision/weld_tolerance.h"

#include <algorithm>

#include "scene/box.h"

namespace ink::scene {
namespace {

constexpr double kRelativeTolerance = 1e-6;

/// What is known of an object's vertices.
struct Extent {
    Box box;
    double rounding = 0;
};

}  // namespace

std::vector<double> weld_tolerances(const Topology& topology) {
    std::vector<Extent> extents;
    for (const Face& face : topology.faces) {
        if (face.object >= extents.size()) extents.resize(face.object + 1);
        Extent& extent = extents[face.object];
        for (const std::uint32_t v : face.vertices) {
            extent.box.add(topology.p_world[v]);
            extent.rounding = std::max(extent.rounding, topology.rounding_world[v]);
        }
    }
    std::vector<double> tolerances(extents.size());
    std::transform(extents.begin(), extents.end(), tolerances.begin(), [](const Extent& extent) {
        return std::max(kRelativeTolerance * extent.box.diagonal(), 2 * extent.rounding);
    });
    return tolerances;
}

}  // namespace ink::scene
