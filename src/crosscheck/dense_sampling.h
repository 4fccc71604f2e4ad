#pragma once

#include <cstddef>
#include <vector>

#include "scene/camera.h"
#include "scene/topology.h"
#include "truth/line_class.h"

namespace ink::crosscheck {

/// How the cross-check looks.
struct SamplingOptions {
    double crease_rad = 0.6981317007977318;  ///< 40 degrees
    bool material_seams = false;
    int subsamples = 8;       ///< K: a refined pixel is looked at K x K times
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
    std::size_t thin_px = 0;      ///< pixels in which K x K samples stepped over something
    std::size_t defects = 0;      ///< crossings of an end across which the surface goes on
    std::size_t near_cuts = 0;    ///< crossings of the near plane's cut: no line
    std::size_t unexplained = 0;  ///< two samples differ and nothing between them says why
};

/// The lines that dense sampling finds: points along them, no curves.
struct SampledLines {
    std::vector<SampledPoint> points;  ///< inside the image, by rows of pixels
    SamplingCounts counts;
};

/// Finds the outline of a welded scene by looking, not by following its edges (construction B of
/// the design, section 5): a second opinion on trace_truth. The two share the welded mesh, the
/// camera, Embree, and what a line is by definition (its class, the crease angle, the weld
/// tolerance); no step that finds a line or decides whether it is seen.
///
/// Which triangle is seen is asked once a pixel, and on a K x K grid in pixels where neighbouring
/// answers are not joined, where a feature edge that nothing hides may run, or which a line enters
/// from a refined neighbour. Neighbours are joined if a walk over the mesh between them, which may
/// end in a triangle that the sample misses by 1e-3 px, meets no feature edge. Any other pair is
/// halved down to 1/512 px, and what lies between is named by what ends or bends there. Pixels in
/// which a look 1/256 px to either side of an edge finds what the samples stepped over are looked
/// at 4 K x 4 K times; what is thinner than that, between two samples, is not seen.
///
/// A crossing of a line that runs at angle t to the axes stands for (1/K) / (|cos t| + |sin t|) px
/// of it: then the sum over a straight line is its length.
///
/// The same for every thread count. An empty scene or image has no points.
[[nodiscard]] SampledLines sample_lines(const scene::Topology& topology,
                                        const scene::View& view,
                                        const SamplingOptions& options);

}  // namespace ink::crosscheck
