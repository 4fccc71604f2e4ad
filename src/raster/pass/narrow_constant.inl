// A number written to some pixels of a plane that is as narrow as its store, per SIMD target:
// included inside HWY_NAMESPACE, after `hn`.

/// The low bits of a number, for planes of T; masks are those of vectors of 32 bits, D.
template <class T, class D>
class NarrowConstant {
  public:
    NarrowConstant() = default;
    HWY_INLINE explicit NarrowConstant(std::uint32_t number)
        : constant_(hn::Set(DT(), static_cast<T>(number))) {}

    /// Writes it where `mask` says so.
    HWY_INLINE void Put(hn::Mask<D> mask, T* to) const {
        const DT d;
        const auto old = hn::LoadU(d, to);
        hn::StoreU(hn::IfThenElse(Narrowed(mask), constant_, old), d, to);
    }

  private:
    using DT = hn::Rebind<T, D>;

    static HWY_INLINE hn::Mask<DT> Narrowed(hn::Mask<D> mask) {
        if constexpr (sizeof(T) == sizeof(hn::TFromD<D>)) {
            return hn::RebindMask(DT(), mask);
        } else {
#if HWY_TARGET <= HWY_AVX3
            // A bit a lane, whatever the lanes.
            return {static_cast<decltype(hn::Mask<DT>::raw)>(mask.raw)};
#else
            const hn::RebindToSigned<DT> ds;  // -1 stays -1
            return hn::MaskFromVec(hn::BitCast(DT(), hn::DemoteTo(ds, hn::VecFromMask(D(), mask))));
#endif
        }
    }

    hn::Vec<DT> constant_;
};
