#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/image.h"
#include "edge/edge_image.h"
#include "scene/scene.h"
#include "truth/limits.h"
#include "truth/line_class.h"

namespace ink::truth {

/// What the truth depends on besides scene and view.
struct TruthOptions {
    double crease_rad =
        0.6981317007977318;       ///< 40 degrees: faces that bend at least this much crease
    bool material_seams = false;  ///< a seam also where only the material differs
    double weld_epsilon = 0;      ///< as scene::WeldOptions has it
    int threads = 1;
    bool layers = true;  ///< also layers and `sampled`; without, both stay empty
    TruthLimits limits = {};
    TruthProgress progress = {};  ///< may be empty
};

/// A point of a visible line: where it is on the picture and how far away.
struct CurvePoint {
    double x_px = 0;
    double y_px = 0;
    double w = 0;  ///< distance along the gaze, world units
};

/// What lies behind a contour.
enum class ContourKind : std::uint8_t { none, sky, other_object, self };

inline constexpr std::uint32_t kNoEdge = 0xffffffffU;
inline constexpr std::uint32_t kNoTriangle = 0xffffffffU;

/// A visible piece of one line, clipped to the picture: of a mesh edge, or of an intersection.
///
/// What is said of its faces and its surroundings holds at the middle of the piece.
struct Curve {
    LineClass line_class = LineClass::none;
    ContourKind kind = ContourKind::none;  ///< contours only
    std::int8_t empty_side =
        0;  ///< contours and boundaries: the side without a face of the line's,
            ///< going from begin to end on the picture: 1 right, -1 left; else 0
    std::uint32_t edge = kNoEdge;       ///< into the scene's Topology; kNoEdge for an intersection
    std::uint32_t face0 = kNoTriangle;  ///< a face on the line, into Topology::faces: the seen one
                                        ///< of contour and boundary, else the left one
    std::uint32_t face1 = kNoTriangle;  ///< the other (of a contour hidden, or in the line of
                                        ///< sight); kNoTriangle for a boundary
    float bend_rad = 0;  ///< how far the two seen faces deviate from flat (dihedral); 0 for one
    float gap = 0;  ///< from the line to what lies behind it, along the gaze, world units; infinity
                    ///< before the sky, 0 for lines that have both sides
    float view_angle_rad = 0;  ///< between the line of sight and the normal of that seen face which
                               ///< is nearest edge-on: 0 seen from the front .. pi/2 edge-on
    CurvePoint begin;
    CurvePoint end;
};

/// Between which neighbouring pixel centres the visible lines run: the second, thinning-free
/// product.
///
/// `right.at(x, y)` is the LineClass (the lowest number of several, 0 for none) of the curves that
/// cross the open segment from the centre of (x, y) to that of (x + 1, y), `below` the same to
/// (x, y + 1). The last column of `right` and the last row of `below` are 0.
struct Cracks {
    core::Image<std::uint8_t> right;
    core::Image<std::uint8_t> below;
};

/// What is seen at pixel centres, by one Embree ray each: for attribution, and for the `sampled`
/// row.
struct Layers {
    core::Image<std::uint32_t>
        triangle;                      ///< global triangle index, `kNoTriangle` where there is sky
    core::Image<std::uint32_t> patch;  ///< smooth patch, `kNoTriangle` where there is sky
    core::Image<float> n_dot_v;        ///< |cos| between facet normal and ray; 0 for sky
    core::Image<float> w;              ///< distance along the gaze; infinity for sky
};

/// Counts of one trace, for rows and for the curious.
struct TruthCounts {
    std::size_t triangles = 0;
    std::size_t degenerate = 0;
    std::size_t duplicate = 0;
    std::size_t joined_vertices = 0;  ///< by the weld's epsilon alone
    std::size_t collapsed = 0;        ///< triangles that the weld's epsilon alone made degenerate
    std::size_t defect_edges = 0;     ///< boundaries that no picture can show; not scored
    std::size_t candidate_edges = 0;  ///< feature edges inside the frustum
    std::size_t samples = 0;
    std::size_t rays = 0;
    std::size_t merged_px = 0;     ///< truth pixels that thinning the union removed
    std::size_t pairs_tested = 0;  ///< pairs of triangles whose boxes touch
    std::size_t crossings = 0;     ///< segments in which two triangles cross
    std::size_t contacts = 0;      ///< stretches of edges that lie in a triangle of others
    std::size_t too_many_crossings =
        0;  ///< 1: more pairs or segments than the budget (crossings.h); the truth has none
    double crowded_share = 0;  ///< share of drawn truth pixels that fell under the ignore map
};

/// The exact outline of a scene from a view.
struct Truth {
    core::Image<std::uint8_t> labels;  ///< LineClass per pixel: thinned, crowded blocks `ignore`
    std::vector<Curve> curves;         ///< sub-pixel, every visible line, before any thinning
    edge::EdgeImage sampled;           ///< the exact classes seen through ids at pixel centres
    Layers layers;
    TruthCounts counts;
    double trace_s = 0;  ///< wall time of the trace (kept when it comes from the cache)
};

/// Traces the truth of the polyhedron as given (construction A of the design, section 5).
///
/// Lines are the scene's contours, boundaries, creases, intersections and seams, classified exactly
/// from the eye; a line point is visible if the open segment from the eye meets no triangle but the
/// line's own faces. Same result for every thread count. An empty picture or a scene that shows
/// nothing gives labels of zeros. Throws TooLarge where the view would exceed the options' limits.
[[nodiscard]] Truth trace_truth(const scene::Scene& scene,
                                const scene::View& view,
                                const TruthOptions& options);

struct Model;

/// How one view of a model is traced; nothing here changes a result, but limits may refuse one.
struct TruthTrace {
    int threads = 1;
    bool layers = true;  ///< also layers and `sampled`; without, both stay empty
    TruthLimits limits = {};
    TruthProgress progress = {};  ///< may be empty
};

/// The same from a model (model.h) that serves many views; `trace_s` then leaves the model's own
/// time out.
[[nodiscard]] Truth trace_truth(const Model& model,
                                const scene::View& view,
                                const TruthTrace& trace);

}  // namespace ink::truth
