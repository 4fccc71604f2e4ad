#include "bench/ray_tree.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace ink::bench {
namespace {

alignas(64) constexpr std::array<int, kPacket> kAll = {
    -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};

/// A buffer of Embree's own, of `values` as items of three.
template <class T>
void set_buffer(RTCGeometry geometry,
                RTCBufferType type,
                RTCFormat format,
                const std::vector<T>& values) {
    auto* buffer = static_cast<T*>(
        rtcSetNewGeometryBuffer(geometry, type, 0, format, 3 * sizeof(T), values.size() / 3));
    std::copy(values.begin(), values.end(), buffer);
}

}  // namespace

RayTree::RayTree(const scene::Scene& scene, const scene::View& view)
    : near_(static_cast<float>(view.camera.near)) {
    const scene::Projection projection(view);
    corner_ = projection.ray_world(0, 0);
    right_ = projection.ray_world(1, 0) - corner_;
    down_ = projection.ray_world(0, 1) - corner_;
    handles_.device = rtcNewDevice("threads=1");
    handles_.scene = rtcNewScene(handles_.device);
    rtcSetSceneFlags(handles_.scene, RTC_SCENE_FLAG_ROBUST);
    add_triangles(scene, view.camera.eye_world);
    rtcCommitScene(handles_.scene);
}

void RayTree::add_triangles(const scene::Scene& scene, const glm::dvec3& eye_world) {
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        const auto first = static_cast<std::uint32_t>(positions.size() / 3);
        for (const glm::vec3& p_object : mesh.positions) {
            const glm::dvec3 p = scene::to_world(instance, p_object) - eye_world;
            for (int i = 0; i < 3; ++i)
                positions.push_back(static_cast<float>(p[i]));
        }
        for (const scene::Triangle& t : mesh.triangles) {
            for (const std::uint32_t v : t)
                indices.push_back(first + v);
        }
    }
    RTCGeometry geometry = rtcNewGeometry(handles_.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    set_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions);
    set_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(handles_.scene, geometry);
    rtcReleaseGeometry(geometry);
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
