#pragma once

#include "shade/shading.h"

/// Styles made ready for pixels: the types that the loop over pixels is compiled with. Each gives
/// the colour of a tone at a point of the view, in its pixels.
namespace ink::shade {

/// Surface times light.
class GouraudPaint {
  public:
    GouraudPaint(const GouraudParams&, const ShadeFrame& frame) : surface_(frame.colors.surface) {}
    [[nodiscard]] glm::vec3 color(const Tone& tone, double, double) const {
        return surface_ * tone.light;
    }

  private:
    glm::vec3 surface_;
};

/// Surface times an entry of the table.
class ToonPaint {
  public:
    ToonPaint(const ToonParams& params, const ShadeFrame& frame)
        : surface_(frame.colors.surface), table_(make_toon_table(params.steps, params.dark)) {}
    [[nodiscard]] glm::vec3 color(const Tone& tone, double, double) const {
        return surface_ * look_up(table_, brightness(tone.light));
    }

  private:
    glm::vec3 surface_;
    ToonTable table_;
};

/// Cool to warm.
class GoochPaint {
  public:
    GoochPaint(const GoochParams& params, const ShadeFrame& frame)
        : params_(params), surface_(frame.colors.surface) {}
    [[nodiscard]] glm::vec3 color(const Tone& tone, double, double) const {
        return gooch(tone.cosine, params_, surface_);
    }

  private:
    GoochParams params_;
    glm::vec3 surface_;
};

/// Ink on strokes, surface between them.
class StrokePaint {
  public:
    StrokePaint(const StrokeParams& params, const ShadeFrame& frame)
        : params_(params), colors_(frame.colors), px_(1.0 / frame.samples_per_px) {}
    [[nodiscard]] glm::vec3 color(const Tone& tone, double x, double y) const {
        const StrokeShares shares = stroke_shares(1 - brightness(tone.light), params_);
        const bool is_ink = is_on_stroke(x * px_, y * px_, shares, params_.spacing_px);
        return is_ink ? colors_.ink : colors_.surface;
    }

  private:
    StrokeParams params_;
    Colors colors_;
    double px_;
};

[[nodiscard]] inline GouraudPaint paint_of(const GouraudParams& params, const ShadeFrame& frame) {
    return {params, frame};
}
[[nodiscard]] inline ToonPaint paint_of(const ToonParams& params, const ShadeFrame& frame) {
    return {params, frame};
}
[[nodiscard]] inline GoochPaint paint_of(const GoochParams& params, const ShadeFrame& frame) {
    return {params, frame};
}
[[nodiscard]] inline StrokePaint paint_of(const StrokeParams& params, const ShadeFrame& frame) {
    return {params, frame};
}

}  // namespace ink::shade
