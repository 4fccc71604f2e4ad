#pragma once

#include <array>

#include "core/param.h"
#include "methods/mesh_lookup/lookup_mesh.h"
#include "raster/depth/depth.h"

namespace ink::methods {

/// How wide lines are: the widest, and shares of that by class and by distance.
struct WidthParams {
    double width_px = 1;
    double contours = 1;
    double creases = 1;
    double intersections = 1;
    double seams = 1;
    double far_width = 1;
    double near_at = 0;
    double far_at = 1;
};

inline constexpr double kMostWidth_px = 4;

/// Appends the rows of WidthParams to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_width_params(core::ParamTable<P>& table) {
    return table
        .number(&P::width_px, "width_px", {1, kMostWidth_px}, "px", "Width of the widest lines.")
        .number(&P::contours,
                "contours",
                {0, 1},
                "",
                "Width of contours and boundaries, as a share of width_px; 0: none.")
        .number(&P::creases, "creases", {0, 1}, "", "The same of creases.")
        .number(&P::intersections, "intersections", {0, 1}, "", "The same of intersections.")
        .number(&P::seams, "seams", {0, 1}, "", "The same of seams.")
        .number(&P::far_width,
                "far_width",
                {0, 1},
                "",
                "Width at far_at and beyond, as a share of that at near_at and before.")
        .number(&P::near_at,
                "near_at",
                {0, 1},
                "",
                "A distance: 0 the near end of the ball round the scene, 1 its far end.")
        .number(&P::far_at, "far_at", {0, 1}, "", "The same, beyond near_at.");
}

/// WidthParams as one view sees them, `range` being how far its scene reaches.
class LineWidths {
  public:
    LineWidths() = default;
    LineWidths(const WidthParams& params, const raster::DepthRange& range);

    /// Half the width of a line of a kind, where it is as far as 1/w says; 0 is not known, and
    /// near.
    [[nodiscard]] float half_px(LineKind kind, double q) const {
        const float half = half_px_[static_cast<std::size_t>(kind)];
        return far_width_ == 1 || !(q > 0) ? half : half * share_at(q);
    }

  private:
    [[nodiscard]] float share_at(double q) const;

    std::array<float, 6> half_px_{};  ///< by kind
    double far_width_ = 1, near_at_ = 0, far_at_ = 1;
    raster::DepthRange range_;
};

}  // namespace ink::methods
