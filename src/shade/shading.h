#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "core/image.h"
#include "core/param.h"
#include "scene/scene.h"
#include "scene/surface.h"
#include "shade/compose.h"
#include "shade/styles.h"

namespace ink::shade {

/// A shading with its parameters.
using Style = std::variant<GouraudParams, ToonParams, GoochParams, StrokeParams>;

/// A row of the list of shadings.
struct ShadingInfo {
    std::string name;
    std::string source;   ///< who described it
    std::string summary;  ///< one line for `inkbench list`
    std::vector<core::Param> params;
    /// The style with these settings, the rest at their defaults. Throws core::Error, where = name.
    std::function<Style(const core::ParamValues&)> make;
};

/// All shadings in a fixed order; names are unique.
[[nodiscard]] const std::vector<ShadingInfo>& shadings();

/// The shading called `name`. Throws core::Error (where = "--shading") that lists the known ones,
/// "none" among them, if there is no such one.
[[nodiscard]] const ShadingInfo& find_shading(const std::string& name);

/// How a picture is drawn.
struct ShadeFrame {
    scene::View view;
    Colors colors;
    int samples_per_px = 1;  ///< pixels of `view` along a side of a pixel that the user sees
    int threads = 1;         ///< the picture does not depend on it
};

/// Draws scenes in one style.
class Shader {
  public:
    explicit Shader(const Style& style) : style_(style) {}

    /// Once per topology, and whenever something moved: normals and flat patches. The scene is not
    /// kept.
    void prepare(const scene::Scene& scene);

    /// The prepared scene under its own lamps, or under `studio_lamps` if it has none. No shadows.
    ///
    /// A triangle seen from its back is lit from its back. Brightness is cut off at 1. A scene
    /// without triangles is paper; an empty picture stays empty.
    [[nodiscard]] core::Image<Rgb> draw(const ShadeFrame& frame) const;

  private:
    Style style_;
    scene::Surface surface_;
    UniformSpots spots_;
    scene::Sphere bounds_;
    std::vector<scene::OmniLight> lamps_;
};

}  // namespace ink::shade
