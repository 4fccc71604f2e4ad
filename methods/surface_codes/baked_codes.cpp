#include "methods/surface_codes/baked_codes.h"

#include <algorithm>

#include "methods/surface_codes/code_method.h"
#include "methods/surface_codes/code_repair.h"
#include "scene/animation.h"

namespace ink::methods {
namespace {

// Found on characters and bent tubes, in views and moments that are none of these:
// experiments/notes/repair.md.
constexpr int kMoments = 8;  ///< of a motion: its end, and seven before it
constexpr int kViewsAtRest = 32;
constexpr int kMostViews = 96;   ///< of a pose in motion, of a quarter of the pixels
constexpr int kLeastViews = 24;  ///< the same where poses are many
constexpr int kAllViews = 9 * kMostViews;
constexpr int kRepairMoves = 16000;

}  // namespace

std::vector<std::uint32_t> baked_codes(const scene::PreparedScene& scene,
                                       BakedMethod method,
                                       double crease_deg) {
    const SurfaceCodeParams params{{.crease_deg = crease_deg}};
    const CodeSetup setup = method == BakedMethod::surface8 ? surface_setup(params) : label_setup();
    SurfaceCodes codes(code_options(params, setup));
    codes.prepare(scene);
    return codes.object_codes(scene, object_length_px(setup));
}

std::vector<std::uint32_t> repaired_codes(const scene::PreparedScene& scene,
                                          double crease_deg,
                                          std::span<const scene::Scene> motions) {
    const SurfaceCodeParams params{{.crease_deg = crease_deg}};
    return repaired_codes(scene, params, surface_setup(params), motions);
}

std::vector<std::uint32_t> repaired_codes(const scene::PreparedScene& scene,
                                          const CodeParams& params,
                                          const CodeSetup& setup,
                                          std::span<const scene::Scene> motions) {
    SurfaceCodes codes(code_options(params, setup));
    codes.prepare(scene);
    RandomViews views{.poses = 1 + kMoments * motions.size(), .views = kViewsAtRest};
    if (!motions.empty()) {
        views.views =
            std::clamp(kAllViews / static_cast<int>(views.poses), kLeastViews, kMostViews);
        views.width_px /= 2, views.height_px /= 2;
    }
    const auto each_pose = [&](const auto& visit) {
        visit(scene);
        for (const scene::Scene& motion : motions)
            for (int i = 0; i < kMoments; ++i) {
                scene::Scene posed = motion;
                const double share = std::min((i + 0.5) / (kMoments - 1), 1.0);
                scene::pose_scene(posed, share * posed.animation->duration_s);
                visit(posed);
            }
    };
    const auto heights = codes.heights(codes.object_lengths(object_length_px(setup)));
    const SeenSquares squares = seen_squares(codes, params.crease_deg, views, each_pose);
    return codes.codes_of(
        repaired_heights(codes.mesh(), codes.range(), squares, heights, kRepairMoves));
}

std::shared_ptr<const SmoothMesh> baked_mesh(const scene::PreparedScene& scene, double crease_deg) {
    return make_smooth_mesh(scene, code_options({.crease_deg = crease_deg}, {}).patches);
}

}  // namespace ink::methods
