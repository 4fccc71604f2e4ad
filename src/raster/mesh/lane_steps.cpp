#include "raster/mesh/lane_steps.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/mesh/lane_steps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

StepRange MakeSteps(const QuantisedDepth& depth, const double* inv_w, std::size_t count, float* q) {
    const hn::CappedTag<double, 8> d;
    const hn::Rebind<float, decltype(d)> df;
    const auto scale = hn::Set(d, depth.scale());
    const auto offset = hn::Set(d, depth.offset());
    const auto steps = [&](std::size_t i) {
        return hn::Add(hn::Mul(hn::LoadU(d, inv_w + i), scale), offset);
    };
    const auto first = hn::Set(d, inv_w[0] * depth.scale() + depth.offset());
    auto least = first;
    auto greatest = first;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto z = steps(i);
        const auto limited = hn::Min(hn::Max(z, hn::Set(d, 1)), hn::Set(d, depth.steps()));
        hn::StoreU(hn::DemoteTo(df, limited), df, q + i);
        const auto real = hn::IfThenElse(hn::FirstN(d, count - i), z, first);
        least = hn::Min(least, real);
        greatest = hn::Max(greatest, real);
    }
    return {hn::GetLane(hn::MinOfLanes(d, least)), hn::GetLane(hn::MaxOfLanes(d, greatest))};
}

template <class T>
void NarrowTo(const std::uint32_t* codes, std::size_t count, T* to) {
    const hn::CappedTag<std::int32_t, 16> d;
    const hn::Rebind<T, decltype(d)> dt;
    const auto low_bits = hn::Set(d, std::numeric_limits<T>::max());
    const auto* from = reinterpret_cast<const std::int32_t*>(codes);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        // Not TruncateTo: Highway 1.0.3 takes the wrong bytes on AVX3_DL.
        const auto code = hn::And(hn::LoadU(d, from + i), low_bits);
        hn::StoreU(hn::DemoteTo(dt, code), dt, to + i);
    }
}

void Narrow8(const std::uint32_t* codes, std::size_t count, std::uint8_t* to) {
    NarrowTo(codes, count, to);
}

void Narrow16(const std::uint32_t* codes, std::size_t count, std::uint16_t* to) {
    NarrowTo(codes, count, to);
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(MakeSteps);

StepRange make_steps(const QuantisedDepth& depth,
                     const double* inv_w,
                     std::size_t count,
                     float* q) {
    return HWY_DYNAMIC_DISPATCH(MakeSteps)(depth, inv_w, count, q);
}

HWY_EXPORT(Narrow8);
HWY_EXPORT(Narrow16);

void narrow(const std::uint32_t* codes, std::size_t count, std::uint8_t* to) {
    HWY_DYNAMIC_DISPATCH(Narrow8)(codes, count, to);
}

void narrow(const std::uint32_t* codes, std::size_t count, std::uint16_t* to) {
    HWY_DYNAMIC_DISPATCH(Narrow16)(codes, count, to);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
