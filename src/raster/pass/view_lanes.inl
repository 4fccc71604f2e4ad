// No include guard of the usual kind: compiled once per SIMD target.
#if defined(INK_RASTER_VIEW_LANES_INL_) == defined(HWY_TARGET_TOGGLE)
#ifdef INK_RASTER_VIEW_LANES_INL_
#undef INK_RASTER_VIEW_LANES_INL_
#else
#define INK_RASTER_VIEW_LANES_INL_
#endif

#include <hwy/highway.h>

#include "raster/pass/view_transform.h"

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {

template <class V>
struct ClipLanes {
    V x, y, w;
};

/// ViewTransform::to_clip() of some points, in the order of its operations.
template <class D, class V>
HWY_INLINE ClipLanes<V> clip_lanes(D d, const ViewTransform& t, V x, V y, V z) {
    namespace hn = hwy::HWY_NAMESPACE;
    x = hn::Sub(x, hn::Set(d, t.eye[0]));
    y = hn::Sub(y, hn::Set(d, t.eye[1]));
    z = hn::Sub(z, hn::Set(d, t.eye[2]));
    const auto row = [&](int r) HWY_ATTR {
        const auto sum =
            hn::Add(hn::Mul(hn::Set(d, t.rows[r][0]), x), hn::Mul(hn::Set(d, t.rows[r][1]), y));
        return hn::Add(sum, hn::Mul(hn::Set(d, t.rows[r][2]), z));
    };
    ClipLanes<V> clip{row(0), row(1), row(2)};
    if (!t.is_parallel) return clip;
    clip.w = hn::Div(hn::Set(d, t.near_far), hn::Sub(hn::Set(d, t.near_plus_far), clip.w));
    clip.x = hn::Mul(hn::Add(clip.x, hn::Set(d, t.center_px[0])), clip.w);
    clip.y = hn::Mul(hn::Add(clip.y, hn::Set(d, t.center_px[1])), clip.w);
    return clip;
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
