// Lander, "Under the Shade of the Rendering Tree", Game Developer, February 2000, as CoRgi tells
// it.

#include "methods/back_faces/back_faces.h"

namespace ink::methods {
namespace {

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        {{"width_px", "1"}, {"edges", "polygons"}, {"depth_format", "q32"}},
        {{"width_px", "1"}},
        // Float depth.
        {{"depth_format", "q32"}},
        {{"edges", "polygons"}},
        {},
        {{"depth_format", "z16"}},
        // Lines biased in front of what they touch: whole edges of neighbours show through.
        {{"units", "-4"}},
        {{"units", "-64"}},
        {{"units", "-64"}, {"depth_format", "z16"}},
        {{"width_px", "3"}},
        {{"width_px", "4"}},
        {{"width_px", "6"}},
    };
}

}  // namespace

core::ParamTable<BackFaces::Params> BackFaces::table() {
    core::ParamTable<Params> table;
    table
        .number(&Params::width_px,
                "width_px",
                {1, 16},
                "px",
                "Width of the wireframe's lines, to the nearest px; half of it is visible.")
        .number(&Params::units,
                "units",
                {-65536, 65536},
                "steps",
                "Polygon offset's units on the lines: below 0 moves towards the eye.")
        .choice(&Params::edges,
                "edges",
                {"all", "polygons"},
                "Edges of all triangles, or without those inside a flat polygon.")
        .choice(&Params::depth_format,
                "depth_format",
                {"q32", "z24", "z16"},
                "Format of the depth buffer: float 1/w, or whole steps of window depth.")
        .number(
            &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
    return table;
}

BackFaces::BackFaces(const Params& params)
    : buffers::FilledLinesMethod(params.edges, params.depth_format), params_(params) {}

void BackFaces::choose(const method::Frame& frame,
                       buffers::TriangleEdges& scene,
                       raster::MeshInput& fills,
                       raster::LineInput& lines) const {
    fills.cull = raster::Cull::back;
    lines.lines = scene.lines_of_side(-1, frame);
    lines.width_px = params_.width_px;
    lines.offset = {0, params_.units};
}

method::MethodInfo back_faces() {
    method::MethodInfo info = method::method_info<BackFaces>(
        "back_faces",
        "CoRgi, after Lander, Under the Shade of the Rendering Tree, Game Developer 2000",
        "back faces as thick wireframe, front faces filled over it; no adjacency");
    info.family = method::Family::edges_and_hulls;
    info.marker = method::Marker::up;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
