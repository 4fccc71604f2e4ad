#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/mesh_lookup/screen_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "edge/vector_loops.inl"
#include "methods/mesh_lookup/screen_kernel.h"
#include "raster/pass/screen_vertex.h"
#include "raster/pass/view_lanes.inl"
#include "scene/predicates.h"

HWY_BEFORE_NAMESPACE();
namespace ink::methods::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

bool project(std::span<const glm::dvec3> p_world,
             const raster::ViewTransform& transform,
             double near,
             std::span<double> q,
             std::span<glm::ivec2> places) {
    bool reaches_near = false;
    const auto one_by_one = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec3 p_clip = transform.to_clip(p_world[i]);
            q[i] = 0;
            const bool is_before = p_clip.z < near;
            places[i] = {kOffScreen, is_before ? kBeforeNear : kFarOut};
            reaches_near |= is_before;
            if (raster::outcode(p_clip, near) != raster::kInside) continue;
            const raster::ScreenVertex at = raster::to_screen(p_clip);
            q[i] = at.q;
            places[i] = {at.x, at.y};
        }
    };
    const hn::ScalableTag<double> d;
    const hn::Rebind<std::int32_t, decltype(d)> d_place;
    const std::size_t lanes = hn::Lanes(d);
    constexpr double kMostW = 1e140;  // as good as infinite
    const auto reach = hn::Set(d, raster::kLaneReach_px);
    std::size_t i = 0;
    for (; i + lanes <= p_world.size(); i += lanes) {
        decltype(hn::Zero(d)) x, y, z;
        hn::LoadInterleaved3(d, &p_world[i].x, x, y, z);
        const auto clip = raster::HWY_NAMESPACE::clip_lanes(d, transform, x, y, z);
        const auto w = clip.w;
        const auto inv_w = hn::Div(hn::Set(d, 1.0), w);
        const auto x_px = hn::Mul(clip.x, inv_w), y_px = hn::Mul(clip.y, inv_w);
        const auto is_plain =
            hn::And(hn::And(hn::Ge(w, hn::Set(d, near)), hn::Le(w, hn::Set(d, kMostW))),
                    hn::And(hn::Le(hn::Abs(x_px), reach), hn::Le(hn::Abs(y_px), reach)));
        if (!hn::AllTrue(d, is_plain)) {
            one_by_one(i, i + lanes);
            continue;
        }
        const auto snapped = [&](auto px) HWY_ATTR {
            const auto fixed = hn::DemoteTo(
                d_place, hn::Round(hn::Mul(px, hn::Set(d, double{1 << raster::kLaneBits}))));
            constexpr int kDropped = raster::kLaneBits - raster::kSubpixelBits;
            return hn::ShiftRight<kDropped>(hn::Add(fixed, hn::Set(d_place, 1 << (kDropped - 1))));
        };
        hn::StoreU(inv_w, d, &q[i]);
        hn::StoreInterleaved2(snapped(x_px), snapped(y_px), d_place, &places[i].x);
    }
    one_by_one(i, p_world.size());
    return reaches_near;
}

void facing_by_planes(const LookupMesh& mesh,
                      const scene::Viewpoint& viewpoint,
                      std::size_t begin,
                      std::size_t end,
                      std::int8_t* facing) {
    const bool is_far = viewpoint.is_direction;  // no plane's distance counts there
    const glm::vec3 eye = is_far ? -viewpoint.at_world : viewpoint.at_world - mesh.origin_world;
    const float doubt =
        LookupMesh::kPlaneRounding *
        (std::abs(eye.x) + std::abs(eye.y) + std::abs(eye.z) + (is_far ? 0 : mesh.reach_world));
    const float counts = is_far ? 0 : 1;
    const float* const x = mesh.planes[0].data();
    const float* const y = mesh.planes[1].data();
    const float* const z = mesh.planes[2].data();
    const float* const distance = mesh.planes[3].data();
    edge::HWY_NAMESPACE::cover_once<float, std::min<int>(16, HWY_LANES(float))>(
        static_cast<int>(end - begin), [&](auto d, int i) HWY_ATTR {
            const hn::RebindToSigned<decltype(d)> d_wide;
            const hn::Rebind<std::int8_t, decltype(d)> d_side;
            const std::size_t at = begin + static_cast<std::size_t>(i);
            const auto term = [&](const float* n, float e)
                                  HWY_ATTR { return hn::Mul(hn::LoadU(d, n + at), hn::Set(d, e)); };
            const auto height =
                hn::Sub(hn::Add(hn::Add(term(x, eye.x), term(y, eye.y)), term(z, eye.z)),
                        hn::Mul(hn::LoadU(d, distance + at), hn::Set(d, counts)));
            const auto is_front = hn::RebindMask(d_wide, hn::Gt(height, hn::Set(d, doubt)));
            const auto is_back = hn::RebindMask(d_wide, hn::Lt(height, hn::Set(d, -doubt)));
            const auto side =
                hn::IfThenElse(is_front,
                               hn::Set(d_wide, 1),
                               hn::IfThenElse(is_back,
                                              hn::Set(d_wide, -1),
                                              hn::Set(d_wide, std::int32_t{LookupMesh::kInDoubt})));
            hn::StoreU(hn::DemoteTo(d_side, side), d_side, facing + at);
        });
}

}  // namespace ink::methods::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::methods {
namespace {

HWY_EXPORT(project);
HWY_EXPORT(facing_by_planes);

}  // namespace

bool to_screen(std::span<const glm::dvec3> p_world,
               const raster::ViewTransform& transform,
               double near,
               std::span<double> q,
               std::span<glm::ivec2> places) {
    return HWY_DYNAMIC_DISPATCH(project)(p_world, transform, near, q, places);
}

void find_facing(const LookupMesh& mesh,
                 const scene::Viewpoint& viewpoint,
                 std::size_t begin,
                 std::size_t end,
                 std::span<std::int8_t> facing) {
    HWY_DYNAMIC_DISPATCH(facing_by_planes)(mesh, viewpoint, begin, end, facing.data());
    for (std::size_t f = begin; f < end; ++f) {
        if (facing[f] != LookupMesh::kInDoubt) continue;
        const auto& [a, b, c] = mesh.faces[f].vertices;
        facing[f] = static_cast<std::int8_t>(
            scene::facing(mesh.p_world[a], mesh.p_world[b], mesh.p_world[c], viewpoint));
    }
}

}  // namespace ink::methods
#endif
