// What one triangle leaves in a tile besides depth: included by triangle_fill.cpp inside its
// HWY_NAMESPACE, after pixel_lanes.inl.
//
// A store of values is told each column of vectors and the row where a run of rows starts, then
// asked to write row after row. `at` is the pixel's place in a plane.

/// For those that need none.
struct NoTables {};

struct NoValues {
    using Tables = NoTables;
    NoValues(const OneTriangle&, Tables&, TileBuffer&) {}
    HWY_INLINE void StartColumn(VI, const Doubles&) {}
    HWY_INLINE void StartRows(int) {}
    HWY_INLINE void Write(std::ptrdiff_t, int, const Doubles&, MI) {}
};

template <class T>
class ConstantValues {
  public:
    using Tables = NoTables;
    ConstantValues(const OneTriangle& t, Tables&, TileBuffer& to)
        : plane_(to.plane_row<T>(0, 0)), constant_(t.constant) {}
    HWY_INLINE void StartColumn(VI, const Doubles&) {}
    HWY_INLINE void StartRows(int) {}
    HWY_INLINE void Write(std::ptrdiff_t at, int, const Doubles&, MI mask) {
        constant_.Put(mask, plane_ + at);
    }

  private:
    T* plane_;
    NarrowConstant<T, DI> constant_;
};

/// Codes whose planes' low 32 bits say all: those that wrap, and those that stay within their store
/// all over the triangle.
template <int kCount>
class CodeValues {
  public:
    using Tables = NoTables;
    CodeValues(const OneTriangle& t, Tables&, TileBuffer& to)
        : first_row_(t.first_row()),
          most_(hn::Set(DI(), t.format.store == Store::u8 ? 0xff : 0xffff)),
          planes_(t.planes(t.batch.code_planes)) {
        for (int k = 0; k < kCount; ++k) {
            to_[k] = reinterpret_cast<std::int32_t*>(to.code_row(k, 0));
            step_[k] = hn::Set(DI(), static_cast<std::int32_t>(planes_[k].dy));
        }
    }
    HWY_INLINE void StartColumn(VI from_ref, const Doubles&) {
        for (int k = 0; k < kCount; ++k)
            ramp_[k] = hn::Mul(hn::Set(DI(), static_cast<std::int32_t>(planes_[k].dx)), from_ref);
    }
    HWY_INLINE void StartRows(int row) {
        for (int k = 0; k < kCount; ++k) {
            const std::int64_t at_row = planes_[k].at_ref + planes_[k].dy * (first_row_ + row);
            at_[k] = hn::Add(hn::Set(DI(), static_cast<std::int32_t>(at_row)), ramp_[k]);
        }
    }
    HWY_INLINE void Write(std::ptrdiff_t at, int, const Doubles&, MI mask) {
        for (int k = 0; k < kCount; ++k) {
            const auto code = hn::ShiftRight<kCodeFractionBits>(hn::BitCast(DU(), at_[k]));
            Put(hn::And(hn::BitCast(DI(), code), most_), mask, to_[k] + at);
            at_[k] = hn::Add(at_[k], step_[k]);
        }
    }

  private:
    int first_row_;
    VI most_;
    const CodePlane* planes_;
    std::int32_t* to_[kCount];
    VI ramp_[kCount], at_[kCount], step_[kCount];
};

/// Codes that may leave a store that saturates, or belong to a thin triangle.
template <int kCount>
class LimitedCodeValues {
  public:
    using Tables = NoTables;
    LimitedCodeValues(const OneTriangle& t, Tables&, TileBuffer& to)
        : first_row_(t.first_row()), planes_(t.planes(t.batch.code_planes)) {
        const std::int64_t most = t.format.store == Store::u8 ? 0xff : 0xffff;
        const bool saturates = t.format.overflow == Overflow::saturate;
        low_ = saturates ? 0 : std::numeric_limits<std::int64_t>::min();
        high_ = saturates ? most : std::numeric_limits<std::int64_t>::max();
        most_ = most;
        for (int k = 0; k < kCount; ++k) {
            to_[k] = reinterpret_cast<std::int32_t*>(to.code_row(k, 0));
            const bool is_thin = t.setup().is_thin;
            lowest_[k] = is_thin ? planes_[k].lowest : std::numeric_limits<std::int64_t>::min();
            highest_[k] = is_thin ? planes_[k].highest : std::numeric_limits<std::int64_t>::max();
        }
    }
    HWY_INLINE void StartColumn(VI from_ref, const Doubles&) {
        const DL d;
        for (int k = 0; k < kCount; ++k) {
            ramp_[k] = Widen(d, from_ref).map([&](VL part) {
                return hn::Mul(hn::Set(d, planes_[k].dx), part);
            });
        }
    }
    HWY_INLINE void StartRows(int) {}
    HWY_INLINE void Write(std::ptrdiff_t at, int row, const Doubles&, MI mask) {
        const DL d;
        for (int k = 0; k < kCount; ++k) {
            const std::int64_t at_row = planes_[k].at_ref + planes_[k].dy * (first_row_ + row);
            const auto codes = Join(DU(), ramp_[k], [&](VL part) {
                const auto v = hn::Add(hn::Set(d, at_row), part);
                const auto limited =
                    hn::Min(hn::Max(v, hn::Set(d, lowest_[k])), hn::Set(d, highest_[k]));
                const auto code = hn::ShiftRight<kCodeFractionBits>(limited);
                const auto kept = hn::And(
                    hn::Min(hn::Max(code, hn::Set(d, low_)), hn::Set(d, high_)), hn::Set(d, most_));
                return hn::TruncateTo(DUPart(), hn::BitCast(hn::RebindToUnsigned<DL>(), kept));
            });
            Put(hn::BitCast(DI(), codes), mask, to_[k] + at);
        }
    }

  private:
    int first_row_;
    const CodePlane* planes_;
    std::int64_t low_, high_, most_;
    std::int64_t lowest_[kCount], highest_[kCount];
    std::int32_t* to_[kCount];
    Longs ramp_[kCount];
};

/// kCount planes of doubles, followed row by row.
template <int kCount, bool kPerspective>
class DoublePlanes {
  public:
    struct Tables {
        RowStarts starts[kCount];
    };
    DoublePlanes(const OneTriangle& t, Tables& tables)
        : planes_(t.planes(t.batch.float_planes)), starts_(tables.starts) {
        for (int k = 0; k < kCount; ++k)
            tables.starts[k].fill(planes_[k].plane, t.first_row(), t.rows);
    }
    HWY_INLINE void StartColumn(const Doubles& from_ref) {
        for (int k = 0; k < kCount; ++k)
            ramp_[k] = Ramp(planes_[k].plane, from_ref);
    }
    HWY_INLINE VF At(int k, int row, const Doubles& q) const {
        const auto start = starts_[k].at(row);
        Doubles v;
        for (int i = 0; i < kParts; ++i) {
            v.part[i] = hn::Add(start, ramp_[k].part[i]);
            if (kPerspective) v.part[i] = hn::Div(v.part[i], q.part[i]);
        }
        return ToFloats(v);
    }
    HWY_INLINE VF Limited(int k, VF v) const {
        const DF d;
        return hn::Min(hn::Max(v, hn::Set(d, planes_[k].lowest)), hn::Set(d, planes_[k].highest));
    }

  private:
    const FloatPlane* planes_;
    const RowStarts* starts_;
    Doubles ramp_[kCount];
};

/// Four floats.
template <bool kPerspective>
class NumberValues {
    using Planes = DoublePlanes<kMaxPlanes, kPerspective>;

  public:
    using Tables = typename Planes::Tables;
    NumberValues(const OneTriangle& t, Tables& tables, TileBuffer& to)
        : is_limited_(kPerspective || t.setup().is_thin), planes_(t, tables) {
        for (int k = 0; k < kMaxPlanes; ++k)
            to_[k] = to.plane_row<float>(k, 0);
    }
    HWY_INLINE void StartColumn(VI, const Doubles& from_ref) { planes_.StartColumn(from_ref); }
    HWY_INLINE void StartRows(int) {}
    HWY_INLINE void Write(std::ptrdiff_t at, int row, const Doubles& q, MI mask) {
        const DF d;
        const auto kept = hn::RebindMask(d, mask);
        for (int k = 0; k < kMaxPlanes; ++k) {
            auto v = planes_.At(k, row, q);
            if (is_limited_) v = planes_.Limited(k, v);
            hn::StoreU(hn::IfThenElse(kept, v, hn::LoadU(d, to_[k] + at)), d, to_[k] + at);
        }
    }

  private:
    bool is_limited_;
    Planes planes_;
    float* to_[kMaxPlanes];
};

/// Codes that run linearly on the surface.
template <int kCount>
class PerspectiveCodeValues {
    using Planes = DoublePlanes<kCount, true>;

  public:
    using Tables = typename Planes::Tables;
    PerspectiveCodeValues(const OneTriangle& t, Tables& tables, TileBuffer& to)
        : wraps_(t.format.overflow == Overflow::wrap),
          most_(t.format.store == Store::u8 ? 0xff : 0xffff),
          planes_(t, tables) {
        for (int k = 0; k < kCount; ++k)
            to_[k] = reinterpret_cast<std::int32_t*>(to.code_row(k, 0));
    }
    HWY_INLINE void StartColumn(VI, const Doubles& from_ref) { planes_.StartColumn(from_ref); }
    HWY_INLINE void StartRows(int) {}
    HWY_INLINE void Write(std::ptrdiff_t at, int row, const Doubles& q, MI mask) {
        for (int k = 0; k < kCount; ++k)
            Put(Code(hn::Floor(planes_.Limited(k, planes_.At(k, row, q)))), mask, to_[k] + at);
    }

  private:
    /// Every step is exact, however large the whole number.
    HWY_INLINE VI Code(VF whole) const {
        const DF d;
        const auto most = hn::Set(d, static_cast<float>(most_));
        if (!wraps_) return hn::ConvertTo(DI(), hn::Min(hn::Max(whole, hn::Zero(d)), most));
        const auto size = hn::Set(d, 0x1p16F);
        const auto farthest = hn::Set(d, 0x1p44F);  // as the plain loop's 48.16 ends
        const auto v = hn::Min(hn::Max(whole, hn::Neg(farthest)), farthest);
        const auto turns = hn::Floor(hn::Mul(v, hn::Set(d, 0x1p-16F)));
        const auto left = hn::ConvertTo(DI(), hn::Sub(v, hn::Mul(turns, size)));
        return hn::And(left, hn::Set(DI(), most_));
    }

    bool wraps_;
    std::int32_t most_;
    Planes planes_;
    std::int32_t* to_[kCount];
};
