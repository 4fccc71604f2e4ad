#include "import/lost_digits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "import/meshes/polygons.h"
#include "scene/box.h"

namespace ink::import {
namespace {

constexpr double kMostShare = 1e-5;

/// How far two floats are apart that are as large as the largest of `p`.
double spacing_at(const glm::dvec3& p) {
    const auto size = static_cast<float>(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
    return std::nextafter(size, std::numeric_limits<float>::infinity()) - size;
}

scene::Box world_box(const scene::Box& box, const glm::dmat4& world_from_object) {
    scene::Box world;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? box.high.x : box.low.x,
                           (corner & 2) != 0 ? box.high.y : box.low.y,
                           (corner & 4) != 0 ? box.high.z : box.low.z);
        world.add(glm::dvec3(world_from_object * glm::dvec4(p, 1)));
    }
    return world;
}

/// What part of `diagonal` a step between floats is at `p`; 0 where there is no such part.
double lost_share(const glm::dvec3& p, double diagonal) {
    const double share = spacing_at(p) / diagonal;
    return diagonal > 0 && std::isfinite(share) ? share : 0;
}

}  // namespace

void note_lost_digits(ImportReply& reply) {
    std::vector<scene::Box> boxes;
    for (const ImportedMesh& mesh : reply.meshes)
        boxes.push_back(scene::box_of(mesh.positions));
    scene::Box whole;
    for (const ImportedInstance& instance : reply.instances)
        whole.add(world_box(boxes[instance.mesh], instance.world_from_object));
    std::size_t objects = 0;
    double most = 0;
    for (const ImportedInstance& instance : reply.instances) {
        const scene::Box& box = boxes[instance.mesh];
        const glm::dvec3 farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
        const double share = std::max(lost_share(farthest, box.diagonal()),
                                      lost_share(instance.world_from_object[3], whole.diagonal()));
        if (share > kMostShare) ++objects;
        most = std::max(most, share);
    }
    if (objects == 0) return;
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.1g", most);
    reply.notes.push_back("digits of " + counted(objects, "object") +
                          " far from zero: places are read as floats, there up to " + text.data() +
                          " of the size apart");
}

}  // namespace ink::import
