#include "crosscheck/sight_rays.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "truth/embree.h"

namespace ink::crosscheck {

struct EmbreeRays::Handles : truth::embree::Handles {};

namespace {

/// What Embree's float distances cannot put in order is offered to the filter all the same.
constexpr float kRaySlack = 1 + 1e-4F;

/// One look on its way through the tree.
struct Look {
    truth::embree::Context context;  // first: the filter casts its address back
    const ClipMesh* mesh = nullptr;
    glm::dvec2 p_px{0};
    double near = 0;
    Foremost foremost;
};

/// What Embree offers to one ray of a packet: the faces near the front, in its order.
struct Offers {
    static constexpr std::size_t kMost = 6;
    std::array<std::uint32_t, kMost> faces{};
    std::array<float, kMost> distances{};
    std::size_t count = 0;
    bool is_full = false;  ///< some have found no place

    void add(std::uint32_t face, float distance) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (distances[i] > distance * kRaySlack) continue;
            faces[kept] = faces[i];
            distances[kept++] = distances[i];
        }
        is_full = is_full || kept == kMost;
        if (kept == kMost) return;
        faces[kept] = face;
        distances[kept] = distance;
        count = kept + 1;
    }
};

/// The same for rays that go together; a ray's id says which is its.
struct Packet {
    truth::embree::Context context;  // first, as above
    std::array<Offers, EmbreeRays::kPacket> offers;
};

using Valid = std::array<int, EmbreeRays::kPacket>;

/// The ray to a point from near to infinity, of unit depth along the view direction, so that
/// distances along it are depths.
RTCRay ray_to(const ClipMesh& mesh, const glm::dvec2& p_px, float near, double scale) {
    const double focal_px = mesh.projection().px_per_world(1);
    const double x = (p_px.x - mesh.view().width_px / 2.0) / focal_px;
    const double y = (mesh.view().height_px / 2.0 - p_px.y) / focal_px;
    constexpr float kEndless = std::numeric_limits<float>::infinity();
    if (!mesh.projection().is_parallel())
        return truth::embree::make_ray({x, y, -1}, near, kEndless);
    RTCRay ray = truth::embree::make_ray({0, 0, -1}, near, kEndless);
    ray.org_x = static_cast<float>(x * scale);
    ray.org_y = static_cast<float>(y * scale);
    return ray;
}

/// One ray of a packet.
void aim(RTCRayHit16& query, Valid& valid, std::size_t i, const RTCRay& ray) {
    valid[i] = -1;
    truth::embree::put(ray, i, query);
}

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
    RTCRayN_tfar(args->ray, args->N, 0) *= kRaySlack;
}

/// Keeps what the rays of a packet are offered, and has Embree go on a little behind it.
void keep(const RTCFilterFunctionNArguments* args) {
    auto& packet = *reinterpret_cast<Packet*>(args->context);
    for (unsigned int lane = 0; lane < args->N; ++lane) {
        if (args->valid[lane] == 0) continue;
        float& distance = RTCRayN_tfar(args->ray, args->N, lane);
        packet.offers[RTCRayN_id(args->ray, args->N, lane)].add(
            RTCHitN_primID(args->hit, args->N, lane), distance);
        distance *= kRaySlack;
    }
}

}  // namespace

void Foremost::add(const ClipMesh& mesh, const Sight& sight) {
    if (!may_take(sight.w)) return;
    const bool is_level = seen_.face != kNothing && nearest_.w <= sight.w * kAlmost &&
                          mesh.is_level(nearest_.face, sight.face);
    if (is_level) {
        seen_.face = std::min(seen_.face, sight.face);
    } else if (sight.w < nearest_.w) {
        seen_.face = sight.face;
    }
    if (sight.w < nearest_.w) nearest_ = sight;
    seen_.w = nearest_.w;
}

EmbreeRays::EmbreeRays(const ClipMesh& mesh, int threads)
    : SightRays(mesh, kReach_px), handles_(std::make_unique<Handles>()) {
    const scene::Topology& topology = mesh.topology();
    double largest = 0;
    for (const glm::dvec3& p : topology.p_world)
        largest = std::max(largest, glm::length(mesh.projection().to_view(p)));
    scale_ = largest > 0 ? std::exp2(-std::ceil(std::log2(largest))) : 1;
    truth::embree::build(*handles_, topology, threads, "crosscheck", [&](const glm::dvec3& p) {
        return mesh.projection().to_view(p) * scale_;
    });
}

EmbreeRays::~EmbreeRays() = default;

float EmbreeRays::near() const {
    return static_cast<float>(mesh().view().camera.near * scale_) / kRaySlack;
}

Sight EmbreeRays::look(const glm::dvec2& p_px) const {
    Look look;
    truth::embree::init_context(look.context);
    look.mesh = &mesh();
    look.p_px = p_px;
    look.near = mesh().view().camera.near;

    RTCRayHit query{};
    query.ray = ray_to(mesh(), p_px, near(), scale_);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    truth::embree::intersect(handles_->scene, look.context, &take, query);
    return look.foremost.seen();
}

void SightRays::look_at(std::span<const glm::dvec2> points_px, std::span<Sight> sights) const {
    for (std::size_t i = 0; i < points_px.size(); ++i)
        sights[i] = look(points_px[i]);
}

void EmbreeRays::look_at(std::span<const glm::dvec2> points_px, std::span<Sight> sights) const {
    for (std::size_t begin = 0; begin < points_px.size(); begin += kPacket) {
        const std::size_t count = std::min<std::size_t>(kPacket, points_px.size() - begin);
        look_at_packet(points_px.subspan(begin, count), sights.subspan(begin, count));
    }
}

void EmbreeRays::look_at_packet(std::span<const glm::dvec2> points_px,
                                std::span<Sight> sights) const {
    Packet packet;
    truth::embree::init_context(packet.context);
    alignas(64) Valid valid{};
    alignas(64) RTCRayHit16 query{};
    for (std::size_t i = 0; i < points_px.size(); ++i)
        aim(query, valid, i, ray_to(mesh(), points_px[i], near(), scale_));
    truth::embree::intersect_16(valid.data(), handles_->scene, packet.context, &keep, query);
    for (std::size_t i = 0; i < sights.size(); ++i) {
        const Offers& offers = packet.offers[i];
        Foremost foremost;
        bool is_sure = !offers.is_full;
        for (std::size_t k = 0; k < offers.count && is_sure; ++k) {
            const LocalFace local = mesh().local_face(offers.faces[k], points_px[i]);
            const double w = ClipMesh::holds(local, 0) ? ClipMesh::depth(local) : 0;
            is_sure = w >= mesh().view().camera.near;
            foremost.add(mesh(), {offers.faces[k], w});
        }
        // What misses the point or is too near may have hidden others from Embree.
        sights[i] = is_sure ? foremost.seen() : look(points_px[i]);
    }
}

void EmbreeRays::look_along(const glm::dvec2& first_px, std::span<Sight> sights) const {
    truth::embree::Context context;
    truth::embree::init_context(context);
    const auto point_px = [&](std::size_t i) {
        return first_px + glm::dvec2(static_cast<double>(i), 0);
    };
    alignas(64) Valid valid{};
    alignas(64) RTCRayHit16 query{};
    for (std::size_t i = 0; i < sights.size(); ++i)
        aim(query, valid, i, ray_to(mesh(), point_px(i), near(), scale_));
    truth::embree::intersect_16(valid.data(), handles_->scene, context, nullptr, query);
    for (std::size_t i = 0; i < sights.size(); ++i) {
        sights[i] = {};
        if (query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
        const glm::dvec2 p_px = point_px(i);
        const LocalFace local = mesh().local_face(query.hit.primID[i], p_px);
        const double w = ClipMesh::holds(local, 0) ? ClipMesh::depth(local) : 0;
        sights[i] = w < mesh().view().camera.near ? look(p_px) : Sight{query.hit.primID[i], w};
    }
}

}  // namespace ink::crosscheck
