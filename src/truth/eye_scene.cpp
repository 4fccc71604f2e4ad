#include "truth/eye_scene.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "truth/embree.h"

namespace ink::truth {

struct EyeScene::Handles : embree::Handles {};

/// What a filter knows of the query that called it; Embree hands the context back by its address.
struct EyeSceneQuery {
    explicit EyeSceneQuery(EyeScene::Callback confirm_) : confirm(confirm_) {
        embree::init_context(context);
    }
    embree::Context context{};  // first: the filter casts its address back
    EyeScene::Callback confirm;
    float best_t = std::numeric_limits<float>::infinity();
    std::uint32_t best_face = RTC_INVALID_GEOMETRY_ID;
};

namespace {

/// The power of two that scales the farthest vertex to below 1.
double unit_scale(const scene::Topology& topology, const glm::dvec3& eye_world) {
    double farthest = 0;
    for (const glm::dvec3& p : topology.p_world) {
        const glm::dvec3 d = glm::abs(p - eye_world);
        farthest = std::max({farthest, d.x, d.y, d.z});
    }
    return farthest > 0 ? std::ldexp(1.0, -std::ilogb(farthest) - 1) : 1.0;
}

void confirm_any(const RTCFilterFunctionNArguments* args) {
    auto& query = *reinterpret_cast<EyeSceneQuery*>(args->context);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0) continue;
        const unsigned face = RTCHitN_primID(args->hit, args->N, i);
        if (!query.confirm.function(query.confirm.object, face)) args->valid[i] = 0;
    }
}

/// Equal distances go to the lower face, or the answer would depend on the order of the tree's
/// leaves.
void confirm_first(const RTCFilterFunctionNArguments* args) {
    auto& query = *reinterpret_cast<EyeSceneQuery*>(args->context);
    assert(args->N == 1);
    if (args->valid[0] == 0) return;
    const unsigned face = RTCHitN_primID(args->hit, args->N, 0);
    const float t = RTCRayN_tfar(args->ray, args->N, 0);
    const bool is_better = t < query.best_t || (t == query.best_t && face < query.best_face);
    if (!is_better || !query.confirm.function(query.confirm.object, face)) {
        args->valid[0] = 0;
        return;
    }
    query.best_t = t;
    query.best_face = face;
}

/// What a filter knows of sixteen rays; each has its number as id.
struct PacketQuery {
    embree::Context context;  // first: the filter casts its address back
    std::array<float, 16> best_t{};
    std::array<std::uint32_t, 16> best_face{};
};

void keep_lowest_first(const RTCFilterFunctionNArguments* args) {
    auto& query = *reinterpret_cast<PacketQuery*>(args->context);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0) continue;
        const unsigned face = RTCHitN_primID(args->hit, args->N, i);
        const float t = RTCRayN_tfar(args->ray, args->N, i);
        const unsigned ray = RTCRayN_id(args->ray, args->N, i);
        float& best_t = query.best_t[ray];
        std::uint32_t& best_face = query.best_face[ray];
        if (t < best_t || (t == best_t && face < best_face)) {
            best_t = t;
            best_face = face;
        } else {
            args->valid[i] = 0;
        }
    }
}

}  // namespace

EyeScene::EyeScene(const scene::Topology& topology, const scene::Camera& camera, int threads)
    : handles_(std::make_unique<Handles>()),
      eye_world_(camera.eye_world),
      is_parallel_(camera.is_parallel()),
      scale_(unit_scale(topology, camera.eye_world)) {
    embree::build(*handles_, topology, threads, "truth", [&](const glm::dvec3& p_world) {
        return (p_world - eye_world_) * scale_;
    });
}

/// A line of sight as Embree has it.
struct EyeScene::Ray : RTCRay {
    Ray(const EyeScene& scene, const scene::SightLine& line, const RayRange& range)
        : RTCRay(embree::make_ray(
              line.way_world / glm::length(line.way_world),
              static_cast<float>(range.t_near * glm::length(line.way_world) * scene.scale_),
              static_cast<float>(range.t_far * glm::length(line.way_world) * scene.scale_))) {
        if (!scene.is_parallel_) return;
        const glm::dvec3 begin = (line.begin_world - scene.eye_world_) * scene.scale_;
        org_x = static_cast<float>(begin.x);
        org_y = static_cast<float>(begin.y);
        org_z = static_cast<float>(begin.z);
    }
};

EyeScene::~EyeScene() = default;

bool EyeScene::any_of(const EyeRay& ray, Callback confirm) const {
    EyeSceneQuery query(confirm);
    RTCRay rtc_ray = Ray(*this, ray, {ray.t_near, ray.t_far});
    embree::occluded(handles_->scene, query.context, &confirm_any, rtc_ray);
    return rtc_ray.tfar < 0;
}

bool EyeScene::any_of_packet(const std::array<scene::SightLine, 4>& lines,
                             const RayRange& range,
                             Callback confirm) const {
    EyeSceneQuery query(confirm);
    RTCRay4 packet{};
    for (std::size_t i = 0; i < 4; ++i)
        embree::put(Ray(*this, lines[i], range), i, packet);
    embree::occluded_4(handles_->scene, query.context, &confirm_any, packet);
    return std::any_of(packet.tfar, packet.tfar + 4, [](float t) { return t < 0; });
}

std::optional<EyeScene::Hit> EyeScene::first_of(const EyeRay& ray, Callback confirm) const {
    EyeSceneQuery query(confirm);
    RTCRayHit rtc_ray{};
    rtc_ray.ray = Ray(*this, ray, {ray.t_near, ray.t_far});
    rtc_ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(handles_->scene, query.context, &confirm_first, rtc_ray);
    if (rtc_ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const double length = glm::length(ray.way_world);
    return Hit{rtc_ray.hit.primID, rtc_ray.ray.tfar / (length * scale_)};
}

std::array<std::optional<EyeScene::Hit>, 16> EyeScene::first_of_sixteen(
    const std::array<scene::SightLine, 16>& lines,
    const RayRange& range,
    std::uint32_t valid) const {
    PacketQuery query{};
    embree::init_context(query.context);
    query.best_t.fill(std::numeric_limits<float>::infinity());
    query.best_face.fill(RTC_INVALID_GEOMETRY_ID);
    RTCRayHit16 packet{};
    alignas(64) std::array<int, 16> is_valid{};
    for (std::size_t i = 0; i < 16; ++i) {
        is_valid[i] = (valid >> i & 1U) != 0 ? -1 : 0;
        embree::put(Ray(*this, lines[i], range), i, packet);
    }
    embree::intersect_16(
        is_valid.data(), handles_->scene, query.context, &keep_lowest_first, packet);
    std::array<std::optional<Hit>, 16> hits;
    for (std::size_t i = 0; i < 16; ++i) {
        if (is_valid[i] == 0 || packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
        const double length = glm::length(lines[i].way_world);
        hits[i] = Hit{packet.hit.primID[i], packet.ray.tfar[i] / (length * scale_)};
    }
    return hits;
}

}  // namespace ink::truth
