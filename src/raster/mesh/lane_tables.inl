// Lookup of a cluster's vertices by lanes, per SIMD target: included inside HWY_NAMESPACE, after
// `hn` and the lane types DI (int32) and VI.

#if HWY_TARGET <= HWY_AVX3
/// Numbers of a cluster's vertices in four registers; 64 are read, however few there are. A gather
/// takes three times as long. (Highway 1.0.3 has no lookup in two registers.)
class VertexTable {
  public:
    HWY_INLINE explicit VertexTable(const std::int32_t* from) {
        static_assert(scene::kMaxClusterVertices <= 64);
        const DI d;
        for (int i = 0; i < 4; ++i)
            part_[i] = hn::Load(d, from + 16 * i);
    }
    /// Only the low six bits of the index count.
    HWY_INLINE VI At(VI index) const {
        const DI d;
        const VI low{_mm512_permutex2var_epi32(part_[0].raw, index.raw, part_[1].raw)};
        const VI high{_mm512_permutex2var_epi32(part_[2].raw, index.raw, part_[3].raw)};
        return hn::IfThenElse(hn::TestBit(index, hn::Set(d, 32)), high, low);
    }

  private:
    VI part_[4];
};
#else
/// Numbers of a cluster's vertices.
class VertexTable {
  public:
    HWY_INLINE explicit VertexTable(const std::int32_t* from) : from_(from) {}
    /// Only the low six bits of the index count.
    HWY_INLINE VI At(VI index) const {
        const DI d;
        return hn::GatherIndex(d, from_, hn::And(index, hn::Set(d, 63)));
    }

  private:
    const std::int32_t* from_;
};
#endif

/// Corner k of triangles as LaneMesh::corners has them; above its six bits stands something else.
HWY_INLINE VI CornerOf(VI corners, int k) {
    return k == 0 ? corners : k == 1 ? hn::ShiftRight<8>(corners) : hn::ShiftRight<16>(corners);
}
