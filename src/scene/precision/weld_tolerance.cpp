#include "scene/precision/weld_tolerance.h"

#include <algorithm>

namespace ink::scene {
namespace {

constexpr double kRelativeTolerance = 1e-6;

}  // namespace

std::vector<Box> object_boxes(const Topology& topology) {
    std::vector<Box> boxes;
    for (const Face& face : topology.faces) {
        if (face.object >= boxes.size()) boxes.resize(face.object + 1);
        for (const std::uint32_t v : face.vertices)
            boxes[face.object].add(topology.p_world[v]);
    }
    return boxes;
}

std::vector<double> weld_tolerances(const Topology& topology) {
    std::vector<double> tolerances;
    for (const Box& box : object_boxes(topology))
        tolerances.push_back(kRelativeTolerance * box.diagonal());
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
        double& tolerance = tolerances[topology.faces[f].object];
        tolerance = std::max(tolerance, 2 * topology.rounding_of(f));
    }
    return tolerances;
}

}  // namespace ink::scene
