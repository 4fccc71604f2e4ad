#include "crosscheck/sight_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "core/error.h"
#include "truth/embree.h"

namespace ink::crosscheck {

struct EmbreeRays::Handles : truth::embree::Handles {};

namespace {

/// What Embree's float distances cannot put in order is offered to the filter all the same.
constexpr float kSlack = 1 + 1e-4F;

/// One look on its way through the tree.
struct Look {
    truth::embree::Context context;  // first: the filter casts its address back
    const ClipMesh* mesh;
    glm::dvec2 p_px;
    double near;
    Foremost foremost;
};

/// The face that holds the point where Embree's rounding named a neighbour: found over the edges
/// that the point passes, as long as the surface goes on there. kNothing if it passes an end.
std::uint32_t holder_near(const ClipMesh& mesh, std::uint32_t face, const glm::dvec2& p_px) {
    constexpr int kMostSteps = 16;
    std::uint32_t came_by = kNothing;
    for (int step = 0; step < kMostSteps; ++step) {
        const LocalFace local = mesh.local_face(face, p_px);
        if (!ClipMesh::holds(local, kReach_px)) return kNothing;
        std::size_t passed = 3;
        for (std::size_t i = 0; i < 3; ++i) {
            const bool is_back = mesh.topology().faces[face].edges[i] == came_by;
            if (local.orientation * local.area[i] < 0 && !is_back) passed = i;
        }
        if (passed == 3) return face;
        came_by = mesh.topology().faces[face].edges[passed];
        face = mesh.across(face, passed).face;
        if (face == kNothing) return kNothing;
    }
    return face;
}

/// Takes a candidate if double arithmetic finds it on the ray, and has Embree go on a little behind
/// it.
void take(const RTCFilterFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& look = *reinterpret_cast<Look*>(args->context);
    std::uint32_t face = RTCHitN_primID(args->hit, args->N, 0);
    LocalFace local = look.mesh->local_face(face, look.p_px);
    if (!ClipMesh::holds(local, 0)) {
        face = holder_near(*look.mesh, face, look.p_px);
        if (face != kNothing) local = look.mesh->local_face(face, look.p_px);
    }
    const double w = face == kNothing ? 0 : ClipMesh::depth(local);
    if (w < look.near) {
        args->valid[0] = 0;
        return;
    }
    look.foremost.add(*look.mesh, {face, w});
    RTCRayN_tfar(args->ray, args->N, 0) *= kSlack;
}

float* new_vertices(RTCGeometry geometry, std::size_t count) {
    return static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), count));
}

std::uint32_t* new_indices(RTCGeometry geometry, std::size_t count) {
    return static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
}

}  // namespace

void Foremost::add(const ClipMesh& mesh, const Sight& sight) {
    if (!may_take(sight.w)) return;
    const bool is_level = seen_.face != kNothing && mesh.is_level(nearest_.face, sight.face);
    if (is_level) {
        seen_.face = std::min(seen_.face, sight.face);
    } else if (sight.w < nearest_.w) {
        seen_.face = sight.face;
    }
    if (sight.w < nearest_.w) nearest_ = sight;
    seen_.w = nearest_.w;
}

EmbreeRays::EmbreeRays(const ClipMesh& mesh, int threads)
    : SightRays(mesh), handles_(std::make_unique<Handles>()) {
    const scene::Topology& topology = mesh.topology();
    handles_->device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
    if (handles_->device == nullptr) {
        throw core::Error("crosscheck", "Embree could not start", "a CPU with at least SSE2");
    }
    handles_->scene = rtcNewScene(handles_->device);
    rtcSetSceneFlags(handles_->scene, truth::embree::kSceneFlags);

    double largest = 0;
    for (const glm::dvec3& p : topology.p_world)
        largest = std::max(largest, glm::length(mesh.projection().to_view(p)));
    scale_ = largest > 0 ? std::exp2(-std::ceil(std::log2(largest))) : 1;

    if (!topology.faces.empty()) {
        RTCGeometry geometry = rtcNewGeometry(handles_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
        float* vertices = new_vertices(geometry, topology.p_world.size());
        std::uint32_t* indices = new_indices(geometry, topology.faces.size());
        if (vertices == nullptr || indices == nullptr) {
            rtcReleaseGeometry(geometry);
            throw core::Error(
                "crosscheck", "Embree found no memory for the scene", "a smaller scene");
        }
        for (const glm::dvec3& p : topology.p_world) {
            const glm::dvec3 p_view = mesh.projection().to_view(p) * scale_;
            for (int i = 0; i < 3; ++i)
                *vertices++ = static_cast<float>(p_view[i]);
        }
        for (const scene::Face& face : topology.faces)
            indices = std::copy(face.vertices.begin(), face.vertices.end(), indices);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(handles_->scene, geometry);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(handles_->scene);
    if (rtcGetDeviceError(handles_->device) != RTC_ERROR_NONE) {
        throw core::Error("crosscheck", "Embree could not build the scene", "a smaller scene");
    }
}

EmbreeRays::~EmbreeRays() = default;

Sight EmbreeRays::look(const glm::dvec2& p_px) const {
    Look look;
    truth::embree::init_context(look.context);
    look.mesh = &mesh();
    look.p_px = p_px;
    look.near = mesh().view().camera.near;

    // Unit depth along the view direction, so that distances along the ray are w.
    const double focal_px = mesh().projection().focal_px();
    RTCRayHit query{};
    query.ray.dir_x = static_cast<float>((p_px.x - mesh().view().width_px / 2.0) / focal_px);
    query.ray.dir_y = static_cast<float>((mesh().view().height_px / 2.0 - p_px.y) / focal_px);
    query.ray.dir_z = -1;
    query.ray.tnear = static_cast<float>(look.near * scale_) / kSlack;
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.ray.mask = 0xffffffffU;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    truth::embree::intersect(handles_->scene, look.context, &take, query);

    return look.foremost.seen();
}

void EmbreeRays::look_along(const glm::dvec2& first_px, std::span<Sight> sights) const {
    truth::embree::Context context;
    truth::embree::init_context(context);
    const double focal_px = mesh().projection().focal_px();
    const scene::View& view = mesh().view();
    alignas(64) std::array<int, kPacket> valid{};
    alignas(64) RTCRayHit16 query{};
    for (int i = 0; i < kPacket; ++i) {
        valid[i] = i < static_cast<int>(sights.size()) ? -1 : 0;
        query.ray.dir_x[i] = static_cast<float>((first_px.x + i - view.width_px / 2.0) / focal_px);
        query.ray.dir_y[i] = static_cast<float>((view.height_px / 2.0 - first_px.y) / focal_px);
        query.ray.dir_z[i] = -1;
        query.ray.tnear[i] = static_cast<float>(view.camera.near * scale_) / kSlack;
        query.ray.tfar[i] = std::numeric_limits<float>::infinity();
        query.ray.mask[i] = 0xffffffffU;
        query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    truth::embree::intersect_16(valid.data(), handles_->scene, context, nullptr, query);
    for (std::size_t i = 0; i < sights.size(); ++i) {
        sights[i] = {};
        if (query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
        const glm::dvec2 p_px = first_px + glm::dvec2(static_cast<double>(i), 0);
        const LocalFace local = mesh().local_face(query.hit.primID[i], p_px);
        const double w = ClipMesh::holds(local, 0) ? ClipMesh::depth(local) : 0;
        sights[i] = w < view.camera.near ? look(p_px) : Sight{query.hit.primID[i], w};
    }
}

}  // namespace ink::crosscheck
