#pragma once

/// The one door to Embree: what versions 3 and 4 call differently has one name here.
///
/// Only `eye_scene.cpp`, `sight_rays.cpp` (the two constructions of the truth, which share
/// nothing else of it) and the benchmarks include this header. Filters travel with the query in
/// both versions; in 3 they sit in the context, in 4 in the arguments, and the scene must be told
/// so when it is made.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/error.h"
#include "scene/topology.h"

namespace ink::truth::embree {

/// A device and a scene on it, released together.
struct Handles {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    Handles() = default;
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;
    ~Handles() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }
};

alignas(16) inline constexpr int kAllFour[4] = {-1, -1, -1, -1};  ///< every ray of a packet counts

#if RTC_VERSION_MAJOR >= 4

using Context = RTCRayQueryContext;
inline constexpr auto kSceneFlags =
    static_cast<RTCSceneFlags>(static_cast<int>(RTC_SCENE_FLAG_ROBUST) |
                               static_cast<int>(RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS));

inline void init_context(Context& context) {
    rtcInitRayQueryContext(&context);
}

inline void occluded(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRay& ray) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    arguments.filter = filter;
    arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
    rtcOccluded1(scene, &ray, &arguments);
}

inline void occluded_4(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRay4& rays) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    arguments.filter = filter;
    arguments.flags =
        static_cast<RTCRayQueryFlags>(static_cast<int>(RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER) |
                                      static_cast<int>(RTC_RAY_QUERY_FLAG_COHERENT));
    rtcOccluded4(kAllFour, scene, &rays, &arguments);
}

inline void intersect(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRayHit& ray) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    arguments.filter = filter;
    arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
    rtcIntersect1(scene, &ray, &arguments);
}

/// Sixteen rays that run close by; no filter if it is null.
inline void intersect_16(const int* valid,
                         RTCScene scene,
                         Context& context,
                         RTCFilterFunctionN filter,
                         RTCRayHit16& rays) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    arguments.filter = filter;
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    if (filter != nullptr) {
        arguments.flags = static_cast<RTCRayQueryFlags>(
            static_cast<int>(RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER) |
            static_cast<int>(RTC_RAY_QUERY_FLAG_COHERENT));
    }
    rtcIntersect16(valid, scene, &rays, &arguments);
}

#else

using Context = RTCIntersectContext;
inline constexpr auto kSceneFlags =
    static_cast<RTCSceneFlags>(static_cast<int>(RTC_SCENE_FLAG_ROBUST) |
                               static_cast<int>(RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));

inline void init_context(Context& context) {
    rtcInitIntersectContext(&context);
}

inline void occluded(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRay& ray) {
    context.filter = filter;
    rtcOccluded1(scene, &context, &ray);
}

inline void occluded_4(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRay4& rays) {
    context.filter = filter;
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded4(kAllFour, scene, &context, &rays);
}

inline void intersect(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRayHit& ray) {
    context.filter = filter;
    rtcIntersect1(scene, &context, &ray);
}

inline void intersect_16(const int* valid,
                         RTCScene scene,
                         Context& context,
                         RTCFilterFunctionN filter,
                         RTCRayHit16& rays) {
    context.filter = filter;
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, scene, &context, &rays);
}

#endif

/// A ray from the origin.
inline RTCRay make_ray(const glm::dvec3& direction, float near, float far) {
    RTCRay ray{};
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tnear = near;
    ray.tfar = far;
    ray.mask = 0xffffffffU;
    return ray;
}

/// Puts it into a packet of them.
template <class Packet>
void put(const RTCRay& ray, std::size_t i, Packet& packet) {
    packet.org_x[i] = ray.org_x;
    packet.org_y[i] = ray.org_y;
    packet.org_z[i] = ray.org_z;
    packet.dir_x[i] = ray.dir_x;
    packet.dir_y[i] = ray.dir_y;
    packet.dir_z[i] = ray.dir_z;
    packet.tnear[i] = ray.tnear;
    packet.tfar[i] = ray.tfar;
    packet.mask[i] = ray.mask;
}

inline void put(const RTCRay& ray, std::size_t i, RTCRayHit16& packet) {
    put(ray, i, packet.ray);
    packet.ray.id[i] = static_cast<unsigned>(i);
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
}

/// Refuses what Embree could not do, in the name of `who`; `device` may be null where it did not
/// start. Memory that is too short is told apart from all else.
inline void check_done(RTCDevice device, const char* who, const char* what, const char* accepted) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_OUT_OF_MEMORY)
        throw core::Error(who, "Embree found no memory for the scene", "a smaller scene");
    if (error != RTC_ERROR_NONE || device == nullptr) throw core::Error(who, what, accepted);
}

/// Builds the tree of a mesh's faces, with each vertex where `place(p_world)` puts it, which is
/// rounded to floats. Throws core::Error in the name of `who`.
template <class Place>
void build(
    Handles& handles, const scene::Topology& topology, int threads, const char* who, Place place) {
    handles.device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
    if (handles.device == nullptr)
        check_done(nullptr, who, "Embree could not start", "a CPU with at least SSE2");
    handles.scene = rtcNewScene(handles.device);
    rtcSetSceneFlags(handles.scene, kSceneFlags);
    if (!topology.faces.empty()) {
        RTCGeometry geometry = rtcNewGeometry(handles.device, RTC_GEOMETRY_TYPE_TRIANGLE);
        const auto buffer = [&](RTCBufferType type, RTCFormat format, std::size_t count) {
            return rtcSetNewGeometryBuffer(geometry, type, 0, format, 3 * sizeof(float), count);
        };
        auto* vertices = static_cast<float*>(
            buffer(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, topology.p_world.size()));
        auto* indices = static_cast<std::uint32_t*>(
            buffer(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, topology.faces.size()));
        if (vertices == nullptr || indices == nullptr) {
            rtcReleaseGeometry(geometry);
            throw core::Error(who, "Embree found no memory for the scene", "a smaller scene");
        }
        for (const glm::dvec3& p_world : topology.p_world) {
            const glm::dvec3 p = place(p_world);
            for (int axis = 0; axis < 3; ++axis)
                *vertices++ = static_cast<float>(p[axis]);
        }
        for (const scene::Face& face : topology.faces)
            indices = std::copy(face.vertices.begin(), face.vertices.end(), indices);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(handles.scene, geometry);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(handles.scene);
    check_done(handles.device, who, "Embree could not build the scene", "a smaller scene");
}

}  // namespace ink::truth::embree
