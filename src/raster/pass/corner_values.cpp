#include "raster/pass/corner_values.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/pass/corner_values.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DD = hn::CappedTag<double, 8>;
using DF = hn::Rebind<float, DD>;

/// One plane of all vertices.
void ComputePlane(const LinearValue& value,
                  bool reads_normals,
                  const CornerBatch& in,
                  float* front,
                  float* back) {
    const DD dd;
    const DF df;
    const std::size_t lanes = hn::Lanes(dd);
    const auto base = hn::Set(dd, value.base);
    const auto per_q = hn::Set(dd, value.per_q);
    for (std::size_t i = 0; i < in.count; i += lanes) {
        const auto depth = hn::Add(base, hn::Mul(per_q, hn::LoadU(dd, in.inv_w + i)));
        const auto flat = hn::DemoteTo(df, depth);
        auto bent = hn::Zero(df);
        if (reads_normals) {
            bent = hn::Mul(hn::Set(df, value.per_normal[0]), hn::LoadU(df, in.n_world[0] + i));
            for (int axis = 1; axis < 3; ++axis) {
                const auto n = hn::LoadU(df, in.n_world[axis] + i);
                bent = hn::Add(bent, hn::Mul(hn::Set(df, value.per_normal[axis]), n));
            }
        }
        hn::StoreU(hn::Add(flat, bent), df, front + i);
        if (back != nullptr) hn::StoreU(hn::Sub(flat, bent), df, back + i);
    }
}

void ComputeLinear(const LinearValue* values,
                   int planes,
                   bool reads_all,
                   const CornerBatch& in,
                   const CornerPlanes& out) {
    for (int k = 0; k < planes; ++k) {
        const float* w = values[k].per_normal;
        const bool has_weight = w[0] != 0 || w[1] != 0 || w[2] != 0;
        const bool reads = in.n_world[0] != nullptr && (has_weight || reads_all);
        ComputePlane(values[k], reads, in, out.front[k], out.back[k]);
    }
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(ComputeLinear);

void compute_linear(const LinearValue* values,
                    int planes,
                    bool reads_all,
                    const CornerBatch& in,
                    const CornerPlanes& out) {
    HWY_DYNAMIC_DISPATCH(ComputeLinear)(values, planes, reads_all, in, out);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
