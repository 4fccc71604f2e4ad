#pragma once

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <variant>
#include <vector>

#include "core/image.h"
#include "core/param.h"
#include "scene/scene.h"
#include "scene/surface.h"
#include "shade/compose.h"
#include "shade/tones.h"

/// The shadings, each as the struct of its parameters and the function from a tone to a colour. No
/// libm but square roots: the last bit of others differs between machines.

namespace ink::shade {

/// What lies in the picture, as brightness 0 .. 1 per channel.
struct Colors {
    glm::vec3 surface{0.9F, 0.88F, 0.85F};  ///< the part of the light that every surface sends back
    glm::vec3 paper{1};                     ///< where there is no surface
    glm::vec3 ink{0};                       ///< of strokes
};

/// The parameters of every shading.
struct ToneParams {
    ShadeBy by = ShadeBy::vertex;
    scene::NormalSource normals = scene::NormalSource::patch;
    double crease_deg = 40;
    double ambient = 0.22;
    double splash_alpha = 0;
    int splash_power = 1;
};

/// Lambert's law under several lamps: surface times light (Gouraud 1971, "Continuous shading of
/// curved surfaces"; the lamps of MOTE).
struct GouraudParams : ToneParams {};

/// A table of grey by brightness instead (CoRgi). What levels it holds is our choice.
struct ToonParams : ToneParams {
    int steps = 3;
    double dark = 0.45;
};

/// Whose colour the lit side has.
enum class LitSide {
    cool,  ///< as the source prints the formula
    warm,  ///< as the paper's pictures have it
};

/// Cool to warm by the cosine, so that nothing is as dark as ink (Gooch, Gooch, Shirley and Cohen,
/// "A non-photorealistic lighting model for automatic technical illustration", SIGGRAPH 1998).
struct GoochParams : ToneParams {
    LitSide lit = LitSide::cool;
    double blue = 0.55;  // these four leave the coolest colour lighter than ink
    double yellow = 0.3;
    double cool_share = 0.25;
    double warm_share = 0.5;
};

/// Pen strokes where it is dark, crossed where it is darker (CoRgi). The thresholds, and that
/// strokes widen in between, are our choice.
struct StrokeParams : ToneParams {
    double single_from = 0.35;
    double crossed_from = 0.65;
    double spacing_px = 6;
};

inline constexpr std::size_t kToonEntries = 32;
using ToonTable = std::array<float, kToonEntries>;

/// 32 entries in `steps` (1..32) levels of nearly equal length, from `dark` up to 1; all 1 for one
/// step.
[[nodiscard]] ToonTable make_toon_table(int steps, double dark);

/// The entry for a brightness 0 .. 1: floor(32 b), the last one for 1.
[[nodiscard]] float look_up(const ToonTable& table, float brightness);

/// I = ((1 + l.n)/2) k_cool + (1 - (1 + l.n)/2) k_warm, or the two exchanged for LitSide::warm.
/// k_cool = (0, 0, blue) + cool_share * surface; k_warm = (yellow, yellow, 0) + warm_share *
/// surface.
[[nodiscard]] glm::vec3 gooch(float cosine, const GoochParams& params, const glm::vec3& surface);

/// (alpha |cosine| + (1 - alpha))^power: darkens what neither faces the light nor turns its back to
/// it. 1 for alpha 0. (TechnicalQuake, "splashback".) Differs: `power` is whole, >= 0, so that no
/// libm decides a pixel.
[[nodiscard]] float splashback(float cosine, double alpha, int power);

/// How much of its spacing a stroke is wide, 0 for none.
struct StrokeShares {
    float single = 0;
    float crossed = 0;  ///< of strokes across the single ones; 0 unless those are at their widest
};

/// Strokes start thin at their threshold and widen to half their spacing: the single ones until the
/// crossed ones start, these until darkness 1. `darkness` is 1 - brightness.
[[nodiscard]] StrokeShares stroke_shares(float darkness, const StrokeParams& params);

/// Whether a point of the picture (px, as the user sees pixels) lies on a stroke.
[[nodiscard]] bool is_on_stroke(double x_px,
                                double y_px,
                                const StrokeShares& shares,
                                double spacing_px);

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
