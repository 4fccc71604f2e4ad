#include "raster/lines/line_vertices.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/lines/line_vertices.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/pass/view_lanes.inl"

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DD = hn::CappedTag<double, 8>;
using VD = hn::Vec<DD>;

/// A vector of vertices; false, with nothing of use written, if one of them is beyond the near
/// plane or so far outside the image that it takes more than this.
HWY_INLINE bool ProjectSome(const ViewTransform& t,
                            double near,
                            const double* p_world,
                            const ScreenVertices& to,
                            std::size_t at) {
    const DD d;
    const hn::Rebind<std::int32_t, DD> di;
    VD x, y, z;
    hn::LoadInterleaved3(d, p_world, x, y, z);
    const auto [cx, cy, cw] = clip_lanes(d, t, x, y, z);
    const auto q = hn::Div(hn::Set(d, 1), cw);
    const auto x_px = hn::Mul(cx, q);
    const auto y_px = hn::Mul(cy, q);
    // Within this reach and w both are far inside the guard band, and finite.
    const auto reach = hn::Set(d, kLaneReach_px);
    const auto far = hn::Max(hn::Abs(x_px), hn::Abs(y_px));
    const auto is_inside =
        hn::And(hn::And(hn::Ge(cw, hn::Set(d, near)), hn::Le(cw, hn::Set(d, 1e100))),
                hn::And(hn::Le(far, reach), hn::And(hn::Eq(x_px, x_px), hn::Eq(y_px, y_px))));
    if (!hn::AllTrue(d, is_inside)) return false;

    const std::size_t lanes = hn::Lanes(d);
    alignas(64) double numbers[3][8];
    alignas(64) std::int32_t fixed[2][8];
    const auto scale = hn::Set(d, 1 << kLaneBits);
    hn::Store(x_px, d, numbers[0]);
    hn::Store(y_px, d, numbers[1]);
    hn::Store(q, d, numbers[2]);
    hn::Store(hn::DemoteTo(di, hn::Round(hn::Mul(x_px, scale))), di, fixed[0]);
    hn::Store(hn::DemoteTo(di, hn::Round(hn::Mul(y_px, scale))), di, fixed[1]);
    hn::StoreInterleaved3(cx, cy, cw, d, &to.p_clip[at].x);
    for (std::size_t i = 0; i < lanes; ++i) {
        to.outcodes[at + i] = kInside;
        to.screen[at + i] = {numbers[0][i],
                             numbers[1][i],
                             numbers[2][i],
                             snapped(fixed[0][i]),
                             snapped(fixed[1][i])};
    }
    return true;
}

void ProjectVertices(const ViewTransform& t,
                     double near,
                     const glm::dvec3* p_world,
                     std::size_t count,
                     const ScreenVertices& to) {
    static_assert(sizeof(glm::dvec3) == 3 * sizeof(double));
    const std::size_t lanes = hn::Lanes(DD());
    for (std::size_t at = 0; at < count; at += lanes) {
        if (at + lanes <= count && ProjectSome(t, near, &p_world[at].x, to, at)) continue;
        for (std::size_t i = at; i < count && i < at + lanes; ++i) {
            to.p_clip[i] = t.to_clip(p_world[i]);
            to.outcodes[i] = outcode(to.p_clip[i], near);
            if (to.outcodes[i] == kInside) to.screen[i] = to_screen(to.p_clip[i]);
        }
    }
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(ProjectVertices);

void project_vertices(const ViewTransform& transform,
                      double near,
                      const glm::dvec3* p_world,
                      std::size_t count,
                      const ScreenVertices& to) {
    HWY_DYNAMIC_DISPATCH(ProjectVertices)(transform, near, p_world, count, to);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
