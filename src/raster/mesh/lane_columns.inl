// Columns of vectors that fill_lanes draws, per SIMD target: included inside HWY_NAMESPACE, after
// `hn`.

/// Pixels of a row that are drawn at once.
constexpr int kColumn_px = static_cast<int>(hn::MaxLanes(hn::CappedTag<std::int32_t, 8>()));

/// Whether columns come with the rows to draw. One pixel wide, there would be too many: the scalar
/// target draws all rows, and is what the others are compared with.
constexpr bool kKnowsRows = kColumn_px == LaneTriangles::kColumn_px;
