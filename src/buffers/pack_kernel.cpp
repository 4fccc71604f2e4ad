#include "buffers/pack_kernel.h"

#include <algorithm>
#include <limits>

#include "method/depth_code.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "buffers/pack_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::buffers::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kMostLanes = 16;
using DF = hn::CappedTag<float, kMostLanes>;
using VF = hn::Vec<DF>;
using DI = hn::Rebind<std::int32_t, DF>;
using VI = hn::Vec<DI>;

/// A vector of pixels.
struct Pixels {
    VF depth;  ///< as it is summed: 0 .. 1
    VF n[3];
};

HWY_INLINE void Renormalise(VF (&n)[3]) {
    const DF d;
    const auto square =
        hn::Add(hn::Add(hn::Mul(n[0], n[0]), hn::Mul(n[1], n[1])), hn::Mul(n[2], n[2]));
    const auto one = hn::Set(d, 1);
    const auto has_length = hn::Gt(square, hn::Zero(d));
    const auto length = hn::Sqrt(hn::IfThenElse(has_length, square, one));
    const auto scale = hn::Div(one, length);
    for (VF& component : n)
        component = hn::Mul(component, scale);
}

/// The sum of a field's channels, rounded and brought to its bits.
HWY_INLINE VI Code(const PackField& field, const PackRules& rules, const Pixels& p) {
    const DF d;
    const auto half = hn::Set(d, 0.5F);
    const auto one = hn::Set(d, 1);
    VF terms[4];
    terms[0] = hn::Mul(hn::Set(d, field.depth), p.depth);
    for (int i = 0; i < 3; ++i) {
        terms[i + 1] = hn::Mul(hn::Mul(hn::Set(d, field.normal[i]), hn::Add(p.n[i], one)), half);
    }
    if (rules.rounds_each) {
        for (VF& term : terms)
            term = hn::Floor(hn::Add(term, half));
    }
    const auto sum = hn::Add(hn::Add(hn::Add(terms[0], terms[1]), terms[2]), terms[3]);
    const auto whole = hn::Floor(hn::Add(sum, hn::Set(d, field.offset + 0.5F)));
    const std::int32_t most = (1 << field.bits) - 1;
    if (rules.wraps) return hn::And(hn::ConvertTo(DI(), whole), hn::Set(DI(), most));
    const auto limited = hn::Min(hn::Max(whole, hn::Zero(d)), hn::Set(d, static_cast<float>(most)));
    return hn::ConvertTo(DI(), limited);
}

template <class T>
HWY_INLINE void PackVector(std::span<const PackField> fields,
                           const PackRules& rules,
                           const PixelRow& row,
                           int x,
                           T* codes) {
    const DF d;
    const DI di;
    const auto carried = hn::LoadU(d, row.depth + x);
    Pixels p;
    p.depth = rules.is_near_high ? carried : hn::Sub(hn::Set(d, 1), carried);
    p.n[0] = hn::LoadU(d, row.nx + x);
    p.n[1] = hn::LoadU(d, row.ny + x);
    p.n[2] = hn::LoadU(d, row.nz + x);
    if (row.renormalise) Renormalise(p.n);
    auto code = hn::Zero(di);
    for (const PackField& field : fields)
        code = hn::Or(code, hn::ShiftLeftSame(Code(field, rules, p), field.shift));
    const auto is_sky = hn::RebindMask(di, hn::Eq(carried, hn::Set(d, method::kNothingDrawn)));
    const auto sky = row.sky & static_cast<std::int32_t>(std::numeric_limits<T>::max());
    const auto kept = hn::IfThenElse(is_sky, hn::Set(di, sky), code);
    const hn::Rebind<T, DI> dt;
    hn::StoreU(hn::DemoteTo(dt, kept), dt, codes + x);
}

template <class T>
void PackRow(std::span<const PackField> fields,
             const PackRules& rules,
             const PixelRow& row,
             T* codes) {
    const int lanes = static_cast<int>(hn::Lanes(DF()));
    int x = 0;
    for (; x + lanes <= row.count; x += lanes)
        PackVector(fields, rules, row, x, codes);
    const int left = row.count - x;
    if (left == 0) return;
    // What does not fill a vector goes through one that does, so that nothing is read beyond a row.
    float padded[4][kMostLanes] = {};
    std::copy_n(row.depth + x, left, padded[0]);
    std::copy_n(row.nx + x, left, padded[1]);
    std::copy_n(row.ny + x, left, padded[2]);
    std::copy_n(row.nz + x, left, padded[3]);
    T last[kMostLanes];
    const PixelRow rest{padded[0], padded[1], padded[2], padded[3], left, row.renormalise, row.sky};
    PackVector(fields, rules, rest, 0, last);
    std::copy_n(last, left, codes + x);
}

void PackRow8(std::span<const PackField> fields,
              const PackRules& rules,
              const PixelRow& row,
              std::uint8_t* codes) {
    PackRow(fields, rules, row, codes);
}

void PackRow16(std::span<const PackField> fields,
               const PackRules& rules,
               const PixelRow& row,
               std::uint16_t* codes) {
    PackRow(fields, rules, row, codes);
}

}  // namespace ink::buffers::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::buffers {

HWY_EXPORT(PackRow8);
HWY_EXPORT(PackRow16);

void pack_pixels(std::span<const PackField> fields,
                 const PackRules& rules,
                 const PixelRow& row,
                 std::uint8_t* codes) {
    HWY_DYNAMIC_DISPATCH(PackRow8)(fields, rules, row, codes);
}

void pack_pixels(std::span<const PackField> fields,
                 const PackRules& rules,
                 const PixelRow& row,
                 std::uint16_t* codes) {
    HWY_DYNAMIC_DISPATCH(PackRow16)(fields, rules, row, codes);
}

}  // namespace ink::buffers
#endif  // HWY_ONCE
