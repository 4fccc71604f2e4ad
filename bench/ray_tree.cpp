#include "bench/ray_tree.h"

#include <algorithm>
#include <limits>

namespace ink::bench {
namespace {

alignas(64) constexpr std::array<int, kPacket> kAll = {
    -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};

/// Every triangle as a face, in order, and nothing welded.
scene::Topology unwelded(const scene::Scene& scene) {
    scene::Topology topology;
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        const auto first = static_cast<std::uint32_t>(topology.p_world.size());
        for (const glm::vec3& p_object : mesh.positions)
            topology.p_world.push_back(scene::to_world(instance, p_object));
        for (const scene::Triangle& t : mesh.triangles)
            topology.faces.push_back({{first + t[0], first + t[1], first + t[2]}});
    }
    return topology;
}

}  // namespace

RayTree::RayTree(const scene::Scene& scene, const scene::View& view)
    : near_(static_cast<float>(view.camera.near)) {
    const scene::Projection projection(view);
    corner_ = projection.ray_world(0, 0);
    right_ = projection.ray_world(1, 0) - corner_;
    down_ = projection.ray_world(0, 1) - corner_;
    truth::embree::build(handles_, unwelded(scene), 1, "bench", [&](const glm::dvec3& p_world) {
        return p_world - view.camera.eye_world;
    });
}

PacketIds RayTree::cast(double x_px, double y_px, double step_px) const {
    const glm::vec3 first(corner_ + x_px * right_ + y_px * down_);
    const glm::vec3 right(step_px * right_);
    const glm::vec3 down(step_px * down_);
    RTCRayHit16 packet{};  // from the eye, which is the origin
    for (int i = 0; i < kPacket; ++i) {
        const auto x = static_cast<float>(i % kPacketSide);
        const auto y = static_cast<float>(i / kPacketSide);
        packet.ray.dir_x[i] = first.x + x * right.x + y * down.x;
        packet.ray.dir_y[i] = first.y + x * right.y + y * down.y;
        packet.ray.dir_z[i] = first.z + x * right.z + y * down.z;
        packet.ray.tnear[i] = near_;
        packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
        packet.ray.mask[i] = 0xffffffffU;
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    truth::embree::Context context;
    truth::embree::init_context(context);
    truth::embree::intersect_16(kAll.data(), handles_.scene, context, nullptr, packet);
    PacketIds ids;
    std::copy(packet.hit.primID, packet.hit.primID + kPacket, ids.begin());
    return ids;
}

}  // namespace ink::bench
