#include "methods/surface_codes/surface_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "scene/animation.h"
#include "scene/sharing/shared_work.h"

namespace ink::methods {
namespace {

/// How much longer the steps of a second code are: where both can find a line, the first has, and
/// what the second adds should be certain. From 1, 2, 3 and 4 on the training scenes.
constexpr float kSecondLength = 2;

}  // namespace

void SurfaceCodes::prepare(const scene::Scene& scene) {
    if (scene.animation) {
        scene::Scene resting = scene;
        scene::pose_scene(resting, 0);
        mesh_ = make_smooth_mesh(resting, options_.patches);
        face_of_ = faces_of_triangles(resting, mesh_.topology);
    } else {
        mesh_ = make_smooth_mesh(scene, options_.patches);
        const std::string name =
            fmt::format("faces of triangles {}", options_.patches.weld_epsilon);
        face_of_ =
            scene::shared(scene, name, [&] { return faces_of_triangles(scene, mesh_.topology); });
    }
}

std::vector<std::uint32_t> SurfaceCodes::codes(std::span<const float> length_world) {
    const auto lowest = static_cast<std::uint32_t>(options_.range.lowest);
    std::vector<std::uint32_t> codes(face_of_.size(), 0);
    slits_ = {};
    const auto add = [&](std::span<const std::int32_t> distances, bool is_second) {
        CodeRange range = options_.range;
        range.is_second = is_second;
        const std::vector<std::uint8_t> of_faces = phased_codes(mesh_, distances, range);
        for (std::size_t t = 0; t < codes.size(); ++t) {
            const std::uint32_t face = face_of_[t];
            const std::uint32_t code = face == SmoothMesh::kNone ? lowest : of_faces[face];
            codes[t] |= is_second ? code << 8 : code;
        }
    };
    if (options_.turn_rad == 0) {
        add(std::vector<std::int32_t>(mesh_.face_count(), 0), false);
        return codes;
    }
    StepCosts costs{options_.turn_rad, {}};
    if (!length_world.empty()) {
        costs.length_world.resize(mesh_.face_count());
        for (std::size_t f = 0; f < mesh_.face_count(); ++f)
            costs.length_world[f] = length_world[mesh_.topology.faces[f].triangle];
    }
    for (int byte = 0; byte < options_.bytes; ++byte) {
        const bool is_second = byte == 1;
        if (is_second) {
            for (float& length : costs.length_world)
                length *= kSecondLength;
        }
        SurfaceGraph graph(mesh_, costs);
        if (options_.rounds > 0) steepen_short_slits(mesh_, graph);
        add(surface_distance(mesh_,
                             graph,
                             is_second ? End::side : End::first,
                             options_.rounds,
                             is_second ? nullptr : &slits_),
            is_second);
    }
    return codes;
}

double SurfaceCodes::largest_object() const {
    const auto& faces = mesh_.topology.faces;
    double largest = 0;
    for (std::size_t f = 0; f < faces.size();) {  // in the order of objects
        glm::dvec3 low{std::numeric_limits<double>::infinity()};
        glm::dvec3 high = -low;
        for (const std::uint32_t object = faces[f].object;
             f < faces.size() && faces[f].object == object;
             ++f) {
            for (const std::uint32_t vertex : faces[f].vertices) {
                low = glm::min(low, mesh_.topology.p_world[vertex]);
                high = glm::max(high, mesh_.topology.p_world[vertex]);
            }
        }
        largest = std::max(largest, glm::length(high - low));
    }
    return largest;
}

}  // namespace ink::methods
