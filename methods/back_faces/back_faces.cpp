// Lander, "Under the Shade of the Rendering Tree", Game Developer, February 2000, as CoRgi tells
// it.

#include "methods/back_faces/back_faces.h"

#include "buffers/line_cost.h"

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
        // Lines pulled in front of what they touch: whole edges of neighbours show through.
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
                "Width of the wireframe's lines, to the nearest px; half of it is seen.")
        .number(&Params::units,
                "units",
                {-65536, 65536},
                "steps",
                "Polygon offset's units on the lines: below 0 pulls towards the eye.")
        .choice(&Params::edges,
                "edges",
                {"all", "polygons"},
                "Edges of all triangles, or without those inside a flat polygon.")
        .choice(&Params::depth_format,
                "depth_format",
                {"q32", "z24", "z16"},
                "Format of the depth buffer: float 1/w, or whole steps of window depth.")
        .number(&Params::threshold,
                "threshold",
                {1, 255},
                "",
                "Strength from which on a pixel is a line.");
    return table;
}

BackFaces::BackFaces(const Params& params)
    : params_(params), scene_(params.edges), filled_lines_(params.depth_format) {}

void BackFaces::draw(const method::Frame& frame, edge::EdgeImage& out) {
    skip_counts_ = {};
    out.fill(0);
    if (scene_.is_empty() || out.is_empty()) return;
    raster::MeshInput fills = scene_.mesh_input(frame);
    fills.cull = raster::Cull::back;
    raster::LineInput lines;
    lines.lines = scene_.lines_of_side(-1, frame);
    lines.width_px = params_.width_px;
    lines.offset = {0, params_.units};
    skip_counts_ = filled_lines_.draw(frame, scene_, fills, lines, out);
}

method::Cost BackFaces::cost() const {
    return buffers::filled_lines_cost(filled_lines_.format());
}

method::MethodInfo back_faces() {
    method::MethodInfo info = method::method_info<BackFaces>(
        "back_faces",
        "CoRgi, after Lander, Under the Shade of the Rendering Tree, Game Developer 2000",
        "back faces as thick wireframe, front faces filled over it; no adjacency");
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
