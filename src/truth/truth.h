#pragma once

#include <cstdint>
#include <vector>

#include "core/image.h"
#include "edge/edge_image.h"
#include "scene/crease.h"
#include "scene/scene.h"
#include "truth/curve.h"
#include "truth/limits.h"
#include "truth/line_class.h"

namespace ink::truth {

/// What the truth depends on besides scene and view.
struct TruthOptions {
    double crease_rad =
        0.6981317007977318;  ///< 40 degrees: faces that bend at least this much crease
    scene::CreaseSource creases = scene::CreaseSource::angle;  ///< which edges of two faces are
    double weld_epsilon = 0;                                   ///< as scene::WeldOptions has it
    int threads = 1;
    bool layers = true;  ///< also layers, `sampled` and `exact_corner`; without, they stay empty
    TruthLimits limits = {};
    TruthProgress progress = {};  ///< may be empty
};

/// What is seen at pixel centres, by one Embree ray each: for attribution, and for the `sampled`
/// row.
struct Layers {
    core::Image<std::uint32_t>
        triangle;                      ///< global triangle index, `kNoTriangle` where there is sky
    core::Image<std::uint32_t> patch;  ///< smooth patch, `kNoTriangle` where there is sky
    core::Image<float> n_dot_v;        ///< |cos| between facet normal and ray; 0 for sky
    core::Image<float> w;              ///< distance along the view direction; infinity for sky
};

/// Counts of one trace, for rows and for the curious.
struct TruthCounts {
    std::size_t triangles = 0;
    std::size_t degenerate = 0;
    std::size_t duplicate = 0;
    std::size_t joined_vertices = 0;  ///< by the weld's epsilon alone
    std::size_t collapsed = 0;        ///< triangles that the weld's epsilon alone made degenerate
    std::size_t defect_edges = 0;     ///< boundaries that no image can show; not scored
    std::size_t candidate_edges = 0;  ///< feature edges inside the frustum
    std::size_t samples = 0;
    std::size_t rays = 0;
    std::size_t merged_px = 0;     ///< truth pixels that thinning the union removed
    std::size_t pairs_tested = 0;  ///< pairs of triangles whose boxes touch
    std::size_t crossings = 0;     ///< segments in which two triangles cross
    std::size_t contacts = 0;      ///< stretches of edges that lie in a triangle of others
    double crowded_share = 0;      ///< share of drawn truth pixels that fell under the ignore map
    double rounding_px = 0;        ///< that coordinates' rounding may move a vertex in the frame by
};

/// The exact outline of a scene from a view.
struct Truth {
    core::Image<std::uint8_t> labels;  ///< LineClass per pixel: thinned, crowded blocks `ignore`
    /// 1 where a pixel of `labels` is an intersection and no line runs through it but intersections
    /// that bend by less than the crease angle (is_below_crease); else 0.
    core::Image<std::uint8_t> below_crease;
    std::vector<Curve> curves;     ///< sub-pixel, every visible line, before any thinning
    edge::EdgeImage sampled;       ///< the exact classes seen through ids at pixel centres
    edge::EdgeImage exact_corner;  ///< the same at pixel corners, in the pixel between four
    Layers layers;
    TruthCounts counts;
    double trace_s = 0;  ///< wall time of the trace (kept when it comes from the cache)
};

/// Traces the truth of the polyhedron as given (construction A of the design, section 5).
///
/// Lines are the scene's contours, boundaries, creases, intersections and seams, classified exactly
/// from the eye; a line point is visible if the open segment from the eye meets no triangle but the
/// line's own faces. Of surfaces at the same depth the lowest face is seen; where an edge lies in
/// faces that are not its own, touching.h has the rule. Same result for every thread count. An
/// empty image or a scene that shows nothing gives labels of zeros. Throws TooLarge where the
/// view would exceed the options' limits.
[[nodiscard]] Truth trace_truth(const scene::Scene& scene,
                                const scene::View& view,
                                const TruthOptions& options);

struct Model;

/// The same from a model (model.h) that serves many views; `trace_s` then leaves the model's own
/// time out. Of the options threads, layers, limits and progress count.
[[nodiscard]] Truth trace_truth(const Model& model,
                                const scene::View& view,
                                const TruthOptions& options);

}  // namespace ink::truth
