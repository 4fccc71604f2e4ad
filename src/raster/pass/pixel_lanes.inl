// Pixels of one triangle in vectors, per SIMD target: included by triangle_fill.cpp inside its
// HWY_NAMESPACE, after `hn`.

// Sixteen pixels of a row where the target has them, one on SCALAR. Planes are doubles and 64-bit
// integers, as set_up left them: two vectors of half as many pixels.
using DI = hn::CappedTag<std::int32_t, 16>;
using VI = hn::Vec<DI>;
using MI = hn::Mask<DI>;
using DU = hn::RebindToUnsigned<DI>;
using DF = hn::Rebind<float, DI>;
using VF = hn::Vec<DF>;
#if HWY_TARGET == HWY_SCALAR
constexpr int kParts = 1;
using DIPart = DI;
#else
constexpr int kParts = 2;
using DIPart = hn::Half<DI>;
#endif
using DUPart = hn::RebindToUnsigned<DIPart>;
using DFPart = hn::Rebind<float, DIPart>;
using DD = hn::Rebind<double, DIPart>;
using VD = hn::Vec<DD>;
using DL = hn::Rebind<std::int64_t, DIPart>;
using VL = hn::Vec<DL>;

/// Pixels of a vector, from its first.
alignas(64) constexpr std::int32_t kRamp[16] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// A vector of pixels with 64 bits each, in the order of the row.
template <class V>
struct Wide {
    V part[kParts];

    template <class F>
    HWY_INLINE Wide map(const F& f) const {
        Wide result;
        for (int i = 0; i < kParts; ++i)
            result.part[i] = f(part[i]);
        return result;
    }
};
using Doubles = Wide<VD>;
using Longs = Wide<VL>;

/// The parts of a vector of 32 bits, each made wide by D.
template <class D>
HWY_INLINE Wide<hn::Vec<D>> Widen(D d, VI v) {
    Wide<hn::Vec<D>> wide;
#if HWY_TARGET == HWY_SCALAR
    wide.part[0] = hn::PromoteTo(d, v);
#else
    wide.part[0] = hn::PromoteTo(d, hn::LowerHalf(DIPart(), v));
    wide.part[1] = hn::PromoteTo(d, hn::UpperHalf(DIPart(), v));
#endif
    return wide;
}

/// One vector of what `narrow` makes of each part.
template <class D, class V, class F>
HWY_INLINE hn::Vec<D> Join([[maybe_unused]] D d, const Wide<V>& v, const F& narrow) {
#if HWY_TARGET == HWY_SCALAR
    return narrow(v.part[0]);
#else
    return hn::Combine(d, narrow(v.part[1]), narrow(v.part[0]));
#endif
}

/// Each rounded to float once.
HWY_INLINE VF ToFloats(const Doubles& v) {
    return Join(DF(), v, [](VD part) { return hn::DemoteTo(DFPart(), part); });
}

/// What a plane holds at the reference column, row by row: each row's bits are those of the sum
/// that the plain loop forms.
class RowStarts {
  public:
    void fill(const Plane& plane, int first_row_from_ref, int rows) {
        const DD d;
        const DIPart di;
        const auto at_ref = hn::Set(d, plane.at_ref);
        const auto dy = hn::Set(d, plane.dy);
        const int lanes = static_cast<int>(hn::Lanes(d));
        for (int row = 0; row < rows; row += lanes) {
            const auto from_ref =
                hn::Add(hn::Load(di, kRamp), hn::Set(di, first_row_from_ref + row));
            hn::Store(hn::Add(at_ref, hn::Mul(dy, hn::PromoteTo(d, from_ref))), d, at_ + row);
        }
    }
    [[nodiscard]] HWY_INLINE VD at(int row) const { return hn::Set(DD(), at_[row]); }

  private:
    static constexpr int kRoom = (kTileRows + 15) / 16 * 16;
    alignas(64) double at_[kRoom];
};

/// The part of a plane that runs along a row.
HWY_INLINE Doubles Ramp(const Plane& plane, const Doubles& from_ref) {
    const auto dx = hn::Set(DD(), plane.dx);
    return from_ref.map([&](VD part) { return hn::Mul(dx, part); });
}

HWY_INLINE void Put(VI v, MI mask, std::int32_t* to) {
    const DI d;
    hn::StoreU(hn::IfThenElse(mask, v, hn::LoadU(d, to)), d, to);
}

/// What a triangle leaves in a tile.
struct OneTriangle {
    const PassFormat& format;
    const Batch& batch;
    std::uint32_t index;
    int y0;  ///< the rows of the tile that it may touch
    int rows;
    std::uint32_t constant;

    [[nodiscard]] const SetupTriangle& setup() const { return batch.triangles[index]; }
    [[nodiscard]] int first_row() const { return y0 - setup().ref_y; }
    template <class P>
    [[nodiscard]] const P* planes(const std::vector<P>& all) const {
        return all.data() + index * static_cast<std::size_t>(format.interpolants);
    }
};

// Stores of depth: Test writes what is nearer where `mask` allows it, and returns where it was.

class FloatDepthLanes {
  public:
    using Value = float;
    FloatDepthLanes(const SetupTriangle& t, const QuantisedDepth&)
        // Rounding keeps order: limited after it is as good as before.
        : low_(hn::Set(DF(), static_cast<float>(t.q_min))),
          high_(hn::Set(DF(), static_cast<float>(t.q_max))) {}
    HWY_INLINE MI Test(const Doubles& q, MI mask, float* row) const {
        const DF d;
        const auto limited = hn::Min(hn::Max(ToFloats(q), low_), high_);
        const auto seen = hn::IfThenElseZero(hn::RebindMask(d, mask), limited);
        const auto old = hn::LoadU(d, row);
        hn::StoreU(hn::Max(seen, old), d, row);
        return hn::RebindMask(DI(), hn::Gt(seen, old));
    }

  private:
    VF low_, high_;
};

class StepDepthLanes {
  public:
    using Value = std::uint32_t;
    StepDepthLanes(const SetupTriangle& t, const QuantisedDepth& depth)
        : scale_(hn::Set(DD(), depth.scale())),
          offset_(hn::Set(DD(), depth.offset())),
          low_(hn::Set(DI(), static_cast<std::int32_t>(depth.of(t.q_min)))),
          high_(hn::Set(DI(), static_cast<std::int32_t>(depth.of(t.q_max)))) {}
    HWY_INLINE MI Test(const Doubles& q, MI mask, std::uint32_t* row) const {
        const DI d;
        // Steps of q's limits limit steps, and lie within 1 .. 2^24 - 1 themselves.
        const auto most = hn::Set(DD(), 0x1p24);
        const auto steps = Join(d, q, [&](VD part) {
            const auto z = hn::Add(hn::Mul(part, scale_), offset_);
            return hn::DemoteTo(DIPart(), hn::Min(hn::Max(z, hn::Zero(DD())), most));
        });
        const auto limited = hn::Min(hn::Max(steps, low_), high_);
        const auto seen = hn::IfThenElseZero(mask, limited);
        auto* const to = reinterpret_cast<std::int32_t*>(row);  // at most 2^24 - 1
        const auto old = hn::LoadU(d, to);
        hn::StoreU(hn::Max(seen, old), d, to);
        return hn::Gt(seen, old);
    }

  private:
    VD scale_, offset_;
    VI low_, high_;
};
