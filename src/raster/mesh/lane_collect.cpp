#include "raster/mesh/lane_collect.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/mesh/lane_collect.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DI = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<DI>;
using DF = hn::Rebind<float, DI>;

#include "raster/mesh/lane_tables.inl"

/// Numbers of the corners of triangles of one slot.
class CornerLookup {
  public:
    /// `entries` as a list has them; `is_real` where they are this slot's.
    HWY_INLINE CornerLookup(const LaneSource& source,
                            const LaneSlot& slot,
                            VI entries,
                            hn::Mask<DI> is_real)
        : records_(reinterpret_cast<const std::int32_t*>(source.records + slot.first_byte)),
          slot_(slot) {
        const DI d;
        triangle_ = hn::IfThenElseZero(is_real, hn::And(entries, hn::Set(d, 0xff)));
        const auto corners = hn::GatherIndex(d, records_ + slot.corners * slot.stride, triangle_);
        for (int k = 0; k < 3; ++k)
            index_[k] = CornerOf(corners, k);
        is_back_ = hn::And(is_real, hn::Lt(corners, hn::Zero(d)));
        has_front_ = hn::CountTrue(d, is_back_) != hn::CountTrue(d, is_real);
        has_back_ = !hn::AllFalse(d, is_back_);
    }

    HWY_INLINE VI Constants() const {
        return hn::GatherIndex(DI(), records_ + slot_.constants, triangle_);
    }

    /// One array of the records, or one for triangles seen from their front and one for the others.
    template <class Store>
    HWY_INLINE void ForEachCorner(std::size_t front, std::size_t back, const Store& store) const {
        const bool is_one = front == back || !has_back_;
        const VertexTable table(records_ + (has_front_ ? front : back) * slot_.stride);
        if (is_one || !has_front_) {
            for (int k = 0; k < 3; ++k)
                store(k, table.At(index_[k]));
            return;
        }
        const VertexTable of_back(records_ + back * slot_.stride);
        for (int k = 0; k < 3; ++k)
            store(k, hn::IfThenElse(is_back_, of_back.At(index_[k]), table.At(index_[k])));
    }

  private:
    const std::int32_t* records_;
    const LaneSlot& slot_;
    VI triangle_;
    VI index_[3];
    hn::Mask<DI> is_back_;
    bool has_front_;
    bool has_back_;
};

/// The corners of the first triangles from `at` on as long as they are of one slot and fit a
/// vector; returns how many.
HWY_INLINE std::size_t CollectSome(const LaneSource& source,
                                   std::size_t values,
                                   bool has_constants,
                                   const std::uint32_t* entries,
                                   std::size_t at,
                                   std::size_t count,
                                   LaneTriangles& out) {
    const DI d;
    const DF df;
    const std::uint32_t number = entries[at] >> 8;
    const LaneSlot& slot = source.slots[number];
    const auto some = hn::LoadU(d, reinterpret_cast<const std::int32_t*>(entries) + at);
    const auto is_same =
        hn::And(hn::Eq(hn::ShiftRight<8>(some), hn::Set(d, static_cast<std::int32_t>(number))),
                hn::FirstN(d, count - at));
    const CornerLookup lookup(source, slot, some, is_same);
    lookup.ForEachCorner(0, 0, [&](int k, VI v) { hn::StoreU(v, d, out.corners[k].x + at); });
    lookup.ForEachCorner(1, 1, [&](int k, VI v) { hn::StoreU(v, d, out.corners[k].y + at); });
    lookup.ForEachCorner(slot.q[0], slot.q[1], [&](int k, VI v) {
        hn::StoreU(hn::BitCast(df, v), df, out.corners[k].q + at);
    });
    for (std::size_t i = 0; i < values; ++i) {
        lookup.ForEachCorner(slot.values[0] + i, slot.values[1] + i, [&](int k, VI v) {
            hn::StoreU(hn::BitCast(df, v), df, out.corners[k].values[i] + at);
        });
    }
    if (has_constants) hn::StoreU(lookup.Constants(), d, out.constants + at);
    return hn::CountTrue(d, is_same);  // a slot's triangles stand together
}

/// Looks the corners of all triangles up.
void Collect(const LaneSource& source,
             std::size_t values,
             bool has_constants,
             std::span<const std::uint32_t> entries,
             LaneTriangles& out) {
    alignas(64) std::uint32_t padded[LaneTriangles::kPadded];
    std::memcpy(padded, entries.data(), entries.size_bytes());
    std::fill_n(padded + entries.size(), kLanePad, 0U);
    for (std::size_t at = 0; at < entries.size();)
        at += CollectSome(source, values, has_constants, padded, at, entries.size(), out);
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(Collect);

void collect_corners(const LaneSource& source,
                     std::size_t values,
                     bool has_constants,
                     std::span<const std::uint32_t> entries,
                     LaneTriangles& out) {
    HWY_DYNAMIC_DISPATCH(Collect)(source, values, has_constants, entries, out);
}

}  // namespace ink::raster
#endif  // HWY_ONCE
