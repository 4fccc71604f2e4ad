// What a vector of triangles is set up to, per SIMD target: edges, depth and values. Included
// inside HWY_NAMESPACE, after `hn`, the lane types DI (int32), VI, DF (float) and VF,
// lane_edges.inl and lane_planes.inl. Whoever includes it gets the same bits.

/// One corner of a vector of triangles.
struct Corner {
    VI x;  ///< 1/65536 px
    VI y;
    VF q;
    VF value;
    VI x_snapped;  ///< 1/256 px
    VI y_snapped;

    HWY_INLINE void Snap() {
        const auto half = hn::Set(DI(), 1 << (kLaneBits - kSubpixelBits - 1));
        x_snapped = hn::ShiftRight<kLaneBits - kSubpixelBits>(hn::Add(x, half));
        y_snapped = hn::ShiftRight<kLaneBits - kSubpixelBits>(hn::Add(y, half));
    }
};

/// The pixel that a triangle's edges and planes are relative to.
struct Reference {
    VI x;
    VI y;

    HWY_INLINE explicit Reference(const Corner& first)
        : x(hn::ShiftRight<kSubpixelBits>(first.x_snapped)),
          y(hn::ShiftRight<kSubpixelBits>(first.y_snapped)) {}
};

/// Edges as LaneTriangles has them, and where the triangle is thin.
struct EdgeLanes {
    VI at_ref[3];
    VI dx[3];
    VI dy[3];
    hn::Mask<DI> is_thin;
};

HWY_INLINE EdgeLanes MakeEdges(const Corner (&c)[3], const Reference& ref) {
    const DI d;
    const DF df;
    EdgeLanes e;
    const auto zero = hn::Zero(d);
    const auto area = hn::Sub(
        hn::Mul(hn::Sub(c[1].x_snapped, c[0].x_snapped), hn::Sub(c[2].y_snapped, c[0].y_snapped)),
        hn::Mul(hn::Sub(c[2].x_snapped, c[0].x_snapped), hn::Sub(c[1].y_snapped, c[0].y_snapped)));
    // -1 where the corners run the other way: (v ^ -1) - -1 = -v turns the edges.
    const auto turned = hn::VecFromMask(d, hn::Lt(area, zero));
    const auto centre = hn::Set(d, kSubpixels / 2);
    const auto x = hn::Add(hn::ShiftLeft<kSubpixelBits>(ref.x), centre);
    const auto y = hn::Add(hn::ShiftLeft<kSubpixelBits>(ref.y), centre);
    auto longest2 = hn::Zero(df);
    for (int k = 0; k < 3; ++k) {
        const Corner& from = c[k];
        const Corner& to = c[(k + 1) % 3];
        auto dx = hn::Sub(to.x_snapped, from.x_snapped);
        auto dy = hn::Sub(to.y_snapped, from.y_snapped);
        const auto fx = hn::ConvertTo(df, dx);
        const auto fy = hn::ConvertTo(df, dy);
        longest2 = hn::Max(longest2, hn::Add(hn::Mul(fx, fx), hn::Mul(fy, fy)));
        dx = Turn(dx, turned);
        dy = Turn(dy, turned);
        const auto biased = EdgeAt(dx, dy, hn::Sub(x, from.x_snapped), hn::Sub(y, from.y_snapped));
        // Steps are whole multiples of 256, so the low bits never change a sign.
        e.at_ref[k] = hn::ShiftRight<kSubpixelBits>(biased);
        e.dx[k] = hn::Neg(dy);
        e.dy[k] = dx;
    }
    // As is_thin of setup.cpp, in float: a height below 1.25 px.
    constexpr float kLimit = 1.25F * kSubpixels;
    const auto a = hn::ConvertTo(df, area);
    const auto is_thin = hn::Lt(hn::Mul(a, a), hn::Mul(hn::Set(df, kLimit * kLimit), longest2));
    e.is_thin = hn::RebindMask(d, is_thin);
    return e;
}

/// What all planes of the triangles share.
HWY_INLINE PlaneLanes MakePlanes(const Corner (&c)[3], const Reference& ref) {
    PlaneLanes planes = MakePlanes({c[0].x, c[1].x, c[2].x}, {c[0].y, c[1].y, c[2].y});
    const auto half = hn::Set(DI(), 1 << (kLaneBits - 1));
    planes.ref_x = ToPx(hn::Sub(hn::Add(hn::ShiftLeft<kLaneBits>(ref.x), half), c[0].x));
    planes.ref_y = ToPx(hn::Sub(hn::Add(hn::ShiftLeft<kLaneBits>(ref.y), half), c[0].y));
    return planes;
}

/// A float plane and what it is limited to where that is wanted.
struct NumberPlane {
    VF at_ref, dx, dy, low, high;
};

/// A float plane, limited to its corners where `limit` says so.
HWY_INLINE NumberPlane
MakeNumbers(const PlaneLanes& planes, VF v0, VF v1, VF v2, hn::Mask<DF> limit) {
    const DF df;
    const auto p = planes.Through(v0, v1, v2);
    const auto most = hn::Set(df, std::numeric_limits<float>::max());
    return {p.at_ref,
            p.dx,
            p.dy,
            hn::IfThenElse(limit, hn::Min(hn::Min(v0, v1), v2), hn::Neg(most)),
            hn::IfThenElse(limit, hn::Max(hn::Max(v0, v1), v2), most)};
}

/// Depth's plane, limited to its corners, both moved by polygon offset.
HWY_INLINE NumberPlane MakeDepth(const PlaneLanes& planes,
                                 const Corner (&c)[3],
                                 const LaneDepthBias& depth_bias) {
    const DF df;
    auto p = planes.Through(c[0].q, c[1].q, c[2].q);
    auto low = hn::Min(hn::Min(c[0].q, c[1].q), c[2].q);
    auto high = hn::Max(hn::Max(c[0].q, c[1].q), c[2].q);
    if (depth_bias.is_any) {
        const auto moved = DepthBiasOf(depth_bias, p, high);
        const auto within = [&](VF q) {
            const auto first = hn::Set(df, depth_bias.first);
            return hn::Min(hn::Max(hn::Add(q, moved), first), hn::Set(df, depth_bias.last));
        };
        p.at_ref = hn::Add(p.at_ref, moved);
        low = within(low);
        high = within(high);
    }
    return {p.at_ref, p.dx, p.dy, low, high};
}

/// How a code's numbers are made fixed.
struct CodeScale {
    float scale;       ///< 2^fraction bits
    std::int32_t low;  ///< of a code anywhere: the store's range if it saturates
    std::int32_t high;
    bool is_limited;  ///< it saturates

    explicit CodeScale(const PassFormat& format)
        : scale(static_cast<float>(1 << lane_fraction_bits(format.store))),
          low(std::numeric_limits<std::int32_t>::min()),
          high(std::numeric_limits<std::int32_t>::max()),
          is_limited(format.overflow == Overflow::saturate) {
        if (!is_limited) return;
        const std::int64_t codes = format.store == Store::u16 ? 1 << 16 : 1 << 8;
        low = 0;
        high = static_cast<std::int32_t>((codes << lane_fraction_bits(format.store)) - 1);
    }
};

/// An integer plane, and where it may leave the store's range: its corners come within one code of
/// an end, and a centre of the snapped triangle may lie a little outside the true one.
struct CodePlane {
    VI at_ref, dx, dy, low, high;
    hn::Mask<DI> may_leave;
};

HWY_INLINE CodePlane MakeCodes(
    const PlaneLanes& planes, VF v0, VF v1, VF v2, hn::Mask<DI> is_thin, const CodeScale& scale) {
    const DI d;
    const DF df;
    const auto p = planes.Through(v0, v1, v2);
    const auto limit = hn::Set(df, 0x1p30F);
    const auto fixed = [&](VF v) {
        const auto scaled = hn::Mul(v, hn::Set(df, scale.scale));
        return hn::NearestInt(hn::Min(hn::Max(scaled, hn::Neg(limit)), limit));
    };
    const auto low = hn::Set(d, scale.low);
    const auto high = hn::Set(d, scale.high);
    const auto least = fixed(hn::Floor(hn::Min(hn::Min(v0, v1), v2)));
    const auto greatest = fixed(hn::Floor(hn::Max(hn::Max(v0, v1), v2)));
    const auto within = [&](VI v) { return hn::Min(hn::Max(v, low), high); };
    const auto unit = hn::Set(d, static_cast<std::int32_t>(scale.scale));
    const auto span = hn::Add(hn::ShiftRight<6>(hn::Sub(greatest, least)), unit);
    const auto near_low = hn::Lt(hn::Sub(least, span), low);
    const auto near_high = hn::Gt(hn::Add(greatest, hn::Add(span, unit)), high);
    const auto always = hn::VecFromMask(d, hn::Or(near_low, near_high));
    return {fixed(p.at_ref),
            fixed(p.dx),
            fixed(p.dy),
            hn::IfThenElse(is_thin, within(least), low),
            hn::IfThenElse(is_thin, within(greatest), high),
            hn::MaskFromVec(scale.is_limited ? always : hn::Zero(d))};
}
