// What culling and binning and setup share per SIMD target: included by each inside its own
// HWY_NAMESPACE, after `hn` and the lane types DI (int32) and VI.

/// The edge (dx, dy) of a vector of triangles at a centre `x`, `y` from its first corner: negative
/// outside, by the top-left rule of EdgeFunction. Corners run clockwise as seen.
HWY_INLINE VI EdgeAt(VI dx, VI dy, VI x, VI y) {
    const DI d;
    const auto zero = hn::Zero(d);
    const auto is_top_left = hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Gt(dx, zero)));
    const auto value = hn::Sub(hn::Mul(dx, y), hn::Mul(dy, x));
    return hn::Sub(value, hn::IfThenElseZero(hn::Not(is_top_left), hn::Set(d, 1)));
}

/// -v where `turned` is -1, v where it is 0.
HWY_INLINE VI Turn(VI v, VI turned) {
    return hn::Sub(hn::Xor(v, turned), turned);
}
