#pragma once

#include <cstddef>
#include <vector>

#include "scene/camera.h"
#include "scene/crease.h"
#include "scene/topology.h"
#include "truth/line_class.h"

namespace ink::crosscheck {

/// How the cross-check looks.
struct SamplingOptions {
    double crease_rad = 0.6981317007977318;  ///< 40 degrees
    scene::CreaseSource creases = scene::CreaseSource::angle;
    bool everywhere = false;  ///< refine every pixel: slow, for measuring what adapting leaves out
    int threads = 1;
};

/// Where a line crosses the way between two neighbouring samples, to 1/512 px.
struct SampledPoint {
    double x_px = 0;
    double y_px = 0;
    truth::LineClass line_class = truth::LineClass::none;
    double length_px = 0;  ///< of the line that this crossing stands for
};

/// What looking cost, and what it could not explain.
struct SamplingCounts {
    std::size_t rays = 0;
    std::size_t refined_px = 0;   ///< pixels looked at K x K times
    std::size_t probes = 0;       ///< places across feature edges that were looked at
    std::size_t defects = 0;      ///< crossings of an end across which the surface goes on
    std::size_t near_cuts = 0;    ///< crossings of the near plane's cut: no line
    std::size_t unexplained = 0;  ///< two samples differ and nothing between them says why

    SamplingCounts& operator+=(const SamplingCounts& other);
};

/// The lines that dense sampling finds: points along them, no curves.
struct SampledLines {
    std::vector<SampledPoint> points;  ///< inside the image, by rows of pixels
    SamplingCounts counts;
};

/// Finds the outline of a welded scene by looking (construction B of the design, section 5): a
/// second opinion on trace_truth. The two share the welded mesh, the camera, Embree, and what a
/// line is by definition (its class, the crease angle, the weld tolerance, the rounding of
/// vertices); no step that finds a line or decides whether it is seen.
///
/// 1. Which triangle is seen is asked once a pixel. Neighbours are joined if a walk over the mesh
///    between them, which may end in a triangle that the sample misses by 1e-3 px, meets no feature
///    edge.
/// 2. Every feature edge that no unbroken surface hides is looked at 1/1024 px to either side of
/// it,
///    each 3/8 px; what separates the two is named by what ends or bends there (edge_probes.h).
/// 3. Neighbours that are not joined, and samples beside and along visible edges that are not, must
///    be explained by lines found so far. Where they are not, there is a line that is no edge: the
///    way between them is halved down to 1/512 px, and the pixel is looked at K x K times, as are
///    those that a line enters from there.
///
/// A crossing on the K x K lattice of a line that runs at angle t to the axes stands for
/// (1/K) / (|cos t| + |sin t|) px of it: then the sum over a straight line is its length. A look
/// across an edge stands for the distance to the next.
///
/// The same for every thread count. An empty scene or image has no points.
[[nodiscard]] SampledLines sample_lines(const scene::Topology& topology,
                                        const scene::View& view,
                                        const SamplingOptions& options);

}  // namespace ink::crosscheck
