#include "raster/lane_narrow.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/lane_narrow.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class T>
void NarrowTo(const std::uint32_t* codes, std::size_t count, T* to) {
    const hn::CappedTag<std::uint32_t, 16> d;
    const hn::Rebind<T, decltype(d)> dt;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d))
        hn::StoreU(hn::TruncateTo(dt, hn::LoadU(d, codes + i)), dt, to + i);
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
