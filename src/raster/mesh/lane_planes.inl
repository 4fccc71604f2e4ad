// Planes over a vector of triangles per SIMD target, and by how much polygon offset moves them:
// included inside HWY_NAMESPACE, after `hn` and the lane types DI (int32), VI, DF (float) and VF.

/// What all planes of a vector of triangles share: px from corner 0, unsnapped.
struct PlaneLanes {
    VF x1, y1, x2, y2;
    VF ref_x, ref_y;
    VF one_over_area;  ///< 0: no area

    struct Plane {
        VF at_ref, dx, dy;
    };
    /// Without its value at the reference.
    HWY_INLINE Plane Gradient(VF v0, VF v1, VF v2) const {
        const auto d1 = hn::Sub(v1, v0);
        const auto d2 = hn::Sub(v2, v0);
        Plane p;
        p.dx = hn::Mul(hn::Sub(hn::Mul(d1, y2), hn::Mul(d2, y1)), one_over_area);
        p.dy = hn::Mul(hn::Sub(hn::Mul(d2, x1), hn::Mul(d1, x2)), one_over_area);
        return p;
    }
    HWY_INLINE Plane Through(VF v0, VF v1, VF v2) const {
        Plane p = Gradient(v0, v1, v2);
        p.at_ref = hn::Add(hn::Add(v0, hn::Mul(p.dx, ref_x)), hn::Mul(p.dy, ref_y));
        return p;
    }
};

HWY_INLINE VF ToPx(VI fixed) {
    const DF df;
    return hn::Mul(hn::ConvertTo(df, fixed), hn::Set(df, 1.0F / (1 << kLaneBits)));
}

/// Of corners in 1/65536 px; the reference is left to the caller.
HWY_INLINE PlaneLanes MakePlanes(const VI (&x)[3], const VI (&y)[3]) {
    const DF df;
    PlaneLanes p;
    p.x1 = ToPx(hn::Sub(x[1], x[0]));
    p.y1 = ToPx(hn::Sub(y[1], y[0]));
    p.x2 = ToPx(hn::Sub(x[2], x[0]));
    p.y2 = ToPx(hn::Sub(y[2], y[0]));
    const auto area = hn::Sub(hn::Mul(p.x1, p.y2), hn::Mul(p.x2, p.y1));
    const auto zero = hn::Zero(df);
    const auto has_none = hn::Eq(area, zero);
    const auto one = hn::Set(df, 1);
    p.one_over_area =
        hn::IfThenElse(has_none, zero, hn::Div(one, hn::IfThenElse(has_none, one, area)));
    return p;
}

/// What is added to depths that run as `plane` does and are `q_most` at the nearest corner:
/// OffsetRule::depth_bias in floats.
HWY_INLINE VF DepthBiasOf(const LaneDepthBias& depth_bias,
                          const PlaneLanes::Plane& plane,
                          VF q_most) {
    const DI d;
    const DF df;
    const auto slope = hn::Max(hn::Abs(plane.dx), hn::Abs(plane.dy));
    auto step = hn::Set(df, 1);
    if (depth_bias.is_in_floats) {
        const auto exponent = hn::And(hn::BitCast(d, q_most), hn::Set(d, 0x7f800000));
        step = hn::Mul(hn::BitCast(df, exponent), hn::Set(df, 0x1p-23F));
    }
    return hn::Neg(hn::Add(hn::Mul(hn::Set(df, depth_bias.factor), slope),
                           hn::Mul(hn::Set(df, depth_bias.units), step)));
}
